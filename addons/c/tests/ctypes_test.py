#!/usr/bin/env python3
"""The shared library by Python's ctypes: plays random traces, and compares with `lgs replay --dump`.

    addons/c/tests/ctypes_test.py LIBLGS LGS [--traces N] [--seed S]

Exit status 1 and the trace, if an outline is another one. The traces go through several calls that mean the same edit,
so a binding that has a struct or an argument wrong shows. Which edits must be refused, and what the error says, is
worked out here: a library that refuses all would have the right outline of nothing.
"""
import argparse
import collections
import os
import pathlib
import random
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / "examples"))
import lgs_ctypes as lgs  # noqa: E402  (it stands with the examples)

# A library with sanitizers has theirs loaded before Python; a command has its own.
ENVIRONMENT = {name: value for name, value in os.environ.items() if name != "LD_PRELOAD"}
U = lgs.UNITS_PER_CELL
H = U // 2
# Shapes whose corners lie on each other's walls and meet in points, as the harness likes them.
SHAPES = [
    [(0, 0), (U, 0), (U, U), (0, U)],
    [(0, 0), (U, 0), (U, U)],
    [(0, 0), (U, U), (0, U)],
    [(0, 0), (U, 0), (U, H), (0, H)],
    [(0, H), (U, H), (U, U), (0, U)],
    [(H, 0), (U, H), (H, U), (0, H)],
    [(0, 0), (H, H), (0, U)],
    [(U, 0), (U, U), (H, H)],
    [(0, 0), (U // 4, 0), (U // 4, U)],
]


# A polygon that is placed, or that an entry of a call with many places.
Placed = collections.namedtuple("Placed", "cell vertices block polygon entry")


def has_on_the_right(p, q):
    """Whether an edge of p has all of q on its right, or on its line. Both are convex and run counter-clockwise."""
    return any(all((x1 - x0) * (y - y0) <= (y1 - y0) * (x - x0) for x, y in q)
               for (x0, y0), (x1, y1) in zip(p, p[1:] + p[:1]))


def overlap(p, q):
    return not has_on_the_right(p, q) and not has_on_the_right(q, p)


def in_the_way(placed, cell, vertices):
    """The oldest polygon that this one overlaps, or None."""
    return next((other for other in placed if other.cell == cell and overlap(other.vertices, vertices)), None)


class Trace:
    """The same edits as text and in a world. `answers` counts them, by call and answer."""

    def __init__(self, library, chance, answers):
        self.chance = chance
        self.answers = answers
        self.blocks = chance.random() < 0.3  # whether other blocks keep the edges between them
        self.world = lgs.World(library, (lambda a, b: a != b) if self.blocks else None)
        self.lines = ["lgs-trace 1"]
        if self.blocks:
            self.lines += ["preserve 1 2", "preserve 1 3", "preserve 2 3"]
        self.placed = {}
        self.copy = {}  # the segments by the change lists alone
        self.count = 0

    def text(self):
        return "\n".join(self.lines) + "\n"

    def note_add(self, polygon, cell, block, vertices):
        name = f"p{self.count}"
        self.count += 1
        self.placed[name] = Placed(cell, vertices, block, polygon, -1)
        points = "  ".join(f"{x}/{U} {y}/{U}" for x, y in vertices)
        self.lines.append(f"add {name} {cell[0]} {cell[1]} {block}  {points}")

    def note_remove(self, name):
        del self.placed[name]
        self.lines.append(f"remove {name}")

    def some_add(self):
        chance = self.chance
        cell = (chance.randrange(-2, 3), chance.randrange(30, 34))
        return cell, chance.choice(SHAPES), chance.randrange(1, 4)

    def note_refusal(self, call, refused, cell, other, index=-1):
        self.answers[call, "refused"] += 1
        error = refused.error
        assert other, f"{call}: refused, and nothing is in the way: {refused}"
        assert error.code == lgs.OVERLAP and tuple(error.cell) == cell and error.index == index, refused
        assert error.other_block == other.block and error.index2 == other.entry, refused
        assert tuple(error.other) == (tuple(other.polygon) if other.polygon else (0, 0)), refused

    def add(self):
        cell, vertices, block = self.some_add()
        other = in_the_way(self.placed.values(), cell, vertices)
        way = self.chance.randrange(3)
        try:
            if way == 0:
                polygon = self.world.add_points(cell, vertices, block)
            elif way == 1:
                polygon = self.world.add_doubles(cell, [(x / U, y / U) for x, y in vertices], block)
            else:
                polygon = self.world.add(cell, self.world.shape(vertices), block)
        except lgs.Refused as refused:
            self.note_refusal("add", refused, cell, other)
        else:
            assert not other, f"placed over {other}"
            self.answers["add", "done"] += 1
            self.note_add(polygon, cell, block, vertices)

    def add_many(self):
        some = [self.some_add() for _ in range(self.chance.randrange(4))]
        placements = [(cell, self.world.shape(vertices), block) for cell, vertices, block in some]
        placed = list(self.placed.values())
        refusal = None
        for index, (cell, vertices, block) in enumerate(some):
            if other := in_the_way(placed, cell, vertices):
                refusal = cell, other, index
                break
            placed.append(Placed(cell, vertices, block, None, index))
        try:
            polygons = self.world.add_many(placements)
        except lgs.Refused as refused:
            self.note_refusal("add_many", refused, *(refusal or (None, None)))
        else:
            assert not refusal, f"placed over {refusal}"
            self.answers["add_many", "done"] += len(some) > 1
            for polygon, (cell, vertices, block) in zip(polygons, some):
                self.note_add(polygon, cell, block, vertices)

    def remove(self):
        if self.placed:
            name = self.chance.choice(sorted(self.placed))
            self.world.remove(self.placed[name].polygon)
            self.note_remove(name)

    def remove_many(self):
        names = [name for name in sorted(self.placed) if self.chance.random() < 0.2]
        self.world.remove_many([self.placed[name].polygon for name in names])
        for name in names:
            self.note_remove(name)

    def commit(self):
        removed, added, relinked = self.world.commit()
        for segment in removed:
            del self.copy[segment]
        for segment in self.world.segments(added + relinked):
            self.copy[segment.id.value] = segment
        assert set(added).isdisjoint(relinked)
        self.lines.append("commit")

    def detour(self):
        """Nobody may notice it: edits that are undone, or a world that is saved and loaded."""
        if self.chance.random() < 0.5:
            mark = self.world.mark()
            self.world.clear((-9, -9), (40, 40))
            self.world.commit()
            self.world.roll_back(mark)
        else:
            self.commit()
            self.world.load(self.world.save())

    def play(self):
        ways = [self.add] * 10 + [self.add_many] * 3 + [self.remove] * 4 + [self.remove_many, self.detour]
        for _ in range(self.chance.randrange(1, 60)):
            self.chance.choice(ways)()
            if self.chance.random() < 0.25:
                self.commit()
        self.commit()

    def dump(self, segments):
        lines = []
        for s in segments:
            ghosts = [(s.ghost1.x, s.ghost1.y) if s.predecessor else ("-", "-"),
                      (s.ghost2.x, s.ghost2.y) if s.successor else ("-", "-")]
            key = (s.start.x, s.start.y, s.end.x, s.end.y, s.block)
            lines.append((key, " ".join(map(str, ("segment", *key[:4], *ghosts[0], *ghosts[1], s.block)))))
        return [line for _, line in sorted(lines)]


def check(library, command, seed, answers):
    trace = Trace(library, random.Random(seed), answers)
    try:
        trace.play()
    except AssertionError as wrong:
        return f"seed {seed}: {wrong}\n{trace.text()}"
    with tempfile.NamedTemporaryFile("w", suffix=".trace") as file:
        file.write(trace.text())
        file.flush()
        replay = [command, "replay", file.name, "--dump", "-"]
        done = subprocess.run(replay, capture_output=True, text=True, check=False, env=ENVIRONMENT)
    if done.returncode != 0:
        return f"seed {seed}: lgs replay: {done.stderr}\n{trace.text()}"
    expected = done.stdout.splitlines()
    for what, segments in (("all segments", trace.world.segments(trace.world.all_segments())),
                           ("the copy that follows the changes", trace.copy.values())):
        found = trace.dump(segments)
        if found != expected:
            missing, extra = set(expected) - set(found), set(found) - set(expected)
            return f"seed {seed}, {what}: missing {sorted(missing)}, extra {sorted(extra)}\n{trace.text()}"
    return None


def main():
    parser = argparse.ArgumentParser(description="Plays random traces by ctypes, and compares with lgs replay.")
    parser.add_argument("library")
    parser.add_argument("command")
    parser.add_argument("--traces", type=int, default=60)
    parser.add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()
    answers = collections.Counter()
    for seed in range(arguments.seed, arguments.seed + arguments.traces):
        complaint = check(arguments.library, arguments.command, seed, answers)
        if complaint:
            print(complaint)
            return 1
    counts = {f"{call} {answer}": answers[call, answer]
              for call in ("add", "add_many") for answer in ("done", "refused")}
    print(f"{arguments.traces} traces: the same outlines as lgs replay's;", counts)
    if min(counts.values()) < arguments.traces // 2:
        print("An answer came too seldom to say anything.")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
