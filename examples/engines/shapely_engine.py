#!/usr/bin/env python3
"""Shapely (which is GEOS) as an engine for `lgs check --engine`: it unites all polygons anew at each commit.

    lgs check --engine 'python3 examples/engines/shapely_engine.py' --edits 2000

Ghosts are the neighbours in the ring. They are not the laws' where rings touch, so `ghosts` is not promised."""
import sys

from shapely.geometry import Polygon
from shapely.ops import unary_union

UNITS = 65536  # of the lattice, in a cell


def rings(united):
    """The vertices of each ring, with the solid on the left."""
    for part in getattr(united, "geoms", [united]):
        for ring in (part.exterior, *part.interiors):
            points = [(round(x), round(y)) for x, y in ring.coords[:-1]]
            yield points if ring.is_ccw == (ring is part.exterior) else points[::-1]


def segments(united):
    for ring in rings(united):
        for k in range(len(ring)):
            before, start, end, after = (ring[(k + d) % len(ring)] for d in (-1, 0, 1, 2))
            yield start + end + before + after


def main():
    polygons = {}
    for line in sys.stdin:
        word, *rest = line.split()
        if word == "lgs-engine":
            print("lgs-engine 1 Shapely several slants", flush=True)
        elif word == "reset":
            polygons = {}
        elif word == "add":
            i, j, _ = map(int, rest[1:4])
            numbers = [float(x) * UNITS for x in rest[4:]]  # exact
            polygons[rest[0]] = Polygon([(i * UNITS + x, j * UNITS + y) for x, y in zip(numbers[::2], numbers[1::2])])
        elif word == "remove":
            del polygons[rest[0]]
        elif word == "commit":
            for points in segments(unary_union(list(polygons.values()))):
                print("segment", *points, 0)
            print("end", flush=True)


main()
