"""The code of an image, as objdump prints it."""

import bisect
import collections
import re
import subprocess

from instructions import CALL, INSTRUCTION_SETS, JUMP

# `target` is the address that it names, or None; `pushed` the bytes that it puts on the stack, or None if it does not
# say; `next` the address of what stands behind it, None if that is no code.
Instruction = collections.namedtuple("Instruction", "kind target pushed next")


def run(*command):
    """A command's output."""
    result = subprocess.run(command, capture_output=True, text=True)
    if result.returncode:
        raise ValueError(f"{command[0]}: {result.stderr.strip()}")
    return result.stdout


class Code:
    """Instructions by address, and the symbols before them."""

    def __init__(self, objdump, image):
        text = run(objdump, "-d", "--no-show-raw-insn", image)
        file_format = re.search(r"file format \w+-(\w+)", text)
        if not file_format or file_format.group(1) not in INSTRUCTION_SETS:
            raise ValueError(f"{image} is no image for Cortex-M, RV32 or AVR")
        self.instruction_set = INSTRUCTION_SETS[file_format.group(1)]
        self.instructions = {}
        self.names = {}  # address -> a symbol's name
        self.read(text)
        self.symbols = read_symbols(run(objdump, "-t", image))

    def read(self, text):
        address = None  # of the instruction before, if this line stands behind one
        for header in re.finditer(r"^([0-9a-f]+) <(.+)>:$", text, re.MULTILINE):
            self.names[int(header.group(1), 16)] = header.group(2)
        self.starts = sorted(self.names)
        for line in text.splitlines():
            found = re.match(r" *([0-9a-f]+):\t([a-z][\w.]*)\s*(.*)$", line)
            if found:
                here = int(found.group(1), 16)
                if address is not None:
                    self.instructions[address] = self.instructions[address]._replace(next=here)
                self.instructions[here] = self.instruction(here, *found.groups()[1:])
                address = here
            elif line.strip() and not line.endswith(">:"):
                address = None

    def instruction(self, address, name, text):
        named = re.search(r"\b(?:0x)?([0-9a-f]+) <", text)
        target = int(named.group(1), 16) if named else None
        operands = re.split(r"\s+(?:[;@]|# )", text)[0]
        kind = self.instruction_set.kind(name, operands, target)
        if kind == CALL and self.instruction_set.far_jumps and self.start(address) == self.start(target) != target:
            kind = JUMP
        return Instruction(kind, target, self.instruction_set.pushed(name, operands), None)

    def start(self, address):
        """The address of the symbol that `address` belongs to."""
        return self.starts[bisect.bisect_right(self.starts, address) - 1]

    def name(self, address):
        return self.names[self.start(address)]

    def symbol_of(self, address):
        """The addresses of all instructions of the symbol that `address` belongs to."""
        start = self.start(address)
        return [place for place in self.instructions if place >= start and self.start(place) == start]


def read_symbols(table):
    """{address: [(source of a local symbol or None, name)]} from objdump -t, where local symbols follow the source."""
    symbols, source = {}, None
    for line in table.splitlines():
        found = re.match(r"([0-9a-f]+) (.{7}) (\S+)\s+[0-9a-f]+ +(?:\.hidden )?(\S+)$", line)
        if found:
            address, flags, section, name = found.groups()
            if "f" in flags:
                source = name
            elif section == ".text":
                symbols.setdefault(int(address, 16), []).append((source if flags[0] == "l" else None, name))
    return symbols
