#!/usr/bin/env -S python3 -B
"""Worst stack of functions of a firmware image, in bytes.

What a function needs for itself is the compiler's word (-fstack-usage, .su files) or, for functions that came without
one (the C library's and libgcc's), what it pushes on its way through its disassembly. Who calls whom is read from the
disassembly of the linked image. A stack that has no bound is printed as `unknown`, with the reason: recursion, a call
through a pointer, a frame of variable size. Interrupts come on top, wherever they strike.
"""

import argparse
import json
import os
import re
import sys

from disassembly import Code
from instructions import BRANCH, CALL, CALL_BY_POINTER, JUMP, JUMP_BY_POINTER, RETURN, SKIP, TABLE_JUMP
from symbol_names import source_name

# AVR's switches jump to this function, which jumps by the table back into them.
TABLE_HELPER = re.compile(r"__tablejump2?__$")

# More than any board's RAM of this kind: only a loop that pushes comes here.
ENDLESS = 1 << 16


def plain(name):
    """A function's name without the number of a compiler's clone, which .su files leave out."""
    return re.sub(r"\.\d+", "", name)


def read_frames(folders):
    """{name or (source, name): (bytes, kind)} from all .su files below `folders`; of equal names the largest."""
    frames = {}
    for folder in folders:
        files = [os.path.join(at, name) for at, _, names in os.walk(folder) for name in names if name.endswith(".su")]
        if not files:
            raise ValueError(f"{folder} holds no .su files; expected the objects of a build with -fstack-usage")
        for file in files:
            with open(file, encoding="utf-8") as lines:
                for line in lines:
                    place, size, kind = line.rstrip("\n").split("\t")
                    source, _, _, name = place.rsplit(":", 3)
                    for key in (plain(name), (os.path.basename(source), plain(name))):
                        frames[key] = max(frames.get(key, (0, "")), (int(size), kind))
    return frames


class Unbounded(Exception):
    """Why a stack has no bound."""


class StackUsage:
    """Worst stacks of an image's functions; each is looked at once."""

    def __init__(self, objdump, folders, image):
        self.code = Code(objdump, image)
        self.base = self.code.instruction_set.return_address
        self.addresses = {name: address for address, symbols in self.code.symbols.items() for _, name in symbols}
        for name, address in list(self.addresses.items()):
            self.addresses.setdefault(source_name(name), address)
        self.frames = self.frames_by_address(read_frames(folders))
        self.worst = {}  # address -> (bytes, names along the worst path)

    def frames_by_address(self, frames):
        """{address: (bytes, kind)} of the functions that have the compiler's word."""
        known = {}
        for address, symbols in self.code.symbols.items():
            for source, name in symbols:
                # A source that another one includes has its own name in the .su file, but not in the symbols.
                frame = (source and frames.get((source, plain(name)))) or frames.get(plain(name))
                if frame:
                    known[address] = frame
        return known

    def of(self, function):
        """(bytes, names along the worst path) of a function by its symbol or source name; raises Unbounded."""
        if function not in self.addresses:
            raise ValueError(f"the image has no function {function}")
        return self.from_address(self.addresses[function], ())

    def from_address(self, entry, callers):
        if entry in callers:
            raise Unbounded(f"{self.code.name(entry)} calls itself, directly or through others")
        if entry not in self.worst:
            frame, callees = self.walk(entry)
            worst = frame, [self.code.name(entry)]
            for callee, below in callees.items():
                size, path = self.from_address(callee, callers + (entry,))
                worst = max(worst, (below + size, worst[1][:1] + path), key=lambda found: found[0])
            self.worst[entry] = worst
        return self.worst[entry]

    def walk(self, entry):
        """The own frame of the code that begins at `entry`, and {callee: bytes on the stack below it}.

        A function with the compiler's word is one symbol; assembly may run or jump from one symbol into another."""
        start = self.code.start(entry)
        compiled, kind = self.frames.get(start, (None, None))
        if kind == "dynamic":
            raise Unbounded(f"{self.code.name(entry)} has a frame of variable size")
        frame, callees = compiled or 0, {}
        depths, ways = {}, [(entry, self.base)]
        while ways:
            address, depth = ways.pop()
            if address not in self.code.instructions or depths.get(address, -1) >= depth:
                continue
            symbol = self.code.start(address)
            own = symbol == start if compiled is not None else symbol not in self.frames
            if not own:  # a tail call, where nothing of the own frame is left
                below = 0 if depth == self.base else max(depth, compiled or 0)
                callees[address] = max(callees.get(address, 0), below)
                continue
            depths[address] = depth
            instruction = self.code.instructions[address]
            depth = self.pushed(address, depth, instruction, compiled)
            frame = max(frame, depth)
            if instruction.kind == CALL:
                callees[instruction.target] = max(callees.get(instruction.target, 0), depth, compiled or 0)
            if self.jumps_by_table(instruction):  # to any place of the function
                ways += [(place, depth) for place in self.code.symbol_of(address) if place not in depths]
            ways += [(place, depth) for place in self.following(instruction, start if compiled is not None else None)]
        return frame, callees

    def jumps_by_table(self, instruction):
        """Whether it is a switch's jump; what jumps through a pointer otherwise is refused before."""
        to_helper = instruction.kind == JUMP and TABLE_HELPER.match(self.code.name(instruction.target))
        return instruction.kind in (TABLE_JUMP, JUMP_BY_POINTER) or to_helper

    def pushed(self, address, depth, instruction, compiled):
        """The depth behind an instruction; raises Unbounded where that cannot be told."""
        name = self.code.name(address)
        if instruction.pushed is None and compiled is None:
            raise Unbounded(f"{name} moves the stack pointer by a computed amount")
        by_pointer = instruction.kind == JUMP_BY_POINTER and depth == self.base and not TABLE_HELPER.match(name)
        if instruction.kind == CALL_BY_POINTER or by_pointer:
            raise Unbounded(f"{name} calls through a pointer")
        depth += instruction.pushed or 0
        if depth > ENDLESS:
            raise Unbounded(f"{name} pushes in a loop")
        return depth

    def following(self, instruction, symbol):
        """Where the processor goes from here, as far as the instruction says so. `symbol` is the address of a compiled
        function, or None: what seems to run on behind its end is a call that does not return."""
        kind, behind = instruction.kind, instruction.next
        if kind in (RETURN, TABLE_JUMP, JUMP_BY_POINTER):
            return []
        if kind == JUMP:
            return [instruction.target]
        if symbol is not None and behind is not None and self.code.start(behind) != symbol:
            behind = None
        if kind == BRANCH:
            return [behind, instruction.target]
        if kind == SKIP and behind is not None:
            return [behind, self.code.instructions[behind].next]
        return [behind]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--objdump", default="objdump", help="of the image's toolchain, e.g. avr-objdump")
    parser.add_argument("--frames", action="append", default=[], help="folder with .su files of the image's objects")
    parser.add_argument("image", help="the linked image, an ELF file; or the .json beside it, which says the rest")
    parser.add_argument("function", nargs="+")
    options = parser.parse_args()
    failed = False
    try:
        build = vars(options)
        if options.image.endswith(".json"):
            with open(options.image, encoding="utf-8") as file:
                build = json.load(file)
        usage = StackUsage(build["objdump"], build["frames"], build["image"])
        for function in options.function:
            try:
                size, path = usage.of(function)
                print(f"{function} {size}: {' > '.join(path)}")
            except Unbounded as reason:
                print(f"{function} unknown: {reason}")
                failed = True
    except (OSError, ValueError) as error:
        sys.exit(f"stack_usage: {error}")
    return failed


if __name__ == "__main__":
    sys.exit(main())
