"""Policies that the judge trains, and what our program does with them."""

import csv
import json
import shutil
import subprocess
import tempfile
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from mujoco_hand import JOINTS

OBJECTS = [f"{size}-{shape}" for shape in ("sphere", "cylinder", "cube") for size in ("small", "medium", "large")]
MODELS = ("cpg-c", "cpg-h")
TRIALS = 300


@dataclass(frozen=True)
class Policy:
    """A training run that names itself."""

    object: str
    model: str
    seed: int

    def __str__(self):
        return f"{self.object} {self.model} seed {self.seed}"


# Every object with both models, and one of them with another seed: 20, chosen before any was seen.
POLICIES = [Policy(name, model, 1) for name in OBJECTS for model in MODELS]
POLICIES += [Policy(OBJECTS[0], model, 2) for model in MODELS]


@dataclass(frozen=True)
class Trial:
    """What trajectory.csv says of the end of every control step; rotations are in the counted direction."""

    desired_rad: np.ndarray  # control steps x joints
    actual_rad: np.ndarray
    rotation_rad: np.ndarray  # control steps
    contact_n: np.ndarray  # control steps x fingers


def read_trajectory(path):
    with open(path) as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    read = lambda names: np.array([[float(row[name]) for name in names] for row in rows])
    return Trial(
        desired_rad=read([f"desired_{joint}_rad" for joint in JOINTS]),
        actual_rad=read([f"actual_{joint}_rad" for joint in JOINTS]),
        rotation_rad=read(["object_rad"])[:, 0],
        contact_n=read(["index_contact_n", "thumb_contact_n"]),
    )


class Runs:
    """Folders of runs below `folder`, written by our program."""

    def __init__(self, program, folder):
        self.program = program
        self.folder = Path(folder)

    def ask(self, *arguments):
        done = subprocess.run([self.program, *map(str, arguments)], capture_output=True, text=True)
        if done.returncode != 0:
            raise RuntimeError(done.stderr.strip() or f"{self.program} {arguments[0]} failed")

    def train(self, policy):
        """The folder of the finished run, with the default set-up."""
        run = self.folder / policy.object / policy.model / str(policy.seed)
        which = ("--object", policy.object, "--model", policy.model, "--seed", policy.seed)
        self.ask("train", *which, "--trials", TRIALS, "--out", run)
        return run

    def replay(self, run):
        """The trial of the learned policy."""
        self.ask("replay", run)
        return read_trajectory(run / "trajectory.csv")

    def copy_with(self, run, changes):
        """A copy of the run with other settings, `changes` by "section.key": what was learned stays."""
        copy = Path(tempfile.mkdtemp(dir=self.folder)) / "run"
        shutil.copytree(run, copy)
        document = json.loads((copy / "run.json").read_text())
        for name, value in changes.items():
            section, key = name.split(".")
            document["settings"][section][key] = value
        (copy / "run.json").write_text(json.dumps(document))
        return copy


def settings_of(run):
    return json.loads((run / "run.json").read_text())["settings"]
