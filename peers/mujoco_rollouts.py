"""Trials of the hand in MuJoCo: the desired angles of every control step in, rotations out."""

import mujoco
import numpy as np
from mujoco.batch import Batch
from mujoco.rollout import Rollout

from mujoco_hand import HINGE
from mujoco_state import controlled_joints


def replay(model, desired_rad, substeps):
    """One trial seen at the end of every control step: joint angles (control steps x joints) and rotations of the
    object about palm +z, in rad. `desired_rad` is control steps x joints."""
    data = mujoco.MjData(model)
    joints = controlled_joints(model)
    hinge = model.joint(HINGE).qposadr[0]
    positions_rad = np.empty((len(desired_rad), model.nq))
    for step, desired in enumerate(desired_rad):
        data.ctrl[:] = desired
        mujoco.mj_step(model, data, substeps)
        positions_rad[step] = data.qpos
    return positions_rad[:, joints], positions_rad[:, hinge]


class Trials:
    """All trials on one object, stepped by MuJoCo's own batch on one thread: one Python call a control step of all."""

    def __init__(self, model, desired_rad, substeps):
        """`desired_rad` is trials x control steps x joints."""
        self.desired_rad = np.ascontiguousarray(desired_rad.swapaxes(0, 1))
        self.substeps = substeps
        self.batch = Batch(model, nsim=desired_rad.shape[0], nthread=1)
        self.hinge = model.joint(HINGE).qposadr[0]

    def run(self):
        """Rotations about palm +z at the end of each trial, in rad."""
        self.batch.reset(stage=mujoco.mjtStage.mjSTAGE_NONE.value)
        angle_rad, desired_rad = self.batch.bind("qpos"), self.batch.bind("ctrl")
        for step in self.desired_rad:
            desired_rad[:] = step
            self.batch.step(nstep=self.substeps)
        return angle_rad[:, self.hinge].copy()

    def failures(self):
        """Number of trials with each kind of MuJoCo's warnings (a state that is no number is one of them)."""
        trials = np.count_nonzero(self.batch.warning[:, :, 1], axis=0)
        kinds = [name.removeprefix("mjWARN_").lower() for name in mujoco.mjtWarning.__members__ if "mjWARN_" in name]
        return {kind: int(count) for kind, count in zip(kinds, trials) if count}


class ParallelTrials:
    """The same trials by mujoco.rollout on several threads: one Python call for all. It is given desired angles for
    each time step, laid out once, and returns the state after each, in memory that is there already."""

    def __init__(self, model, desired_rad, substeps, threads):
        """`desired_rad` is trials x control steps x joints."""
        trials = desired_rad.shape[0]
        self.desired_rad = desired_rad
        self.models = [model] * trials
        self.data = [mujoco.MjData(model) for _ in range(threads)]
        self.control_rad = np.repeat(desired_rad, substeps, axis=1)
        spec = mujoco.mjtState.mjSTATE_FULLPHYSICS
        start = np.empty(mujoco.mj_stateSize(model, spec))
        mujoco.mj_getState(model, self.data[0], start, spec)
        self.start = np.tile(start, (trials, 1))
        steps = self.control_rad.shape[1]
        self.state = np.empty((trials, steps, start.size))
        self.sensors = np.empty((trials, steps, model.nsensordata))
        self.hinge = 1 + model.joint(HINGE).qposadr[0]  # behind the time
        self.pool = Rollout(nthread=threads)

    def run(self):
        """Rotations about palm +z at the end of each trial, in rad."""
        self.pool.rollout(
            self.models,
            self.data,
            self.start,
            self.control_rad,
            nstep=self.control_rad.shape[1],
            state=self.state,
            sensordata=self.sensors,
            skip_checks=True,
        )
        return self.state[:, -1, self.hinge].copy()
