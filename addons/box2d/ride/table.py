#!/usr/bin/env python3
"""Prints the table of ghost collisions of docs/reports/box2d.md. It runs `lgs ride` once for each line.

    addons/box2d/ride/table.py build/release/cli/lgs
"""

import pathlib
import subprocess
import sys
import tempfile

SOURCE = pathlib.Path(__file__).resolve().parents[3]
WAYS = {
    "terrain": "terrain",
    "terrain, merged": "merged",
    "CGAL chains": "chains of CGAL's loops",
    "edges without ghosts": "edges without ghosts",
    "polygons": "a fixture for each polygon",
}
FLOOR = "floor"
TRACE = "docs/ride.trace"
MAP = "examples/maps/landscape.tmx"
RIDES = [
    (FLOOR, "--size 0.8 --coast --speed 3 --steps 4200"),
    (FLOOR, "--size 0.8 --coast --speed 10 --steps 1300"),
    (FLOOR, "--size 0.8 --coast --speed 3 --rider capsule --upright --steps 4200"),
    (FLOOR, "--size 0.8 --speed 10 --rider box --friction 0.5 --steps 1300"),
    (TRACE, "--size 0.7 --coast --speed 4 --rider box --upright --steps 1800"),
    (TRACE, "--size 0.7 --coast --speed 4 --rider capsule --upright --steps 1800"),
    (MAP, "--size 0.8 --speed 8 --friction 0.5 --upright --from 6 -10 --steps 1800"),
]


def ride(lgs, file, options):
    """For each way of giving Box2D the ground: the kicks per 1,000 cells, and how far the ride came."""
    run = subprocess.run([lgs, "ride", file, *options.split()], capture_output=True, text=True, check=False)
    if run.returncode != 0:
        sys.exit(run.stderr)
    ways = {}
    for line in run.stdout.splitlines()[1:]:
        name, _length, _kicks, per_thousand, _strongest, end = line.rsplit(maxsplit=5)
        ways[name] = (int(per_thousand), float(end))
    return ways


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    print("| ride | " + " | ".join(WAYS.values()) + " |")
    print("|---" * (1 + len(WAYS)) + "|")
    with tempfile.TemporaryDirectory() as folder:
        floor = pathlib.Path(folder, "floor.trace")
        squares = (f"add f{i} {i} 0 1 0 0 1 0 1 1 0 1\n" for i in range(200))
        floor.write_text("lgs-trace 1\n" + "".join(squares), encoding="utf-8")
        for world, options in RIDES:
            ways = ride(sys.argv[1], str(floor if world == FLOOR else SOURCE / world), options)
            furthest = ways["terrain"][1]
            cells = []
            for way in WAYS:
                kicks, end = ways[way]
                cells.append(str(kicks) if end > 0.95 * furthest else f"{kicks}; only to cell {int(end)}")
            name = world if world == FLOOR else f"`{world}`"
            print(f"| {name}, `{options}` | " + " | ".join(cells) + " |")


if __name__ == "__main__":
    main()
