#!/usr/bin/env python3
"""An incremental engine for `lgs check --engine`: it keeps the outline of whole squares, and tells what changed.

    lgs check --engine 'python3 examples/engines/incremental.py' --edits 2000

A segment is the side of a cell that runs from a corner (x, y) east, north, west or south; that is its id, too."""
import sys
import time

UNITS = 65536  # of the lattice, in a cell
STEP = [(1, 0), (0, 1), (-1, 0), (0, -1)]  # east, north, west, south
LEFT = [(0, 0), (-1, 0), (-1, -1), (0, -1)]  # the cell on the left of such a step from (0, 0); that before is on the right


def move(at, by):
    return at[0] + by[0], at[1] + by[1]


def is_shown(cells, at, way):
    return move(at, LEFT[way]) in cells and move(at, LEFT[way - 1]) not in cells


def segment(cells, at, way):
    """The line of the side, without its id; None if it is not shown. Links turn through what is free."""
    if not is_shown(cells, at, way):
        return None
    end = move(at, STEP[way])
    before = next(f % 4 for f in (way - 1, way - 2, way - 3) if is_shown(cells, move(at, STEP[f % 4]), (f + 2) % 4))
    after = next(f % 4 for f in (way - 1, way, way + 1) if is_shown(cells, end, f % 4))
    points = (at, end, move(at, STEP[before]), move(end, STEP[after]))
    return " ".join(f"{x * UNITS} {y * UNITS}" for x, y in points) + f" {cells[move(at, LEFT[way])]}"


def update(cells, edited, told):
    """Renews the sides whose links an edited cell may change. Yields what changed."""
    near = {(i + x, j + y) for i, j in edited for x in range(-1, 3) for y in range(-1, 3)}
    for at in near:
        for way in range(4):
            name, old, new = f"{at[0]},{at[1]},{way}", told.get((at, way)), segment(cells, at, way)
            if new == old:
                continue
            told[at, way] = new
            yield f"- {name}" if new is None else f"{'~' if old else '+'} {name} segment {new}"


def main():
    cells, cell_of, edited, told = {}, {}, set(), {}  # blocks; cells by name; those edited since the commit; segments
    for line in sys.stdin:
        word, *rest = line.split()
        if word == "lgs-engine":
            print("lgs-engine 1 incremental.py squares ghosts blocks delta time", flush=True)
        elif word == "reset":
            cells, cell_of, edited, told = {}, {}, set(), {}
        elif word == "add":
            cell_of[rest[0]] = int(rest[1]), int(rest[2])
            cells[cell_of[rest[0]]] = int(rest[3])
            edited.add(cell_of[rest[0]])
        elif word == "remove":
            del cells[cell_of[rest[0]]]
            edited.add(cell_of.pop(rest[0]))
        elif word == "commit":
            begin = time.perf_counter_ns()
            changes = list(update(cells, edited, told))
            edited.clear()
            print(*changes, f"time {time.perf_counter_ns() - begin}", "end", sep="\n", flush=True)


main()
