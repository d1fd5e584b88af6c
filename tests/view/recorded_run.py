"""What a run folder says of its replay, read without the program that drew it."""

import csv
import math


class RecordedRun:
    """trajectory.csv: the facts of its comments, and a row of numbers a step."""

    def __init__(self, folder):
        with open(folder / "trajectory.csv", encoding="utf-8") as file:
            lines = file.readlines()
        comments = [line[2:].split(": ", 1) for line in lines if line.startswith("# ") and ": " in line]
        self.facts = {name: value.strip() for name, value in comments}
        table = csv.DictReader(line for line in lines if not line.startswith("#"))
        self.rows = [{name: float(value) for name, value in row.items()} for row in table]

    def row(self, step):
        """Of the step 1, 2, ..."""
        found = self.rows[step - 1]
        assert found["step"] == step
        return found

    def tip_m(self, step, finger):
        """The centre of `finger`'s tip in the palm frame."""
        return [self.row(step)[f"{finger}_{axis}_m"] for axis in "xyz"]

    def object_m(self):
        """The centre of the object in the palm frame."""
        return [float(self.facts[name]) for name in ("object_hinge_x_m", "object_hinge_y_m", "object_centre_z_m")]

    def sphere_m(self):
        """Points all over a spherical object, of its radius times 1."""
        radius = float(self.facts["object_size_m"])
        return [[centre + radius * part for centre, part in zip(self.object_m(), direction)]
                for direction in _directions(400)]


def _directions(count):
    """Unit vectors, spread evenly (a Fibonacci lattice)."""
    for i in range(count):
        height = 1 - (2 * i + 1) / count
        turn = i * math.pi * (3 - math.sqrt(5))
        radius = math.sqrt(1 - height * height)
        yield radius * math.cos(turn), radius * math.sin(turn), height
