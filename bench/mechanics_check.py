"""Holds the MuJoCo model of the hand against Bullet's: fingertips, mass matrix and accelerations in random states."""

import mujoco
import numpy as np

from mujoco_hand import FINGERS
from mujoco_state import controlled_joints, mass_matrix

TIP_TOLERANCE_M = 1e-6
RELATIVE_TOLERANCE = 1e-6


def split(rows):
    """The columns that `bench_rollouts mechanics` prints."""
    names = ("angle", "velocity", "index_tip", "thumb_tip", "acceleration", "inverse_mass")
    return dict(zip(names, np.split(rows, np.cumsum((4, 4, 3, 3, 4)), axis=1)))


class Mechanics:
    """MuJoCo's hand alone: no contacts, stops, actuators or gravity compensation."""

    def __init__(self, text):
        self.model = mujoco.MjModel.from_xml_string(text)
        disable = mujoco.mjtDisableBit
        self.model.opt.disableflags |= disable.mjDSBL_CONSTRAINT | disable.mjDSBL_ACTUATION
        self.model.body_gravcomp[:] = 0
        self.data = mujoco.MjData(self.model)
        self.joints = controlled_joints(self.model)

    def set_state(self, angle_rad, velocity_rad_s):
        self.data.qpos[self.joints] = angle_rad
        self.data.qvel[self.joints] = velocity_rad_s
        mujoco.mj_forward(self.model, self.data)

    def tip_m(self, finger):
        return self.data.site(f"{finger}_tip").xpos

    def acceleration_rad_s2(self):
        return self.data.qacc_smooth[self.joints]

    def mass(self):
        return mass_matrix(self.model, self.data, self.joints)


def difference(ours, theirs):
    """Largest difference, relative to the largest of ours."""
    return np.abs(ours - theirs).max() / np.abs(ours).max()


def check_mechanics(text, rows):
    """Raises ValueError with one sentence if the model of MJCF `text` and Bullet's differ. `rows` are Bullet's."""
    ours, theirs = split(rows), Mechanics(text)
    for i in range(len(rows)):
        theirs.set_state(ours["angle"][i], ours["velocity"][i])
        state = f"at joint angles {np.round(ours['angle'][i], 3)} rad"
        for finger in FINGERS:
            off_m = np.abs(ours[f"{finger}_tip"][i] - theirs.tip_m(finger)).max()
            if not off_m <= TIP_TOLERANCE_M:
                raise ValueError(f"MuJoCo's {finger} fingertip is {off_m:.2g} m away from Bullet's {state}")
        off = difference(np.linalg.inv(ours["inverse_mass"][i].reshape(4, 4)), theirs.mass())
        if not off <= RELATIVE_TOLERANCE:
            raise ValueError(f"MuJoCo's mass matrix differs from Bullet's by {off:.2g} of its largest entry {state}")
        off = difference(ours["acceleration"][i], theirs.acceleration_rad_s2())
        if not off <= RELATIVE_TOLERANCE:
            raise ValueError(f"MuJoCo's free acceleration differs from Bullet's by {off:.2g} of the largest {state}")
