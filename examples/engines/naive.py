#!/usr/bin/env python3
"""An engine for `lgs check --engine`, from the page of the protocol alone: it works everything out anew at each commit.

    lgs check --engine 'python3 examples/engines/naive.py' --edits 2000

It takes polygons with axis-parallel edges, several in a cell, and a preserve relation. It knows the islands."""
import sys

UNITS = 65536  # of the lattice, in a cell
TURN = {(1, 0): 0, (0, 1): 1, (-1, 0): 2, (0, -1): 3}  # directions, counter-clockwise


def direction(a, b):
    return ((b[0] > a[0]) - (b[0] < a[0]), (b[1] > a[1]) - (b[1] < a[1]))


def cut(a, b, lines):
    """The pieces of an edge between the vertices on it; lines[k][c]: vertices whose coordinate k is c."""
    along = 0 if a[1] == b[1] else 1
    low, high = sorted((a[along], b[along]))
    on = sorted({v for v in lines[1 - along].get(a[1 - along], ()) if low <= v[along] <= high},
                reverse=a[along] > b[along])
    return zip(on, on[1:])


def lines_of(polygons):
    lines = ({}, {})
    for _, vertices in polygons:
        for v in vertices:
            for k in (0, 1):
                lines[k].setdefault(v[k], set()).add(v)
    return lines


def islands(polygons):
    """(westernmost vertex, twice the area) of polygons that share points. Who shares a point shares a vertex, once edges
    are cut."""
    lines = lines_of(polygons)
    found = []  # (vertices, twice the area)
    for _, vertices in polygons:
        sides = list(zip(vertices, vertices[1:] + vertices[:1]))
        points = {p for a, b in sides for piece in cut(a, b, lines) for p in piece}
        area = sum(a[0] * b[1] - a[1] * b[0] for a, b in sides)
        for other in [f for f in found if not points.isdisjoint(f[0])]:
            found.remove(other)
            points |= other[0]
            area += other[1]
        found.append((points, area))
    return [(min(points), area) for points, area in found]


def outline(polygons, preserve):
    """Segments (start, end, ghost1, ghost2, block), by laws 1 and 2."""
    lines = lines_of(polygons)
    edges = {}
    for block, vertices in polygons:
        for a, b in zip(vertices, vertices[1:] + vertices[:1]):
            for piece in cut(a, b, lines):
                edges[piece] = block
    shown = {e: b for e, b in edges.items() if e[::-1] not in edges or frozenset((b, edges[e[::-1]])) in preserve}
    into, out_of = {}, {}
    for a, b in shown:
        out_of.setdefault(a, []).append(b)
        into.setdefault(b, []).append(a)

    def first(vertex, end, others, sign):
        """The first other end met when turning from the end, all seen from the vertex; the same direction is skipped."""
        start = TURN[direction(vertex, end)]
        turns = [((TURN[direction(vertex, o)] - start) * sign % 4, o) for o in others]
        return min((t for t in turns if t[0]), default=(0, None))[1]

    for (a, b), block in shown.items():
        yield a, b, first(a, b, into.get(a, []), -1), first(b, a, out_of.get(b, []), 1), block


def main():
    polygons, preserve = {}, set()
    for line in sys.stdin:
        word, *rest = line.split()
        if word == "lgs-engine":
            print("lgs-engine 1 naive.py ghosts blocks several preserve islands", flush=True)
        elif word == "reset":
            polygons, preserve = {}, set()
        elif word == "preserve":
            preserve.add(frozenset(map(int, rest)))
        elif word == "add":
            i, j, block = map(int, rest[1:4])
            numbers = [round(float(x) * UNITS) for x in rest[4:]]
            polygons[rest[0]] = block, [(i * UNITS + x, j * UNITS + y) for x, y in zip(numbers[::2], numbers[1::2])]
        elif word == "remove":
            del polygons[rest[0]]
        elif word == "commit":
            for *points, block in outline(list(polygons.values()), preserve):
                print("segment", *(f"{p[0]} {p[1]}" if p else "- -" for p in points), block)
            for (x, y), area in islands(list(polygons.values())):
                print("island", x, y, area)
            print("end", flush=True)


main()
