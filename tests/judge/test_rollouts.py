"""Three ways to have MuJoCo do the same trials: step by step, in a batch, and in one call on several threads."""

import os
import tempfile
import unittest

import mujoco
import numpy as np

from mujoco_hand import mjcf
from mujoco_rollouts import ParallelTrials, Trials, replay
from policies import POLICIES, Runs, settings_of

SUBSTEPS = 5
THREADS = 2


class Rollouts(unittest.TestCase):
    def test_all_ways_give_the_same_rotations(self):
        with tempfile.TemporaryDirectory(prefix="twiddle-rollouts-") as folder:
            ours = Runs(os.environ["TWIDDLE_PROGRAM"], folder)
            run = ours.train(POLICIES[0])
            settings, learned_rad = settings_of(run), ours.replay(run).desired_rad
        text = mjcf(os.environ["TWIDDLE_MODELS"], POLICIES[0].object, settings, SUBSTEPS)
        model = mujoco.MjModel.from_xml_string(text)
        # The learned motion, the same held back by a second, and half of it: three trials for two threads.
        desired_rad = np.stack([learned_rad, np.roll(learned_rad, 100, axis=0), 0.5 * learned_rad])
        one_by_one_rad = np.array([replay(model, trial, SUBSTEPS)[1][-1] for trial in desired_rad])
        self.assertGreater(np.ptp(one_by_one_rad), 0.1, "the trials hardly differ")
        for trials in (Trials(model, desired_rad, SUBSTEPS), ParallelTrials(model, desired_rad, SUBSTEPS, THREADS)):
            for repeat in range(2):  # the second starts from where the first did
                with self.subTest(way=type(trials).__name__, repeat=repeat):
                    np.testing.assert_array_equal(trials.run(), one_by_one_rad)


if __name__ == "__main__":
    unittest.main()
