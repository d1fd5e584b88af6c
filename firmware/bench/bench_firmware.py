"""Counts what twiddle costs on each emulated board, beside the same oscillators with the usual libraries.

Prints tables and writes all counts as CSV. Run by `make bench-firmware`; README.md says how to read it.
"""

import argparse
import csv
import re
import subprocess
import sys
import tempfile
from dataclasses import dataclass, field
from pathlib import Path

sys.path.append(str(Path(__file__).parents[1] / "scripts"))
from symbol_names import source_name

SECONDS = 300  # after which an image is taken to hang


@dataclass(frozen=True)
class Board:
    name: str
    core: str
    unit: str = "instructions"


BOARDS = (
    Board("microbit", "Cortex-M0+"),
    Board("mps2-an386", "Cortex-M4F"),
    Board("mps2-an500", "Cortex-M7"),
    Board("virt", "RV32IMAC"),
    Board("atmega1284p", "ATmega1284P", "cycles"),
)

# Image and what its numbers are called.
TWIDDLE = {"bench_twiddle_fixed": "twiddle, fixed", "bench_twiddle": "twiddle, float"}
PEERS = {
    "bench_cmsis_q31": "CMSIS-DSP, q31",
    "bench_cmsis_f32": "CMSIS-DSP, float",
    "bench_libm": "C library, float",
}

# What is counted: the name in the tables, and the function.
SEVEN = "seven oscillators"
TICK = "whole tick"
OPERATIONS = {
    SEVEN: "seven_tick",
    TICK: "twd_controller_tick",
    "torques": "twd_controller_torque",
    "trial start": "twd_controller_start",
    "act": "twd_learner_act",
    "learn": "twd_learner_learn",
}
GATE = "gate and remap"  # the whole tick less the seven oscillators, in the mean

# Of which images and operations the tables say where the cost arises, by the functions of the source; the CSV says it
# of all by those of the image.
DETAILED_OPERATIONS = (TICK, "torques", "learn")
DETAILED = (
    ("microbit", "bench_twiddle_fixed"),
    ("mps2-an386", "bench_twiddle_fixed"),
    ("mps2-an386", "bench_twiddle"),
)


@dataclass
class Cost:
    """Of the calls of one function."""

    calls: int
    total: int
    least: int
    most: int
    parts: dict = field(default_factory=dict)  # address of an instruction, or function, where it arose: total

    @property
    def mean(self):
        return self.total / self.calls


@dataclass
class Counts:
    """Of one image on one board."""

    board: Board
    image: str
    costs: dict  # operation: Cost
    output_error: float  # largest of an output; no such where double is float


def read_costs(path):
    costs = {}
    with open(path, newline="") as file:
        for row in csv.DictReader(line for line in file if not line.startswith("#")):
            if row["part"]:
                costs[row["function"]].parts[source_name(row["part"])] = int(row["total"])
            else:
                costs[row["function"]] = Cost(*(int(row[name]) for name in ("calls", "total", "least", "most")))
    return costs


def functions_at(image, addresses):
    """By address, the source's function that holds the instruction, inlined or not; arithmetic counts for its user."""
    command = ["arm-none-eabi-addr2line", "-e", image, "-a", "-f", "-i"]
    done = subprocess.run(command, input="\n".join(addresses), capture_output=True, text=True, check=True)
    functions = {}
    for block in re.split(r"^(?=0x[0-9a-f]+$)", done.stdout, flags=re.MULTILINE)[1:]:
        address, *lines = block.splitlines()
        frames = list(zip(lines[::2], lines[1::2]))
        inner = [function for function, place in frames if not re.search(r"/number\.h:", place)]
        functions[address] = source_name((inner or [frames[-1][0]])[0])
    return functions


def by_function(image, parts):
    """Totals by function of totals by address."""
    functions = functions_at(image, parts)
    totals = {}
    for address, total in parts.items():
        totals[functions[address]] = totals.get(functions[address], 0) + total
    return totals


def measure(run, folder, board, image):
    operations = OPERATIONS if image in TWIDDLE else {SEVEN: OPERATIONS[SEVEN]}
    with tempfile.NamedTemporaryFile(suffix=".csv") as file:
        command = [run, "--seconds", str(SECONDS), "--counts", file.name]
        if (board.name, image) in DETAILED:
            command.append("--by-address")
        for function in operations.values():
            command += ["--count", function]
        done = subprocess.run([*command, board.name, folder / image], capture_output=True, text=True)
        if done.returncode != 0:
            raise RuntimeError(f"{image} failed on {board.name}: {(done.stderr or done.stdout).strip()}")
        costs = read_costs(file.name)
    if (board.name, image) in DETAILED:
        for cost in costs.values():
            cost.parts = by_function(folder / image, cost.parts)
    error = re.search(r"error_1e-9 (\d+)", done.stdout)
    if not error or not all(costs[function].calls for function in operations.values()):
        raise RuntimeError(f"{image} on {board.name} ended without doing all that is counted")
    return Counts(board, image, {name: costs[function] for name, function in operations.items()}, int(error[1]) / 1e9)


def measure_all(arguments):
    """All counts by board and image; images that were not built are left out."""
    counts = {}
    for board in BOARDS:
        if board.name not in arguments.boards:
            continue
        folder = arguments.images / f"{board.name}-O2" / "bin"
        if not (folder / "bench_twiddle").exists():
            raise RuntimeError(f"there is no {folder / 'bench_twiddle'}; make bench-firmware builds it")
        for image in (*TWIDDLE, *PEERS):
            if (folder / image).exists():
                counts[board.name, image] = measure(arguments.run, folder, board, image)
    return counts


# --- what comes out ---


def print_table(title, rows):
    print(f"\n{title}\n")
    for row in (rows[0], ["---"] * len(rows[0]), *rows[1:]):
        print("| " + " | ".join(row) + " |")


def whole(number):
    return f"{number:,.0f}"


def mean_and_most(cost):
    return f"{whole(cost.mean)} ({whole(cost.most)})"


def has_reference(board):
    """Whether double on the board is more than float."""
    return board.name != "atmega1284p"


def print_operations(counts):
    rows = [["core", "numbers", SEVEN, GATE, *[name for name in OPERATIONS if name != SEVEN]]]
    for (_, image), count in counts.items():
        if image not in TWIDDLE:
            continue
        gate = count.costs[TICK].mean - count.costs[SEVEN].mean
        row = [count.board.core, image_numbers(image), mean_and_most(count.costs[SEVEN]), whole(gate)]
        rows.append(row + [mean_and_most(count.costs[name]) for name in OPERATIONS if name != SEVEN])
    print_table(f"Costs of one call, mean (most), in instructions, on the ATmega1284P in cycles; {GATE}: mean", rows)


def image_numbers(image):
    return TWIDDLE[image].removeprefix("twiddle, ")


def ratio(count, ours):
    return f"{count.costs[SEVEN].mean / ours.costs[SEVEN].mean:.2f}" if ours else "-"


def print_peers(counts):
    rows = [["core", "implementation", "mean", "most", "by twiddle's fixed", "by twiddle's float", "largest error"]]
    for (board, image), count in counts.items():
        cost = count.costs[SEVEN]
        row = [count.board.core, (TWIDDLE | PEERS)[image], whole(cost.mean), whole(cost.most)]
        row += [ratio(count, counts.get((board, ours))) for ours in TWIDDLE]
        rows.append([*row, f"{count.output_error:.1e}" if has_reference(count.board) else "-"])
    print_table("The seven oscillators: costs, ratios, and the largest error of an output against double", rows)


def goals(counts):
    """Each goal: what it is about, the mean cost, and the cost that it may reach."""

    def seven(board, image):
        return counts[board, image].costs[SEVEN].mean if (board, image) in counts else None

    fixed = "bench_twiddle_fixed"
    for board, image, limit in (
        ("microbit", fixed, 2000),
        ("mps2-an386", fixed, 500),
        ("virt", fixed, 600),
        ("mps2-an386", "bench_twiddle", 520),
    ):
        yield board, TWIDDLE[image], seven(board, image), limit, whole(limit)
    for board in ("microbit", "mps2-an386", "mps2-an500"):
        theirs = seven(board, "bench_cmsis_q31")
        limit = theirs and theirs / 2
        yield board, TWIDDLE[fixed], seven(board, fixed), limit, f"half of CMSIS-DSP's q31, {whole(limit or 0)}"


def print_goals(counts):
    cores = {board.name: board.core for board in BOARDS}
    rows = [["core", "implementation", "mean", "goal, at most", "reached"]]
    for board, name, mean, limit, text in goals(counts):
        if mean and limit:
            rows.append([cores[board], name, whole(mean), text, "yes" if mean <= limit else "no"])
    print_table("The goals for the seven oscillators", rows)


def print_details(counts):
    for key in DETAILED:
        if key not in counts:
            continue
        count = counts[key]
        rows = [["of", "function", "a call", "share"]]
        for name in DETAILED_OPERATIONS:
            cost = count.costs[name]
            for part, total in sorted(cost.parts.items(), key=lambda item: -item[1]):
                rows.append([name, part, whole(total / cost.calls), f"{100 * total / cost.total:.1f} %"])
        print_table(f"Where the {count.board.unit} go: {TWIDDLE[count.image]}, {count.board.core}", rows)


def first_line(*command):
    return subprocess.run(command, capture_output=True, text=True).stdout.partition("\n")[0]


def versions():
    compilers = ("arm-none-eabi-gcc", "riscv64-unknown-elf-gcc", "avr-gcc")
    return ["; ".join(first_line(name, "--version") for name in compilers), first_line("qemu-system-arm", "--version")]


def write_csv(path, counts):
    """A row an operation, with the place where it arose empty, and one for each such place."""
    path.parent.mkdir(parents=True, exist_ok=True)
    with open(path, "w", newline="") as file:
        file.write("# costs of calls at -O2, by images of firmware/bench; unit: what the cost is in\n")
        file.writelines(f"# {line}\n" for line in versions())
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow("board core unit implementation operation part calls mean least most output_error".split())
        for (board, image), count in counts.items():
            for name, cost in count.costs.items():
                row = [board, count.board.core, count.board.unit, (TWIDDLE | PEERS)[image], name]
                error = count.output_error if name == SEVEN and has_reference(count.board) else ""
                writer.writerow([*row, "", cost.calls, f"{cost.mean:.3f}", cost.least, cost.most, error])
                for part, total in cost.parts.items():
                    writer.writerow([*row, part, "", f"{total / cost.calls:.3f}", "", "", ""])


def parse_arguments():
    names = [board.name for board in BOARDS]
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--run", required=True, type=Path, help="firmware/emulators/run")
    parser.add_argument("--images", required=True, type=Path, help="the folder build/firmware")
    parser.add_argument("--out", required=True, type=Path, help="the CSV to write")
    parser.add_argument("--boards", nargs="+", choices=names, default=names)
    return parser.parse_args()


def main():
    arguments = parse_arguments()
    try:
        counts = measure_all(arguments)
        write_csv(arguments.out, counts)
    except (RuntimeError, OSError) as error:
        sys.exit(f"bench-firmware: {error}")
    print("\n".join(versions()))
    print_operations(counts)
    print_peers(counts)
    print_goals(counts)
    print_details(counts)
    print(f"\n{arguments.out}")


if __name__ == "__main__":
    main()
