#!/usr/bin/env python3
"""Checks that no include goes up: each room may include only the rooms that the table names.

    scripts/layers.py            # exit status 0: all is well; 1: an include goes up, and which; 2: a file has no room

A *room* is a folder. Its public headers and its sources are one room, except in lib/, where headers and sources of the
engine are told apart: the references and the tools may see public headers only. A bug in values, limits or toWorld() would be on both sides, any other can not.
"""
import pathlib
import re
import subprocess
import sys

# What a room may include, beside itself. The table is the rule; its order means nothing.
ENGINE = ["lib/include"]
GROUND = ENGINE + ["lib/geometry", "lib/storage"]
REFERENCES = ["oracle/reference", "oracle/cgal", "oracle/calls", "oracle/trace"]
ORACLE = REFERENCES + ["oracle/draw", "oracle/views", "oracle/engine/include", "oracle/engine", "oracle/page", "oracle/generate", "oracle/suites", "oracle/check"]
TERRAIN = ["addons/box2d/include", "addons/box2d/v2/names", "addons/box2d/v3/names", "addons/box2d/both/include",
           "addons/box2d/v2/include", "addons/box2d/v3/include", "addons/box2d/cut_out"]
ADAPTERS = ["addons/c/include", "addons/debug/include", "lib/brush/include", "lib/pieces/include", "lib/views/include",
            "addons/falling/include", "addons/falling/box2d", "addons/tiled/include"] + TERRAIN
ROOMS = {
    "lib/include": [],
    "lib/text": [],  # words as people and shells read them: of the importer, the references and the command
    "lib/geometry": ["lib/include"],
    "lib/storage": ["lib/include"],
    "lib/ground": GROUND,
    "lib/outline": GROUND + ["lib/ground"],
    "lib/world": GROUND + ["lib/ground", "lib/outline"],
    "addons/c/include": [],
    # The C interface has the views and falling ground in it, as their objects are in the one library that it is.
    "addons/c/src": ["lib/include", "lib/views/include", "lib/pieces/include", "addons/falling/include", "addons/c/include"],
    "addons/debug/include": ["lib/include"],
    "addons/debug/src": ["lib/include", "addons/debug/include"],
    "lib/brush/include": ["lib/include"],
    "lib/brush/src": ["lib/include", "lib/geometry", "lib/brush/include"],
    "lib/pieces/include": ["lib/include"],
    "lib/pieces/src": ["lib/include", "lib/geometry", "lib/pieces/include"],
    "lib/views/include": ["lib/include"],
    "lib/views/src": ["lib/include", "lib/geometry", "lib/views/include"],
    # It stands on three views and brushes, and knows no physics engine. What knows Box2D is headers alone, on top of
    # the terrain: so the terrain needs no islands, and islands need no Box2D.
    "addons/falling/include": ["lib/include", "lib/views/include", "lib/brush/include"],
    "addons/falling/src": ["lib/include", "lib/views/include", "lib/pieces/include", "lib/brush/include",
                        "addons/falling/include"],
    "addons/falling/box2d": ["lib/include", "lib/views/include", "lib/brush/include", "addons/falling/include", "addons/box2d/include",
                          "addons/box2d/v2/include", "addons/box2d/v3/include"],
    "addons/tiled/include": ["lib/include"],
    "addons/tiled/src": ["lib/include", "lib/geometry", "lib/text", "lib/brush/include", "addons/tiled/include"],
    "web/bench": ["lib/include"],
    # The rules of terrains and the checker are compiled into the package, and the reference into the article.
    "web/wasm": ["lib/include", "lib/brush/include", "addons/falling/include", "lib/views/include", "lib/pieces/include",
                 "addons/tiled/include", "addons/box2d/include", "addons/box2d/src", "oracle/reference", "oracle/trace",
                 "oracle/check"],
    "addons/box2d/include": ["lib/include"],
    "addons/box2d/src": ["lib/include", "lib/geometry", "addons/box2d/include"],
    "addons/box2d/v2/names": [],
    "addons/box2d/v3/names": [],
    "addons/box2d/both/include": ["lib/include", "addons/box2d/include", "addons/box2d/v2/names", "addons/box2d/v3/names"],
    "addons/box2d/v2/include": ["addons/box2d/both/include"],
    "addons/box2d/v3/include": ["addons/box2d/both/include"],
    "addons/box2d/cut_out": ["lib/include", "lib/brush/include", "addons/box2d/include", "addons/box2d/v2/include",
                          "addons/box2d/v3/include"],
    "addons/box2d/v2/src": ["lib/include", "addons/box2d/include", "addons/box2d/src", "addons/box2d/v2/names",
                         "addons/box2d/v2/include"],
    "addons/box2d/v3/src": ["lib/include", "addons/box2d/include", "addons/box2d/src", "addons/box2d/v3/names",
                         "addons/box2d/v3/include"],
    # What both generations do alike asks physics by calls.h, which each has.
    "addons/box2d/both/src": ["lib/include", "addons/box2d/include", "addons/box2d/src", "addons/box2d/both/include",
                           "addons/box2d/v2/src", "addons/box2d/v3/src"],
    "oracle/reference": ENGINE,
    "oracle/cgal": ENGINE + ["oracle/reference"],
    "oracle/draw": ENGINE + ["oracle/reference"],
    # Calls of brushes and of views, too.
    "oracle/calls": ENGINE + ["lib/brush/include", "lib/views/include", "oracle/reference"],
    "oracle/trace": ENGINE + ["lib/brush/include", "lib/views/include", "oracle/reference", "oracle/calls"],
    # What it compares are values of the views' public headers.
    "oracle/views": ENGINE + ["lib/views/include", "lib/pieces/include", "oracle/reference", "oracle/cgal"],
    "oracle/page": ENGINE + ["oracle/reference", "oracle/trace", "oracle/draw"],
    "oracle/engine/include": [],
    "oracle/engine": ENGINE + ["oracle/engine/include", "oracle/reference", "oracle/trace"],
    # Random brushes are circles and lines of the library's making.
    "oracle/suites": ENGINE + REFERENCES,
    "oracle/generate": ENGINE + ["lib/brush/include", "oracle/reference", "oracle/calls", "oracle/trace",
                                 "oracle/engine"],
    "oracle/check": ENGINE + REFERENCES + ["oracle/views", "lib/brush/include", "lib/views/include", "lib/pieces/include", "lib/text", "oracle/draw", "oracle/engine", "oracle/page",
                                            "oracle/generate"],
    "bench/published": ENGINE + ["oracle/engine/include", "oracle/reference"],
    "addons/box2d/ride": ENGINE + ADAPTERS + ORACLE,
    # it counts cut cells, and the rules of edges, which know no Box2D
    "bench/instructions": ENGINE + ["addons/box2d/include", "lib/brush/include", "lib/brush/src", "oracle/calls"],
    "bench": ENGINE + ADAPTERS + ORACLE + ["bench/published"],
    "cli": ENGINE + ADAPTERS + ORACLE + ["lib/text", "bench", "addons/box2d/ride"],
    "examples": ENGINE + ADAPTERS + ["oracle/engine/include", "addons/sync"],
    "packaging": ENGINE,
    "addons/sync": ["lib/include", "lib/views/include"],
    "addons/files": ["lib/include", "lib/views/include", "addons/sync", "addons/debug/include"],
    "packaging/tests/consumer": ENGINE + ADAPTERS,  # a project of its own, as a game would be
}
# Tests look inside, and may include all. Nobody includes them.
TESTS = ("proptests", "fuzz", "tests")
# The folders from which a header is found by a path without its room.
INCLUDE_FOLDERS = ["", "lib", "lib/include", "addons/c/include", "addons/debug/include", "lib/brush/include",
                   "lib/brush/src", "lib/pieces/include", "lib/pieces/src", "lib/views/include", "lib/views/src",
                   "addons/falling/include", "addons/falling/src", "addons/falling/box2d/include", "addons/falling/box2d/v2/include",
                   "addons/falling/box2d/v3/include", "addons/tiled/include", "addons/tiled/src", "addons/box2d/include",
                   "addons/box2d/src", "addons/box2d/both/include", "addons/box2d/v2/names/include", "addons/box2d/v2/include",
                   "addons/box2d/v2/src", "addons/box2d/v3/names/include", "addons/box2d/v3/include", "addons/box2d/v3/src",
                   "addons/box2d/cut_out/include",
                   "oracle/engine/include"]
# What no file below a folder may include, tests apart: it is MIT and goes into games.
FOREIGN = {folder: re.compile(r"CGAL/|rapidcheck|gtest|gmock|fmt/|CLI/") for folder in ("lib", "addons")}
KINDS = ["*.h", "*.c", "*.cpp"]
INCLUDE = re.compile(r'^\s*#\s*include\s*(["<])([^">]+)[">]')


def room_of(path):
    """The longest folder of the table that holds the file, "tests", or None."""
    folders = [str(parent) for parent in path.parents]
    room = next((folder for folder in folders if folder in ROOMS), None)
    is_test = any(part in TESTS for part in path.relative_to(room or ".").parts[:-1])
    return "tests" if is_test else room


def rooms_of_include(root, path, name, quoted):
    """The rooms that have the file that an include names: none where it is another library's, two where there are two
    versions of it."""
    folders = ([str(path.parent)] if quoted else []) + INCLUDE_FOLDERS
    return [room_of(pathlib.Path(folder, name)) for folder in folders if (root / folder / name).is_file()]


def complaints(root, files):
    for path in files:
        room = room_of(path)
        if room is None:
            yield f"{path}: this folder has no room in the table of scripts/layers.py"
            continue
        for number, line in enumerate((root / path).read_text(encoding="utf-8").splitlines(), 1):
            include = INCLUDE.match(line)
            if not include:
                continue
            quote, name = include.groups()
            for folder, foreign in FOREIGN.items():
                if room not in ("tests", "addons/box2d/ride") and path.is_relative_to(folder) and foreign.match(name):
                    yield f"{path}:{number}: {folder}/ must not include {name}"
            there = rooms_of_include(root, path, name, quote == '"')
            if room != "tests" and there and not any(other == room or other in ROOMS[room] for other in there):
                yield f"{path}:{number}: {room} must not include {there[0]}: {line.strip()}"


def circles():
    """Rooms that may include each other, if only by a detour: the table itself would be wrong."""
    for start in ROOMS:
        seen, todo = set(), list(ROOMS[start])
        while todo:
            room = todo.pop()
            if room == start:
                yield f"the table lets {start} include itself by a detour"
                break
            if room not in seen:
                seen.add(room)
                todo += ROOMS[room]


def sources(root):
    listed = subprocess.run(["git", "ls-files", "--cached", "--others", "--exclude-standard", *KINDS], cwd=root,
                            capture_output=True, text=True, check=False)
    if listed.returncode == 0 and listed.stdout:
        return [pathlib.Path(line) for line in listed.stdout.splitlines() if (root / line).is_file()]
    found = [path.relative_to(root) for kind in KINDS for path in root.rglob(kind)]  # an archive, no clone
    return [path for path in found if path.parts[0] not in ("build", "out")]


def main():
    root = pathlib.Path(__file__).resolve().parent.parent
    files = sources(root)
    found = list(complaints(root, files)) + list(circles())
    for complaint in found:
        print(complaint)
    if found:
        return 2 if any("no room" in complaint for complaint in found) else 1
    print(f"layers: no include goes up in {len(files)} files of {len(ROOMS)} rooms")
    return 0


if __name__ == "__main__":
    sys.exit(main())
