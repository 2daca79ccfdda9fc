#!/usr/bin/env python3
"""Counts the instructions of a few loops, and fails if one is above its ceiling.

    cmake --build --preset release --target lgs_loops && ctest --preset release -R bench.instructions -V

Instructions do not depend on how busy a machine is. Valgrind counts them. Each loop runs a few times and then some more
times, and the difference of the two counts is what the times more cost: so the start of the program is left out.

ceilings.json has the ceiling of each loop, for one compiler: another one makes other code. With another compiler, and
where there is no Valgrind, nothing is compared, and the exit status is 77. `--write` writes new ceilings, two hundredths
above what was counted.
"""
import argparse
import json
import pathlib
import re
import shutil
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
CEILINGS = HERE / "ceilings.json"
SKIPPED = 77
SPARE = 1.02  # the C library has several forms of some functions, and picks one for the processor

# Of each loop: how often it runs at first, and how often then.
LOOPS = {
    "edit-full": (1, 3),
    "edit-ramps": (1, 3),
    "edges-full": (1, 3),
    "edges-ramps": (1, 3),
    "add-full": (1, 3),
    "bulk-full": (1, 3),
    "bulk-ramps": (1, 3),
    "never-seen": (10, 110),
    "stroke-full": (10, 110),
    "stroke-mixed": (10, 110),
}
STEPS = {
    "edit-full": "an edit and its commit, full blocks",
    "edit-ramps": "an edit and its commit, ramps",
    "edges-full": "an edit, its commit and the edges of a terrain (EdgeSet), full blocks",
    "edges-ramps": "the same among ramps",
    "add-full": "a cell of a first build, full blocks by add()",
    "bulk-full": "the same by addMany()",
    "bulk-ramps": "a cell of a first build, ramps by addMany()",
    "never-seen": "a new polygon of 64 vertices comes and goes, two commits",
    "stroke-full": "a cut cell of a carved 32-gon of radius 3, with all of its carve and commit, full blocks",
    "stroke-mixed": "the same in mixed ground",
}


def instructions(program, loop, times):
    command = ["valgrind", "--tool=cachegrind", "--cache-sim=no", "--cachegrind-out-file=/dev/null", program, loop,
               str(times)]
    done = subprocess.run(command, capture_output=True, text=True)
    found = re.search(r"I +refs: +([\d,]+)", done.stderr)
    if done.returncode != 0 or not found:
        sys.exit(f"gate: {' '.join(command)} failed:\n{done.stderr}")
    return int(found.group(1).replace(",", ""))


def steps(program, loop, times):
    return int(subprocess.run([program, "--steps", loop, str(times)], capture_output=True, check=True).stdout)


def counted(program, loops):
    """Of each loop: instructions of a step, and how many steps were counted."""
    counts = {}
    for loop in loops:
        few, more = LOOPS[loop]
        counted_steps = steps(program, loop, more) - steps(program, loop, few)
        counts[loop] = (
            (instructions(program, loop, more) - instructions(program, loop, few)) / counted_steps, counted_steps)
    return counts


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--program", required=True, help="lgs_loops, built as Release")
    options.add_argument("--compiler", required=True, help="what built it, such as 'GNU 12 x86_64'")
    options.add_argument("--only", nargs="+", choices=LOOPS, help="count these loops alone")
    options.add_argument("--write", action="store_true", help="write new ceilings")
    given = options.parse_args()
    if not shutil.which("valgrind"):
        print("gate: there is no valgrind (Debian: apt install valgrind), so no instructions are counted")
        return SKIPPED
    known = json.loads(CEILINGS.read_text())
    if given.compiler != known["compiler"] and not given.write:
        print(f"gate: the ceilings are those of {known['compiler']}, and this was built by {given.compiler}")
        return SKIPPED
    counts = counted(given.program, given.only or LOOPS)
    ceilings = known["ceilings"]
    if given.write:
        ceilings |= {loop: round(count * SPARE) for loop, (count, _) in counts.items()}
        CEILINGS.write_text(json.dumps({"compiler": given.compiler, "ceilings": ceilings}, indent=2) + "\n")
    above = 0
    print(f"{'instructions':>12} {'ceiling':>9} {'steps':>6}")
    for loop, (count, many) in counts.items():
        ceiling = ceilings.get(loop, 0)  # without one it is above
        above += count > ceiling
        print(f"{count:12.1f} {ceiling:9} {many:6} {loop}: {STEPS[loop]}{'   ABOVE' if count > ceiling else ''}")
    if above:
        print("gate: some loops take more instructions than before. docs/internals/performance.md says how to find out"
              "\n      why. If it must be so, run gate.py with --write, and say in the commit what it is good for.")
    return 1 if above else 0


if __name__ == "__main__":
    sys.exit(main())
