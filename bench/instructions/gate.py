#!/usr/bin/env python3
"""Counts the instructions of a few loops, and fails if one is above its ceiling.

    cmake --build --preset release --target lgs_loops && ctest --preset release -R bench.instructions -V

Instructions do not depend on how busy a machine is. Valgrind counts them. Each loop runs a few times and then some more
times, and the difference of the two counts is what the times more cost: so the start of the program is left out.

Of edits among ramps it counts the lines of memory, too, that are not in a cache of 128 KiB, an eighth of that world:
so many does an edit touch where a world is larger than any cache. Lines that were asked for ahead
(lib/outline/fetch.h) are among them.

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
    "polygons-full": (1, 3),
    "polygons-ramps": (1, 3),
    "bulk-full": (1, 3),
    "bulk-ramps": (1, 3),
    "never-seen": (10, 110),
    "stroke-full": (10, 110),
    "stroke-mixed": (10, 110),
    "undo-full": (10, 110),
    "undo-mixed": (10, 110),
}
LINES = "lines-ramps"
CACHES = ["--cache-sim=yes", "--I1=32768,8,64", "--D1=32768,8,64", "--LL=131072,16,64"]
OF_LINES = "edit-ramps"
STEPS = {
    "edit-full": "an edit and its commit, full blocks",
    "edit-ramps": "an edit and its commit, ramps",
    LINES: "lines of memory beyond 128 KiB that it touches; each second edit comes back to the cell of the one before",
    "edges-full": "an edit, its commit and the edges of a terrain (EdgeSet), full blocks",
    "edges-ramps": "the same among ramps",
    "add-full": "a cell of a first build, full blocks by add()",
    "polygons-full": "the same by the vertices of each",
    "polygons-ramps": "the same among ramps",
    "bulk-full": "as add-full by addMany()",
    "bulk-ramps": "a cell of a first build, ramps by addMany()",
    "never-seen": "a new polygon of 64 vertices comes and goes, two commits",
    "stroke-full": "a cut cell of a carved 32-gon of radius 3, with all of its carve and commit, full blocks",
    "stroke-mixed": "the same in mixed ground",
    "undo-full": "such a stroke with its mark, its commit and the roll-back, full blocks",
    "undo-mixed": "the same in mixed ground",
}


def events(program, loop, times):
    """Instructions, and of one loop lines that are in no cache."""
    caches = CACHES if loop == OF_LINES else ["--cache-sim=no"]
    command = ["valgrind", "--tool=cachegrind", *caches, "--cachegrind-out-file=/dev/null", program, loop, str(times)]
    done = subprocess.run(command, capture_output=True, text=True)
    names = ["I +refs"] + ["LLd misses"] * (loop == OF_LINES)
    found = [re.search(name + r": +([\d,]+)", done.stderr) for name in names]
    if done.returncode != 0 or None in found:
        sys.exit(f"gate: {' '.join(command)} failed:\n{done.stderr}")
    return [int(f.group(1).replace(",", "")) for f in found]


def steps(program, loop, times):
    return int(subprocess.run([program, "--steps", loop, str(times)], capture_output=True, check=True).stdout)


def counted(program, loops):
    """Of each loop: instructions of a step, and how many steps were counted. And lines of memory."""
    counts = {}
    for loop in loops:
        few, more = LOOPS[loop]
        counted_steps = steps(program, loop, more) - steps(program, loop, few)
        before, after = events(program, loop, few), events(program, loop, more)
        for name, a, b in zip([loop, LINES], before, after):
            counts[name] = ((b - a) / counted_steps, counted_steps)
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
        for loop, (count, _) in counts.items():
            ceilings[loop] = round(count * SPARE, None if count > 100 else 1)
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
