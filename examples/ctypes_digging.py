#!/usr/bin/env python3
"""A floor of ten blocks, dug in the middle, in Python: examples/ctypes_digging.py LIBLGS."""
import sys

import lgs_ctypes as lgs

U = lgs.UNITS_PER_CELL
world = lgs.World(sys.argv[1])
square = world.shape([(0, 0), (U, 0), (U, U), (0, U)])
floor = world.add_many([((i, 0), square, 1) for i in range(10)])
removed, added, relinked = world.commit()
print(f"{len(added)} segments")

world.remove(floor[5])
removed, added, relinked = world.commit()
print(f"{len(removed)} removed, {len(added)} added, {len(relinked)} relinked")
for segment in world.segments(added):
    start, end = ((point.x / U, point.y / U) for point in (segment.start, segment.end))
    print(f"a segment of block {segment.block} from {start} to {end}")

try:
    world.add_many([((5, 0), square, 2), ((6, 0), square, 2)])
except lgs.Refused as refused:
    print(refused)
sys.exit(len(removed) != 2 or len(added) != 2)
