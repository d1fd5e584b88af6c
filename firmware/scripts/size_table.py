#!/usr/bin/env -S python3 -B
"""What twiddle costs on each board: a Markdown table from the folders of firmware builds (`make firmware`).

The image is `control`: learner, controller and a toy hand. Flash is what is stored: code, constants, first values of
variables. RAM is static: variables, without the stack; on AVR with the constants, which GCC keeps there. Library is the
whole of both archives, used or not. Stacks are the worst, by stack_usage.py.
"""

import glob
import json
import os
import re
import sys

from disassembly import run
from stack_usage import StackUsage, Unbounded

STACKS = {
    "tick": "twd_controller_tick",
    "torque": "twd_controller_torque",
    "learn": "twd_learner_learn",
    "main": "main",
}


def memory(objdump, file):
    """(flash, RAM) in bytes of an image or of an archive's objects."""
    flash = ram = 0
    text = run(objdump, "-h", file)
    constants_in_ram = "file format elf32-avr" in text
    for name, size, flags in re.findall(r"^ *\d+ (\S+) +([0-9a-f]{8}) .*\n +(.*)$", text, re.MULTILINE):
        flags, size = flags.split(", "), int(size, 16)
        if "ALLOC" not in flags:
            continue
        if "LOAD" in flags:
            flash += size
        if "READONLY" not in flags or (constants_in_ram and name.startswith(".rodata")):
            ram += size
    return flash, ram


def stack(usage, function):
    try:
        return str(usage.of(function)[0])
    except Unbounded as reason:
        raise ValueError(f"the stack of {function} has no bound: {reason}") from None


def row(description):
    """The cells of the image that a file made by firmware/image.json.in describes."""
    with open(description, encoding="utf-8") as file:
        build = json.load(file)
    objdump = build["objdump"]
    flash, ram = memory(objdump, build["image"])
    parts = [memory(objdump, archive) for archive in build["archives"]]
    usage = StackUsage(objdump, build["frames"], build["image"])
    return [build["board"], build["core"], build["number"], build["optimisation"], str(flash), str(ram),
            str(sum(part[0] for part in parts)), str(sum(part[1] for part in parts)),
            *(stack(usage, function) for function in STACKS.values())]


def rows(folder):
    descriptions = sorted(glob.glob(os.path.join(folder, "bin", "control*.json")))
    if not descriptions:
        raise ValueError("holds no image control; expected the build folder of a firmware preset")
    return [row(description) for description in descriptions]


def print_table(table):
    widths = [max(map(len, column)) for column in zip(*table)]
    for line in [table[0], ["-" * width for width in widths], *table[1:]]:
        print("| " + " | ".join(cell.ljust(width) for cell, width in zip(line, widths)) + " |")


def main():
    if len(sys.argv) < 2:
        print("size_table: usage: size_table.py BUILD_FOLDER ..., of firmware presets", file=sys.stderr)
        return 2
    table = [["board", "core", "number", "built", "image flash", "image RAM", "library flash", "library RAM",
              *(f"{name} stack" for name in STACKS)]]
    try:
        for folder in sys.argv[1:]:
            table += rows(folder)
    except (OSError, ValueError) as error:
        print(f"size_table: {folder}: {error}", file=sys.stderr)
        return 1
    print_table(table)
    print("Bytes. Stacks are the deepest of a call: calls of others and C library included, interrupts not.")
    return 0


if __name__ == "__main__":
    sys.exit(main())
