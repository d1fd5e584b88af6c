"""Counts the instructions of training runs by piece of the simulation: nine objects, both ends of a run.

Prints a table, writes it as CSV, and says what changed against a recorded one. Run by `make bench-instructions`;
README.md says what is counted.
"""

import argparse
import csv
import os
import re
import subprocess
import sys
import tempfile
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

OBJECTS = [f"{size}-{shape}" for size in ("small", "medium", "large") for shape in ("sphere", "cylinder", "cube")]
WHAT = ["--setup", "paper-negated", "--model", "cpg-h", "--seed", "1"]
TRIALS = 5000  # of a whole run
COUNTED = 300  # at each of its ends
STEPS = 300  # control steps of a trial
FIRST = f"1-{COUNTED}"
LAST = f"{TRIALS - COUNTED + 1}-{TRIALS}"
# What a resumed run does before it goes on; left out of the count.
RESUME = "twiddle::runs::TrainingSession::resume(*"
PIECE_OF_ADDRESS = Path(__file__).resolve().parent.parent / "scripts/piece-of-address"
VISIBLE = 0.01  # a change below this share is not reported


class Failure(Exception):
    """One sentence for the user."""


def run(*command, folder=None, text=None):
    """Standard output. The environment is the same for everyone, since it takes a few instructions to read."""
    environment = {"PATH": os.environ["PATH"], "LC_ALL": "C"}
    done = subprocess.run(command, cwd=folder, input=text, env=environment, capture_output=True, text=True)
    if done.returncode != 0:
        lines = done.stderr.strip().splitlines() or ["it said nothing"]
        raise Failure(f"{Path(command[0]).name} failed: {lines[-1]}")
    return done.stdout


def machine_code(program, folder):
    code = Path(folder) / f"{Path(program).parent.parent.name}.text"
    run("objcopy", "-O", "binary", "--only-section=.text", program, str(code))
    return code.read_bytes()


# --- callgrind ---


def counts_by_address(text, program):
    """Instructions by address in the file `program`, and those elsewhere, of callgrind's output with uncompressed
    positions and names."""
    counts, elsewhere, total = Counter(), 0, None
    own = inclusive = False
    for line in text.splitlines():
        if line.startswith("0x"):
            # The line after calls= is what the called function took; its own lines count it.
            if not inclusive:
                address, count = line.split()
                if own:
                    counts[int(address, 16)] += int(count)
                else:
                    elsewhere += int(count)
            inclusive = False
        elif line.startswith("calls="):
            inclusive = True
        elif line.startswith("ob="):
            own = line[len("ob=") :] == program
        elif line.startswith("summary:"):
            total = int(line.split()[1])
    if total != counts.total() + elsewhere:
        raise Failure(f"callgrind counted {total} instructions, but its lines sum to {counts.total() + elsewhere}")
    return counts, elsewhere


def callgrind(program, folder, *arguments, options=()):
    out = Path(folder) / "callgrind.out"
    run(
        "valgrind",
        "--tool=callgrind",
        f"--callgrind-out-file={out}",
        "--dump-instr=yes",
        "--dump-line=no",
        "--compress-pos=no",
        "--compress-strings=no",
        *options,
        program,
        *arguments,
        folder=folder,
    )
    text = out.read_text()
    out.unlink()
    return text


# --- the two ends of a run ---


def train(name, trials):
    return ["train", *WHAT, "--object", name, "--trials", str(trials), "--out", "run"]


def count_first(program, name, folder):
    return counts_by_address(callgrind(program, folder, *train(name, COUNTED)), program)


def stop_before_the_last(folder):
    """Makes the complete run in `folder` one that was stopped before the trials to count; returns its whole log."""
    run_json, log = folder / "run.json", folder / "trials.csv"
    text = run_json.read_text()
    run_json.write_text(text.replace('"state": "complete"', '"state": "running"'))
    lines = log.read_text().splitlines(keepends=True)
    (folder / "trials.csv.part").write_text("".join(lines[:-COUNTED]))
    log.unlink()
    return "".join(lines)


def count_last(program, name, folder):
    run(program, *train(name, TRIALS), folder=folder)
    whole_log = stop_before_the_last(folder / "run")
    # Counting is on at the start, off in the function, and on again after it; in this order, since the first option
    # means another start.
    options = (f"--toggle-collect={RESUME}", "--collect-atstart=yes")
    text = callgrind(program, folder, *train(name, TRIALS), "--resume", options=options)
    if (folder / "run/trials.csv").read_text() != whole_log:
        raise Failure(f"{name}: the resumed run gave other trials than the whole one")
    return counts_by_address(text, program)


# --- the table ---


@dataclass
class Row:
    """The instructions of one end of one object's run."""

    object: str
    trials: str
    total: int
    pieces: dict  # names to instructions


def pieces_by_address(lines_program, addresses):
    text = "".join(f"{address:#x}\n" for address in addresses)
    answers = (line.split("\t") for line in run(PIECE_OF_ADDRESS, lines_program, text=text).splitlines())
    return {int(address, 16): piece for address, piece in answers}


def require_end_alone(rows):
    """Resuming learns from all earlier trials again, fifteen times as many as are counted; learning costs the same in
    each."""
    learner = {(row.object, row.trials): row.pieces["learner"] for row in rows}
    for name in OBJECTS:
        if learner[name, LAST] > 2 * learner[name, FIRST]:
            function = RESUME.rstrip("(*")
            raise Failure(f"{name}: what resuming takes was counted too; has {function} been renamed or inlined?")


def count_all(arguments, work):
    program = str(Path(arguments.program).resolve())
    tasks = [(count, name, trials) for count, trials in ((count_first, FIRST), (count_last, LAST)) for name in OBJECTS]

    def do(task):
        count, name, trials = task
        folder = work / f"{name}-{trials}"
        folder.mkdir()
        return count(program, name, folder)

    with ThreadPoolExecutor(arguments.jobs) as pool:
        results = list(pool.map(do, tasks))
    piece_of = pieces_by_address(arguments.lines, sorted(set().union(*(counts for counts, _ in results))))
    names = run(PIECE_OF_ADDRESS).splitlines()
    rows = []
    for (_, name, trials), (counts, elsewhere) in zip(tasks, results):
        pieces = dict.fromkeys(names, 0)
        pieces["rest"] += elsewhere
        for address, count in counts.items():
            pieces[piece_of[address]] += count
        rows.append(Row(name, trials, counts.total() + elsewhere, pieces))
    require_end_alone(rows)
    return rows


def lines_of(rows):
    """Of the CSV, its header first."""
    header = ["object", "trials", "total_m", "control_step", *rows[0].pieces]
    lines = [header]
    for row in rows:
        per_step = [round(count / (COUNTED * STEPS)) for count in (row.total, *row.pieces.values())]
        lines.append([row.object, row.trials, round(row.total / 1e6), *per_step])
    return [[str(cell) for cell in line] for line in lines]


def comments(program, work):
    run_json = (work / f"{OBJECTS[0]}-{LAST}/run/run.json").read_text()
    version = {key: re.search(f'"{key}": "(.*)"', run_json).group(1) for key in ("git_commit", "compiler")}
    return [
        f"instructions of twiddle train {' '.join(WHAT)}, commit {version['git_commit']}, {version['compiler']}, "
        f"{run('valgrind', '--version').strip()}",
        f"trials {FIRST}: a whole run of {COUNTED} trials; {LAST}: a run of {TRIALS}, resumed, without what resuming "
        "takes",
        "total_m: of the whole program, in millions; control_step and the pieces (bench/pieces.txt): for each control "
        "step of 10 ms",
    ]


def write_csv(path, header_comments, lines):
    path.parent.mkdir(parents=True, exist_ok=True)
    with open(path, "w", newline="") as file:
        file.writelines(f"# {comment}\n" for comment in header_comments)
        csv.writer(file, lineterminator="\n").writerows(lines)


def print_table(lines):
    for line in [lines[0], ["---"] * len(lines[0]), *lines[1:]]:
        print("| " + " | ".join(line) + " |")


def read_csv(path):
    with open(path, newline="") as file:
        return list(csv.reader(line for line in file if not line.startswith("#")))


def changes(recorded, measured):
    """A sentence for each row that changed by more than the visible share, and for each that only one of them has."""
    by_key = lambda lines: {tuple(line[:2]): dict(zip(lines[0], line)) for line in lines[1:]}
    old_rows, new_rows = by_key(recorded), by_key(measured)
    for key in [*new_rows, *(key for key in old_rows if key not in new_rows)]:
        old, new = old_rows.get(key), new_rows.get(key)
        if old is None or new is None:
            yield f"{' '.join(key)}: {'not in the recorded' if old is None else 'only in the recorded'}"
            continue
        parts = []
        for column in [*new, *(column for column in old if column not in new)][2:]:
            before, after = int(old.get(column, 0)), int(new.get(column, 0))
            if abs(after - before) > VISIBLE * before:
                share = f"{100 * (after / before - 1):+.1f} %" if before else "new"
                parts.append(f"{column} {before} -> {after} ({share})")
        if parts:
            yield f"{' '.join(key)}: {', '.join(parts)}"


def print_changes(recorded, lines):
    if not recorded.exists():
        print(f"\n{recorded} is not there: nothing to compare with")
        return
    found = list(changes(read_csv(recorded), lines))
    print(f"\nagainst {recorded}: " + ("changes of more than 1 %:" if found else "no change of more than 1 %"))
    print("\n".join(found))


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", required=True, help="twiddle, as it is built by default")
    parser.add_argument("--lines", required=True, help="the same, built with -g")
    parser.add_argument("--out", required=True, type=Path, help="the CSV to write")
    parser.add_argument("--recorded", required=True, type=Path, help="the CSV to compare with")
    parser.add_argument("--jobs", type=int, default=2, help="runs at a time")
    return parser.parse_args()


def main():
    arguments = parse_arguments()
    try:
        with tempfile.TemporaryDirectory() as folder:
            work = Path(folder)
            if machine_code(arguments.program, work) != machine_code(arguments.lines, work):
                raise Failure(f"{arguments.lines} is not {arguments.program} with -g: its machine code differs")
            lines = lines_of(count_all(arguments, work))
            header_comments = comments(arguments.program, work)
    except (Failure, OSError) as error:
        sys.exit(f"bench-instructions: {error}")
    print("\n".join(header_comments) + "\n")
    print_table(lines)
    write_csv(arguments.out, header_comments, lines)
    print(f"\n{arguments.out}")
    print_changes(arguments.recorded, lines)


if __name__ == "__main__":
    main()
