"""Compares our simulation of the hand with MuJoCo's on the same objects and the same desired angles, in one run.

Prints a table and writes it as CSV. Run by `make bench-peers`, with ../peers on the path; README.md says how to read
it.
"""

import argparse
import csv
import json
import os
import statistics
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from dataclasses import asdict, dataclass, field
from pathlib import Path

import mujoco
import numpy as np

from mechanics_check import check_mechanics
from mujoco_hand import JOINTS, Options, mjcf
from mujoco_rollouts import ParallelTrials, Trials

OBJECTS = ("small-sphere", "medium-cylinder", "large-cube")
STEPS = 300  # control steps of a trial
STATES = 100  # of the hand, for the check of its mechanics
CORES = os.sched_getaffinity(0)
ONE_CORE = {max(CORES)}
CONVERGED_SUBSTEPS = 50  # of the reference, in which its rotations no longer change
SETUP = "paper-negated"  # of all speed figures


class Ours:
    """bench_rollouts, with the arguments that all its commands share."""

    def __init__(self, arguments):
        self.program = arguments.program
        self.shared = ["--setup", arguments.setup, "--seed", str(arguments.seed)]
        self.sets = arguments.sets

    def ask(self, command, *options, sets=None):
        """Lines of its answer, and lines of its complaints."""
        count = ["--sets", str(sets or self.sets)]
        line = [self.program, command, *self.shared, *count, *map(str, options)]
        done = subprocess.run(line, capture_output=True, text=True)
        if done.returncode != 0:
            raise RuntimeError(done.stderr.strip() or f"{self.program} {command} failed")
        return done.stdout.splitlines(), done.stderr.splitlines()

    def settings(self):
        return json.loads("\n".join(self.ask("settings")[0]))

    def mechanics(self):
        return np.loadtxt(self.ask("mechanics", sets=STATES)[0], delimiter=",", ndmin=2)

    def desired_rad(self, name):
        rows = np.loadtxt(self.ask("desired", "--object", name)[0], delimiter=",", skiprows=1)
        return rows.reshape(self.sets, STEPS, len(JOINTS))

    def rotations_rad(self, name, stepper, substeps):
        """In the counted direction, and the number of trials that failed."""
        lines, faults = self.ask("rotations", "--object", name, "--stepper", stepper, "--substeps", substeps)
        return np.array(lines[1:], dtype=float), len(faults)

    def control_steps_per_s(self, name, stepper, workers=1):
        return float(self.ask("time", "--object", name, "--stepper", stepper, "--workers", workers)[0][1])


@dataclass
class Row:
    """One object; rotations are means over all trials in the counted direction, r is with the converged reference."""

    object: str
    ours_steps_per_s: float = 0
    mujoco_steps_per_s: float = 0
    speed_ratio: float = 0
    ours_r: float = 0
    mujoco_r: float = 0
    mujoco_converged_r: float = 0
    reference_rad: float = 0
    ours_rad: float = 0
    mujoco_rad: float = 0
    mujoco_converged_rad: float = 0
    ours_failed: int = 0
    mujoco_failed: dict = field(default_factory=dict)
    # On as many cores as there are, by workers of ours and by mujoco.rollout.
    cores: int = 0
    ours_cores_steps_per_s: float = 0
    rollout_cores_steps_per_s: float = 0
    cores_speed_ratio: float = 0
    rollout_r: float = 0
    rollout_rad: float = 0


def correlation(a, b):
    return float(np.corrcoef(a, b)[0, 1])


def mujoco_model(arguments, settings, name, substeps):
    return mujoco.MjModel.from_xml_string(mjcf(arguments.models, name, settings, substeps))


def mujoco_trials(arguments, settings, name, desired_rad, substeps):
    return Trials(mujoco_model(arguments, settings, name, substeps), desired_rad, substeps)


def counted_rad(trials, settings):
    return settings["object"]["counted_direction"] * trials.run()


def mujoco_steps_per_s(trials):
    start = time.perf_counter()
    trials.run()
    return trials.desired_rad.shape[0] * trials.desired_rad.shape[1] / (time.perf_counter() - start)


def measure_accuracy(arguments, ours, settings, name, desired_rad):
    """The row's rotations and correlations. What is slow here runs beside the other objects'."""
    substeps = settings["physics"]["substeps"]
    reference, _ = ours.rotations_rad(name, "reference", CONVERGED_SUBSTEPS)
    own, own_failed = ours.rotations_rad(name, arguments.stepper, substeps)
    timed = mujoco_trials(arguments, settings, name, desired_rad, substeps)
    timed_rad = counted_rad(timed, settings)
    parallel = ParallelTrials(mujoco_model(arguments, settings, name, substeps), desired_rad, substeps, len(CORES))
    parallel_rad = counted_rad(parallel, settings)
    converged_rad = counted_rad(mujoco_trials(arguments, settings, name, desired_rad, CONVERGED_SUBSTEPS), settings)
    return Row(
        object=name,
        ours_r=correlation(own, reference),
        mujoco_r=correlation(timed_rad, reference),
        mujoco_converged_r=correlation(converged_rad, reference),
        reference_rad=reference.mean(),
        ours_rad=own.mean(),
        mujoco_rad=timed_rad.mean(),
        mujoco_converged_rad=converged_rad.mean(),
        ours_failed=own_failed,
        mujoco_failed=timed.failures(),
        rollout_r=correlation(parallel_rad, reference),
        rollout_rad=parallel_rad.mean(),
    )


def pin(cores):
    """This thread, and the threads and processes that it starts from now on."""
    os.sched_setaffinity(0, cores)


def measure_speed(arguments, ours, settings, row, desired_rad):
    """All of it in turn, so that a change of the machine's speed meets all; medians. One core first, then all."""
    substeps = settings["physics"]["substeps"]
    pin(ONE_CORE)
    trials = mujoco_trials(arguments, settings, row.object, desired_rad, substeps)
    pin(CORES)
    model = mujoco_model(arguments, settings, row.object, substeps)
    parallel = ParallelTrials(model, desired_rad, substeps, len(CORES))
    timings = {
        "ours_steps_per_s": (ONE_CORE, lambda: ours.control_steps_per_s(row.object, arguments.stepper)),
        "mujoco_steps_per_s": (ONE_CORE, lambda: mujoco_steps_per_s(trials)),
        "ours_cores_steps_per_s": (CORES, lambda: ours.control_steps_per_s(row.object, arguments.stepper, len(CORES))),
        "rollout_cores_steps_per_s": (CORES, lambda: mujoco_steps_per_s(parallel)),
    }
    for _, time_it in timings.values():
        time_it()  # warms caches and clocks
    measured = {name: [] for name in timings}
    for _ in range(arguments.repeats):
        for name, (cores, time_it) in timings.items():
            pin(cores)
            measured[name].append(time_it())
    for name, values in measured.items():
        setattr(row, name, statistics.median(values))
    row.cores = len(CORES)
    row.speed_ratio = row.ours_steps_per_s / row.mujoco_steps_per_s
    row.cores_speed_ratio = row.ours_cores_steps_per_s / row.rollout_cores_steps_per_s


def measure(arguments):
    ours = Ours(arguments)
    settings = ours.settings()
    check_mechanics(mjcf(arguments.models, OBJECTS[0], settings, 1), ours.mechanics())
    desired_rad = {name: ours.desired_rad(name) for name in OBJECTS}
    with ThreadPoolExecutor(len(CORES)) as pool:
        accuracy = lambda name: measure_accuracy(arguments, ours, settings, name, desired_rad[name])
        rows = list(pool.map(accuracy, OBJECTS))
    for row in rows:
        measure_speed(arguments, ours, settings, row, desired_rad[row.object])
    return settings, rows


# --- what comes out ---


def failures_text(failed):
    return " ".join(f"{kind}:{count}" for kind, count in failed.items()) or "0"


def header(arguments, settings):
    substeps = settings["physics"]["substeps"]
    options = ", ".join(f"{name} {value}" for name, value in asdict(Options()).items())
    setup = Path(arguments.setup).name.removesuffix(".toml")
    return [
        f"set-up {setup}, {arguments.sets} random CPG-C parameter vectors (seed {arguments.seed}), "
        f"{STEPS} control steps each, {substeps} substeps; medians of {arguments.repeats} alternating repeats",
        f"ours: stepper {arguments.stepper}; r is the correlation of the trials' rotations with the reference stepper "
        f"at {CONVERGED_SUBSTEPS} substeps",
        f"MuJoCo {mujoco.__version__}: {options}; stepped by mujoco.batch on one thread, and "
        f"by mujoco.rollout on {len(CORES)}, beside as many workers of ours",
        f"the hand's mechanics agree with Bullet's in {STATES} random states (tips 1e-6 m, the rest 1e-6 relative)",
    ]


def speed_cells(ours_steps_per_s, theirs_steps_per_s, ratio):
    return [f"{ours_steps_per_s / 1e3:.1f}", f"{theirs_steps_per_s / 1e3:.1f}", f"{ratio:.1f}"]


def print_table(settings, rows):
    substeps = settings["physics"]["substeps"]
    titles = [
        "object",
        "ours, k steps/s",
        "MuJoCo, k steps/s",
        "ratio",
        f"r ours@{substeps}",
        f"r MuJoCo@{substeps}",
        f"r MuJoCo@{CONVERGED_SUBSTEPS}",
        "mean rotation, rad: reference",
        f"ours@{substeps}",
        f"MuJoCo@{substeps}",
        f"MuJoCo@{CONVERGED_SUBSTEPS}",
        "failed trials, ours",
        "MuJoCo",
        f"{len(CORES)} cores: ours, k steps/s",
        "mujoco.rollout, k steps/s",
        "ratio",
        "r mujoco.rollout",
        "mean rotation, rad",
    ]
    lines = [titles, ["---"] * len(titles)]
    for row in rows:
        speeds = speed_cells(row.ours_steps_per_s, row.mujoco_steps_per_s, row.speed_ratio)
        likeness = [f"{r:.4f}" for r in (row.ours_r, row.mujoco_r, row.mujoco_converged_r)]
        means_rad = (row.reference_rad, row.ours_rad, row.mujoco_rad, row.mujoco_converged_rad)
        failed = [str(row.ours_failed), failures_text(row.mujoco_failed)]
        parallel = speed_cells(row.ours_cores_steps_per_s, row.rollout_cores_steps_per_s, row.cores_speed_ratio)
        parallel += [f"{row.rollout_r:.4f}", f"{row.rollout_rad:.3f}"]
        lines.append([row.object, *speeds, *likeness, *(f"{mean:.3f}" for mean in means_rad), *failed, *parallel])
    for line in lines:
        print("| " + " | ".join(line) + " |")


def write_csv(path, comments, rows):
    Path(path).parent.mkdir(parents=True, exist_ok=True)
    with open(path, "w", newline="") as file:
        file.writelines(f"# {comment}\n" for comment in comments)
        writer = csv.DictWriter(file, list(asdict(rows[0])), lineterminator="\n")
        writer.writeheader()
        for row in rows:
            writer.writerow({**asdict(row), "mujoco_failed": failures_text(row.mujoco_failed)})


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", required=True, help="bench_rollouts")
    parser.add_argument("--models", required=True, help="the folder models/")
    parser.add_argument("--out", required=True, help="the CSV to write")
    parser.add_argument("--setup", default=SETUP, help=f"a name or a .toml file; {SETUP} if not given")
    parser.add_argument("--stepper", default="fast", help="ours, against MuJoCo")
    parser.add_argument("--sets", type=int, default=200, help="parameter vectors")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--repeats", type=int, default=5, help="of every timing")
    return parser.parse_args()


def main():
    arguments = parse_arguments()
    try:
        settings, rows = measure(arguments)
    except (RuntimeError, ValueError, OSError) as error:
        sys.exit(f"bench-peers: {error}")
    comments = header(arguments, settings)
    print("\n".join(comments) + "\n")
    print_table(settings, rows)
    write_csv(arguments.out, comments, rows)
    print(f"\n{arguments.out}")


if __name__ == "__main__":
    main()
