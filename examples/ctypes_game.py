#!/usr/bin/env python3
"""A walker on a floor of blocks, in a loop of frames: examples/ctypes_game.py LIBLGS.

Each second a bomb takes away the block below. The walker falls in and climbs out. game.cpp is the same game in C++.
"""
import sys

import lgs_ctypes as lgs

U = lgs.UNITS_PER_CELL


class Outline:
    """The game's own copy of the outline, by id. A game with a physics engine would have a body's edges there."""

    def __init__(self):
        self.edges = {}

    def update(self, world, removed, added):
        """Takes over what a commit has changed. A relinked segment has other ghosts only: not needed here."""
        for name in removed:
            del self.edges[name]
        self.edges |= dict(zip(added, world.segments(added)))

    def floor_below(self, x, y):
        """How high the ground is. The solid is on the left of an edge, so edges to the left are floors."""
        return max((e.start.y for e in self.edges.values() if e.end.x <= x < e.start.x and e.start.y <= y), default=0)

    def is_blocked(self, x, y, step):
        """Whether a step to the right ends at a wall: an edge that goes down."""
        return any(e.start.x == e.end.x and e.end.y <= y < e.start.y and x < e.start.x <= x + step
                   for e in self.edges.values())


def main():
    world = lgs.World(sys.argv[1])
    square = world.shape([(0, 0), (U, 0), (U, U), (0, U)])
    world.add_many([((i, j), square, 1) for j in range(4) for i in range(16)])

    outline = Outline()
    x, y = U // 2, 5 * U
    for frame in range(300):
        if frame % 60 == 59:  # a bomb, where the walker stands
            below = x // U, (y - 1) // U
            world.clear(below, below)
        removed, added, relinked = world.commit()  # once in each frame; it costs what was edited
        outline.update(world, removed, added)
        if added:
            print(f"frame {frame}: {len(removed)} removed, {len(added)} added, {len(relinked)} relinked; "
                  f"{len(outline.edges)} edges")
        if outline.is_blocked(x, y, U // 32):
            y += U // 16  # it climbs
        else:
            x += U // 32
            y = max(outline.floor_below(x, y), y - U // 8)  # it falls
    print(f"the walker is at ({x / U:.3f}, {y / U:.3f})")


main()
