"""What the instructions of Thumb, RISC-V and AVR do to control flow and to the stack, as objdump prints them.

Each class has kind(name, operands, target), where `target` is the address that the instruction names or None, and
pushed(name, operands): the bytes that it puts on the stack, negative if it takes some off, None if it does not say how
many. Of the return address `return_address` bytes are on the stack. With `far_jumps` a call to the inside of its own
function is a jump.
"""

import re

# A branch is a jump that may not happen; a skip may pass over the next instruction; a table jump is a switch's.
OTHER, CALL, JUMP, BRANCH, SKIP, RETURN, CALL_BY_POINTER, JUMP_BY_POINTER, TABLE_JUMP = range(9)


class Thumb:
    """Cortex-M. A call leaves the return address in a register. In Thumb-1 no jump reaches as far as `bl`."""

    return_address = 0
    far_jumps = True
    list_instruction = re.compile(r"v?(push|pop|stmdb|ldmia)(\.w)?$")

    @staticmethod
    def kind(name, operands, target):
        name = re.sub(r"\.[nw]$", "", name)
        if name == "bl":
            return CALL
        if name == "blx":
            return CALL_BY_POINTER
        if name == "b":
            return JUMP
        if operands in ("lr", "pc, lr") or re.match(r"(pc, \[sp\]|.*\bpc})", operands):
            return RETURN
        if name == "bx":
            return JUMP_BY_POINTER
        if name in ("tbb", "tbh") or operands.startswith("pc, "):
            return TABLE_JUMP
        return BRANCH if target is not None and re.match(r"b..$|cbn?z$", name) else OTHER

    @classmethod
    def pushed(cls, name, operands):
        if cls.list_instruction.match(name):
            if "push" not in name and "pop" not in name and not operands.startswith("sp!"):
                return 0
            registers = operands[operands.index("{") + 1 : operands.index("}")].split(",")
            size = sum(cls.width(register.strip()) for register in registers)
            return size if "push" in name or "stmdb" in name else -size
        moved = re.search(r"\[sp, #-(\d+)\]!$|\[sp\], #(\d+)$", operands)
        if moved:
            return int(moved.group(1)) if moved.group(1) else -int(moved.group(2))
        if not re.match(r"(sub|add)", name) or not operands.startswith("sp, "):
            return 0
        amount = re.match(r"(?:sp, ){1,2}#(\d+)$", operands)
        if not amount:
            return None
        return int(amount.group(1)) if name.startswith("sub") else -int(amount.group(1))

    @staticmethod
    def width(registers):
        """Bytes of a register, or of a range such as d8-d9."""
        numbers = [int(number) for number in re.findall(r"\d+", registers)] or [0]  # lr has none
        return (numbers[-1] - numbers[0] + 1) * (8 if registers.startswith("d") else 4)


class RiscV:
    """RV32. A call leaves the return address in a register."""

    return_address = 0
    far_jumps = False

    @staticmethod
    def kind(name, operands, target):
        if name in ("jal", "j"):
            return CALL if name == "jal" else JUMP
        if name == "jalr":
            return CALL if target is not None else CALL_BY_POINTER
        # t0 is the return address of the helpers that save registers.
        if name in ("ret", "unimp") or (name == "jr" and operands in ("ra", "t0")):
            return RETURN
        if name == "jr":
            return JUMP if target is not None else JUMP_BY_POINTER
        return BRANCH if target is not None and name.startswith("b") else OTHER

    @staticmethod
    def pushed(name, operands):
        if not name.startswith("add") or not operands.startswith("sp,sp,"):
            return 0
        amount = re.match(r"sp,sp,(-?\d+)$", operands)
        return -int(amount.group(1)) if amount else None


class Avr:
    """AVR with a program counter of 16 bits. A call pushes it, which GCC counts to the function that is called."""

    return_address = 2
    far_jumps = False

    @staticmethod
    def kind(name, operands, target):
        if name in ("call", "rcall"):
            return OTHER if operands == ".+0" else CALL  # `rcall .+0` makes room for two bytes
        if name in ("jmp", "rjmp"):
            return JUMP
        if name in ("icall", "ijmp"):
            return CALL_BY_POINTER if name == "icall" else JUMP_BY_POINTER
        if name in ("ret", "reti"):
            return RETURN
        if name in ("cpse", "sbrc", "sbrs", "sbic", "sbis"):
            return SKIP
        return BRANCH if target is not None and name.startswith("br") else OTHER

    @staticmethod
    def pushed(name, operands):
        if name in ("push", "pop"):
            return 1 if name == "push" else -1
        if name == "rcall" and operands == ".+0":
            return 2
        return None if name == "out" and operands.startswith("0x3d") else 0  # the stack pointer's lower byte


# By the last part of objdump's "file format".
INSTRUCTION_SETS = {"littlearm": Thumb, "littleriscv": RiscV, "avr": Avr}
