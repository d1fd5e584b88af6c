"""What is asked of a MuJoCo model of the hand in more than one place."""

import mujoco
import numpy as np

from mujoco_hand import JOINTS


def controlled_joints(model):
    """Where the four joints stand among the model's positions and velocities; every joint has one of each."""
    return [model.joint(name).dofadr[0] for name in JOINTS.values()]


def mass_matrix(model, data, joints):
    """Of `joints` while all others are held, kg m2."""
    full = np.zeros((model.nv, model.nv))
    mujoco.mj_fullM(model, data, full)
    return full[np.ix_(joints, joints)]
