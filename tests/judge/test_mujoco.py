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
LEAST_CORRELATION_OF_LIKES = 0.99

# Where no finger reaches the object: the furthest place that the settings allow.
ROUNDING_RAD = 1e-12  # MuJoCo places the centre of mass on the hinge with a rounding, and gravity turns it by 1e-33 rad
OUT_OF_REACH_M = 0.2
# Where the two models of contact hardly differ. MuJoCo's law of friction is convex, at the price that a sliding contact
# separates at friction x slip speed; and its cubes and cylinders have sharp edges.
LIKE_MUJOCO = {"contact.friction": 0.05, "object.rounding_m": 1e-4}

# As ours: semi-implicit Euler steps with a PD law that is evaluated at their start, its damping included.
LIKE_OURS = Options(integrator="Euler", flags={"island": "disable", "eulerdamp": "disable"})
CONVERGED_SUBSTEPS = 50
# An integrator of another kind and order, whose error is far below ours.
RUNGE_KUTTA = Options(integrator="RK4")
RUNGE_KUTTA_SUBSTEPS = 10
FINE_SUBSTEPS = 100  # of ours


def correlation(a, b):
    return float(np.corrcoef(a, b)[0, 1])


def ranks(a):
    return np.argsort(np.argsort(a))


def likeness(ours_rad, theirs_rad):
    off_rad = np.sqrt(np.mean(np.square(ours_rad - theirs_rad)))
    means = f"means {np.mean(ours_rad):.2f} and {np.mean(theirs_rad):.2f} rad"
    return f"r {correlation(ours_rad, theirs_rad):.4f}, {means}, root mean square difference {off_rad:.2f} rad"


class MuJoCo(unittest.TestCase):
    """Trains all policies once."""

    @classmethod
    def setUpClass(cls):
        cls.models = os.environ["TWIDDLE_MODELS"]
        cls.scratch = tempfile.TemporaryDirectory(prefix="twiddle-judge-")
        cls.addClassCleanup(cls.scratch.cleanup)
        cls.ours = Runs(os.environ["TWIDDLE_PROGRAM"], cls.scratch.name)
        cls.runs = {policy: cls.ours.train(policy) for policy in POLICIES}

    def default_substeps(self):
        return settings_of(self.runs[POLICIES[0]])["physics"]["substeps"]

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
        changes = {"object.hinge_x_m": OUT_OF_REACH_M, "physics.substeps": substeps}
        run = self.ours.copy_with(self.runs[policy], changes)
        trial = self.ours.replay(run)
        theirs_rad, rotation_rad = self.in_mujoco(policy, run, trial.desired_rad, their_substeps, options)
        self.assertFalse(trial.contact_n.any() or trial.rotation_rad.any(), f"{policy}: a contact")
        self.assertLess(np.abs(rotation_rad).max(), ROUNDING_RAD, f"{policy}: a contact")
        self.assertGreater(np.ptp(trial.actual_rad, axis=0).max(), 0.1, f"{policy}: the hand hardly moves")
        return np.abs(trial.actual_rad - theirs_rad).max()

    def worst_path_rad(self, substeps, their_substeps, options):
        """Largest difference over all policies, and prints whose it is."""
        off_rad = {policy: self.path_difference_rad(policy, substeps, their_substeps, options) for policy in POLICIES}
        worst = max(off_rad, key=off_rad.get)
        print(
            f"\njoint paths without contact, ours at {substeps} substeps, MuJoCo's {options.integrator} at "
            f"{their_substeps}: largest difference {off_rad[worst]:.1e} rad ({worst})"
        )
        return off_rad[worst]

    def test_joint_paths_without_contact_agree_at_the_same_substeps(self):
        substeps = self.default_substeps()
        self.assertLessEqual(self.worst_path_rad(substeps, substeps, LIKE_OURS), PATH_TOLERANCE_RAD)

    def test_joint_paths_without_contact_come_close_to_an_integrator_of_higher_order(self):
        coarse_rad = self.worst_path_rad(self.default_substeps(), RUNGE_KUTTA_SUBSTEPS, RUNGE_KUTTA)
        fine_rad = self.worst_path_rad(FINE_SUBSTEPS, RUNGE_KUTTA_SUBSTEPS, RUNGE_KUTTA)
        self.assertLessEqual(fine_rad, PATH_TOLERANCE_RAD)
        self.assertLess(fine_rad, coarse_rad)

    def rotations_rad(self, runs):
        """Ours and MuJoCo's at the end of the trial of each policy in its run of `runs`."""
        pairs = []
        for policy, run in runs.items():
            trial = self.ours.replay(run)
            _, rotation_rad = self.in_mujoco(policy, run, trial.desired_rad, CONVERGED_SUBSTEPS, LIKE_OURS)
            pairs.append((trial.rotation_rad[-1], rotation_rad[-1]))
        return np.array(pairs).T

    def test_rotations_correlate(self):
        ours_rad, theirs_rad = self.rotations_rad(self.runs)
        print(f"\n| policy | ours (rad) | MuJoCo, {CONVERGED_SUBSTEPS} substeps (rad) |\n| --- | --- | --- |")
        for policy, ours, theirs in zip(self.runs, ours_rad, theirs_rad):
            print(f"| {policy} | {ours:.2f} | {theirs:.2f} |")
        print(f"{likeness(ours_rad, theirs_rad)}, of ranks r {correlation(ranks(ours_rad), ranks(theirs_rad)):.4f}")
        self.assertGreaterEqual(correlation(ours_rad, theirs_rad), LEAST_CORRELATION)

    def test_rotations_correlate_more_where_the_models_of_contact_are_alike(self):
        alike = {policy: self.ours.copy_with(run, LIKE_MUJOCO) for policy, run in self.runs.items()}
        ours_rad, theirs_rad = self.rotations_rad(alike)
        print(f"\n{LIKE_MUJOCO}: {likeness(ours_rad, theirs_rad)}")
        self.assertGreaterEqual(correlation(ours_rad, theirs_rad), LEAST_CORRELATION_OF_LIKES)


if __name__ == "__main__":
    unittest.main()
