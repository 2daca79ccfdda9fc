#!/usr/bin/env python3
"""An engine of regions for `lgs check --engine`, from the page of the protocol alone: strokes of whole cells.

    lgs check --engine 'python3 examples/engines/squares_regions.py' --edits 2000

Of one block the modes of painting are the same. What is solid is a set of cells near the origin."""
import sys

UNITS = 65536  # of the lattice, in a cell
BEYOND = 9  # every cell


def inside(rings):
    """The cells that the rings run around an odd number of times: right of an upright edge they change by turns."""
    cells = set()
    for ring in " ".join(rings).split("|"):
        numbers = list(map(int, ring.split()))
        points = list(zip(numbers[::2], numbers[1::2]))
        for (x, a), (_, b) in zip(points, points[1:] + points[:1]):
            cells ^= {(i, j) for i in range(x, BEYOND) for j in range(min(a, b), max(a, b))}
    return cells


def outline(solid):
    """The sides of cells with nothing beyond, the solid on the left."""
    for i, j in solid:
        for x, y, dx, dy in ((i, j, 1, 0), (i + 1, j, 0, 1), (i + 1, j + 1, -1, 0), (i, j + 1, 0, -1)):
            if (i + dy, j - dx) not in solid:
                yield x, y, x + dx, y + dy


def main():
    solid = set()
    for line in sys.stdin:
        word, *rest = line.split()
        if word == "lgs-engine":
            print("lgs-engine 1 squares_regions.py regions lattice=1 cells=4", flush=True)
        elif word == "reset":
            solid = set()
        elif word == "paint":
            solid |= inside(rest[2:])
        elif word == "carve":
            solid -= inside(rest)
        elif word == "commit":
            for side in outline(solid):
                print("segment", *(UNITS * c for c in side), "- - - - 0")
            print("end", flush=True)


main()
