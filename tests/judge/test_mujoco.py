"""The same policies, PD law, hand and objects in our simulation and in MuJoCo."""

import os
import tempfile
import unittest
from pathlib import Path

import mujoco
import numpy as np

from mujoco_hand import FINGERS, JOINTS, Options, mjcf
from mujoco_rollouts import replay
from mujoco_state import controlled_joints, mass_matrix
from policies import POLICIES, Runs, settings_of
from urdf_hand import UrdfHand

PATH_TOLERANCE_RAD = 1e-3
LEAST_CORRELATION = 0.9

# As ours: semi-implicit Euler steps with a PD law that is evaluated at their start, its damping included.
LIKE_OURS = Options(integrator="Euler", flags={"island": "disable", "eulerdamp": "disable"})
CONVERGED_SUBSTEPS = 50
# An integrator of another kind and order, whose error is far below ours.
RUNGE_KUTTA = Options(integrator="RK4")
RUNGE_KUTTA_SUBSTEPS = 20
FINE_SUBSTEPS = 100  # of ours


def correlation(a, b):
    return float(np.corrcoef(a, b)[0, 1])


def ranks(a):
    return np.argsort(np.argsort(a))


def root_mean_square(a):
    return float(np.sqrt(np.mean(np.square(a))))


class MuJoCo(unittest.TestCase):
    """Trains all policies once."""

    @classmethod
    def setUpClass(cls):
        cls.models = os.environ["TWIDDLE_MODELS"]
        cls.scratch = tempfile.TemporaryDirectory(prefix="twiddle-judge-")
        cls.addClassCleanup(cls.scratch.cleanup)
        cls.ours = Runs(os.environ["TWIDDLE_PROGRAM"], cls.scratch.name)
        cls.runs = {policy: cls.ours.train(policy) for policy in POLICIES}

    def in_mujoco(self, policy, run, desired_rad, substeps, options):
        """Joint angles and rotations in the counted direction, both at the end of every control step."""
        settings = settings_of(run)
        model = mujoco.MjModel.from_xml_string(mjcf(self.models, policy.object, settings, substeps, options))
        actual_rad, rotation_rad = replay(model, desired_rad, substeps)
        return actual_rad, settings["object"]["counted_direction"] * rotation_rad

    def test_hand_is_what_mujoco_itself_reads_from_the_urdf(self):
        policy = POLICIES[0]
        settings = settings_of(self.runs[policy])
        settings["hand"] |= {"index_distal_deg": 20, "thumb_distal_deg": 10}  # any that are not 0
        model = mujoco.MjModel.from_xml_string(mjcf(self.models, policy.object, settings, 1))
        data = mujoco.MjData(model)
        joints = controlled_joints(model)
        urdf = UrdfHand(Path(self.models) / "icub_right_hand.urdf", settings["hand"])
        for angle_rad in np.random.default_rng(1).uniform(*model.jnt_range[joints].T, (20, len(JOINTS))):
            data.qpos[joints] = angle_rad
            mujoco.mj_forward(model, data)
            urdf.set_angles(angle_rad)
            for finger in FINGERS:
                np.testing.assert_allclose(data.site(f"{finger}_tip").xpos, urdf.tip_m(finger), rtol=0, atol=1e-9)
            mass = mass_matrix(model, data, joints) - np.diag(model.dof_armature[joints])
            np.testing.assert_allclose(mass, urdf.mass(), rtol=0, atol=1e-9 * urdf.mass().max())

    def path_difference_rad(self, policy, substeps, their_substeps, options):
        """Largest of all joints in a trial without contact."""
        run = self.ours.out_of_reach(self.runs[policy], substeps)
        trial = self.ours.replay(run)
        theirs_rad, rotation_rad = self.in_mujoco(policy, run, trial.desired_rad, their_substeps, options)
        self.assertFalse(trial.contact_n.any() or trial.rotation_rad.any() or rotation_rad.any(), f"{policy}: a contact")
        self.assertGreater(np.ptp(trial.actual_rad, axis=0).max(), 0.1, f"{policy}: the hand hardly moves")
        return np.abs(trial.actual_rad - theirs_rad).max()

    def assert_paths_agree(self, what, substeps, their_substeps, options):
        off_rad = {policy: self.path_difference_rad(policy, substeps, their_substeps, options) for policy in POLICIES}
        worst = max(off_rad, key=off_rad.get)
        print(f"\njoint paths without contact, {what}: largest difference {off_rad[worst]:.1e} rad ({worst})")
        self.assertLessEqual(off_rad[worst], PATH_TOLERANCE_RAD, str(worst))

    def test_joint_paths_without_contact_agree_at_the_same_substeps(self):
        substeps = settings_of(self.runs[POLICIES[0]])["physics"]["substeps"]
        what = f"{substeps} substeps, Euler in both"
        self.assert_paths_agree(what, substeps, substeps, LIKE_OURS)

    def test_joint_paths_without_contact_agree_with_an_integrator_of_higher_order(self):
        what = f"ours at {FINE_SUBSTEPS} substeps, MuJoCo's Runge-Kutta at {RUNGE_KUTTA_SUBSTEPS}"
        self.assert_paths_agree(what, FINE_SUBSTEPS, RUNGE_KUTTA_SUBSTEPS, RUNGE_KUTTA)

    def test_rotations_correlate(self):
        ours_rad, theirs_rad = [], []
        print(f"\n| policy | ours (rad) | MuJoCo's, {CONVERGED_SUBSTEPS} substeps (rad) |\n| --- | --- | --- |")
        for policy, run in self.runs.items():
            trial = self.ours.replay(run)
            _, rotation_rad = self.in_mujoco(policy, run, trial.desired_rad, CONVERGED_SUBSTEPS, LIKE_OURS)
            ours_rad.append(trial.rotation_rad[-1])
            theirs_rad.append(rotation_rad[-1])
            print(f"| {policy} | {ours_rad[-1]:.2f} | {theirs_rad[-1]:.2f} |")
        r = correlation(ours_rad, theirs_rad)
        print(
            f"r {r:.4f}, of ranks {correlation(ranks(ours_rad), ranks(theirs_rad)):.4f}, "
            f"root mean square difference {root_mean_square(np.subtract(ours_rad, theirs_rad)):.2f} rad, "
            f"means {np.mean(ours_rad):.2f} and {np.mean(theirs_rad):.2f} rad"
        )
        self.assertGreaterEqual(r, LEAST_CORRELATION)


if __name__ == "__main__":
    unittest.main()
