#!/usr/bin/env python3
"""Shapely (which is GEOS) as an engine of regions for `lgs check --engine`: it keeps doubles, and rounds its outline.

    lgs check --engine 'python3 examples/engines/shapely_regions.py' --edits 500"""
import sys

from shapely.geometry import LineString, Polygon
from shapely.ops import polygonize, unary_union

UNITS = 65536  # of the lattice, in a cell


def rings_of(words):
    """`x y x y … | x y …`, in cells."""
    parts = [[float(word) * UNITS for word in part.split()] for part in " ".join(words).split("|")]  # exact
    return [list(zip(numbers[::2], numbers[1::2])) for numbers in parts]


def is_inside(point, rings):
    """Whether the rings run around it an odd number of times."""
    x, y, odd = point.x, point.y, False
    for ring in rings:
        for (ax, ay), (bx, by) in zip(ring, ring[1:] + ring[:1]):
            odd ^= (ay > y) != (by > y) and x < ax + (y - ay) * (bx - ax) / (by - ay)
    return odd


def region_of(rings):
    """The faces that the rings cut out, as far as they are inside."""
    lines = unary_union([LineString(ring + ring[:1]) for ring in rings])
    return unary_union([face for face in polygonize(lines) if is_inside(face.representative_point(), rings)])


def segments(solid):
    for part in getattr(solid, "geoms", [solid]):
        for ring in (part.exterior, *part.interiors) if isinstance(part, Polygon) and not part.is_empty else ():
            turn = 1 if ring.is_ccw == (ring is part.exterior) else -1  # the solid is on the left
            points = [(round(x), round(y)) for x, y in ring.coords[::turn]]
            yield from ((*a, *b) for a, b in zip(points, points[1:]) if a != b)


def main():
    solid = Polygon()
    for line in sys.stdin:
        word, *rest = line.split()
        if word == "lgs-engine":
            print("lgs-engine 1 Shapely regions slants round=1", flush=True)
        elif word == "reset":
            solid = Polygon()
        elif word == "paint":  # of one block, the modes are the same
            solid = solid.union(region_of(rings_of(rest[2:])))
        elif word == "carve":
            solid = solid.difference(region_of(rings_of(rest)))
        elif word == "commit":
            for ends in segments(solid):
                print("segment", *ends, "- - - - 0")
            print("end", flush=True)


main()
