#!/usr/bin/env python3
"""The table of doors: every public function of C++, C and JavaScript, the kinds of its arguments, and what attacks it.

    proptests/attack/table.py            # exit status 1 if doors.txt does not have each function, or one that is not
    proptests/attack/table.py --write    # writes doors.txt anew; a function that is new there has no test yet: name it

The last column is `attack` where a program goes through the door with hostile values (proptests/attack, and for
JavaScript web/package/test/attack, which reads the table and fails if it can not call a function of it); otherwise a
test, which must be there: Suite.Name of GoogleTest's, or FILE.js of web/package/test.
"""
import re
import sys

import declared
from declared import ROOT

TABLE = ROOT / "proptests" / "attack" / "doors.txt"
ATTACK = ROOT / "proptests" / "attack"
NO_TEST = "-"

# What each type of an argument is a kind of.
KINDS = {
    "block": "Block lgs_block",
    "bytes": "Uint8Array Uint8Array|string uint8_t span<constbyte>",
    "cell": "Cell lgs_cell",
    "cells": "Rect CellRect lgs_cell_rect",
    "changes": "Changes EdgeChanges span<constCellChange>",
    "choice": "bool Collinear FillRule PaintMode OnCaught Outside Part BlockFrom Undone 'drop'|'keep' 'fill'|'replace' 'solid'|'free' {merge?:boolean}",
    "code": "ErrorCode SyncError lgs_status",
    "edit": "Edit",
    "edges": "span<constDirectedEdge> span<constEdgeLinks>",
    "error": "Error SnapshotError ImportError",
    "file": "string string_view MapFiles char",
    "function": "StayingBlocks Executor ByteSink ChunkSink World::PolygonVisitor PolygonVisitor PreserveRelation FileReader FolderLister "
                "function<Material(Block)> lgs_executor_fn lgs_write_fn lgs_chunk_fn lgs_polygon_fn "
                "lgs_cell_change_fn lgs_anchor_fn IsAnchor function<bool(World&)> (world:World)=>void",
    "group": "lgs_group",
    "island": "IslandId LoopId lgs_island_id lgs_loop_id",
    "hashes": "GroundHashes lgs_hashes",
    "islands": "Islands Loops lgs_islands",
    "loops": "lgs_loops",
    "mark": "Mark lgs_mark",
    "names": "SvgOverlay Partial<ErrorDetails>&{cause?:unknown} readonly(readonly[Block,Block])[]",
    "number": "Int128 number int int32_t uint32_t uint64_t int64_t size_t double float Handles",
    "options": "Options EdgeOptions PiecesOptions TerrainOptions WorldOptions ImportOptions InitOptions Anchors FallingOptions "
               "lgs_world_options",
    "part": "vector<BodyPolygon> lgs_body constBody& GroundBody readonlyGroundPolygon[] {readonlypolygons:readonlyGroundPolygon[]}",
    "piece": "PieceId",
    "pieces": "Pieces lgs_pieces",
    "physics": "Body BodyArgument ConstBodyHandle Shape b2World b2Body b2Fixture b2Contact b2Transform Fixture ObjectId "
               "Box2D PhysicsId Physics Material",
    "place": "Placing {x:number;y:number;angle:number} {readonlyi:number;readonlyj:number} Place Position Chunk Metres "
             "b2Vec2 Vec2 Vec2Value",
    "point": "Point DoublePoint LocalPoint lgs_point lgs_double_point",
    "points": "Vertices span<constLocalPoint> initializer_list<LocalPoint> span<constFloatPoint> "
              "span<constDoublePoint> span<constPoint>",
    "polygon": "PolygonHandle PolygonId lgs_polygon_id",
    "polygons": "span<constPolygonHandle> ArrayLike<PolygonId>",
    "region": "Region Ring",
    "report": "Report",
    "room": "span<PolygonHandle> span<Segment> span<FloatSegment> span<DoubleSegment> vector<PlacedPolygon> vector<Portal>",
    "segment": "SegmentId lgs_segment_id EdgeId",
    "segments": "span<constSegmentId> SegmentList",
    "several": "lgs_new_polygon span<constPlacement> span<constNewPolygon> Int32Array span<constvector<LocalPoint>> "
               "span<constvector<DoublePoint>>",
    "shape": "ShapeId lgs_shape_id",
    "terrain": "Terrain Box2dTerrain PlanckTerrain TerrainBase<Body,Material>",
    "trace": "Trace",
    "user": "void",
    "world": "World lgs_world",
}
KIND_OF = {name: kind for kind, names in KINDS.items() for name in names.split()}


def kind_of(type_name):
    """A pointer of C's is written, or an array is read; other types are as they are without const and reference.
    Only `const Body&` is the engine's: a Body of JavaScript is the physics engine's."""
    text = re.sub(r"^const ", "", type_name).rstrip("&* ")
    kind = KIND_OF.get(type_name.replace(" ", "")) or KIND_OF.get(text.replace(" ", "")) or ("struct" if text.startswith("lgs_") else None)
    if kind is None:
        raise SystemExit(f"proptests/attack/table.py: a kind is missing for the type {type_name}")
    if type_name.endswith("**") or (type_name.endswith("*") and not type_name.startswith("const ")
                                    and kind not in ("world", "group", "loops", "user", "physics", "islands", "hashes", "pieces", "part")):
        return "output"
    return "array" if type_name.startswith("const lgs_") and type_name.endswith("*") and kind not in ("world", "islands", "hashes", "pieces", "part") else kind


def row(function, test):
    kinds = ", ".join(kind_of(t) for t in function.arguments) or "none"
    return f"{function.interface} | {function.name} | {kinds} | {test}"


def listed():
    """Function by interface and name: the test that attacks it."""
    lines = [line for line in TABLE.read_text(encoding="utf-8").splitlines() if not line.startswith("#")]
    rows = [(*line.split(" | ", 1), line.rsplit(" | ", 2)) for line in lines]  # types of JavaScript have bars, too
    return {(interface, parts[0].split(" | ", 1)[1]): parts[2] for interface, _, parts in rows}


def attacked():
    """What the attack says that it goes through."""
    text = "".join(path.read_text(encoding="utf-8") for folder in (ATTACK, ROOT / "addons")
                   for path in sorted(folder.rglob("doors_*.cpp")))
    return set(re.findall(r'\bdoor\(\s*"([^"]+)"', text))


def tests():
    names = {path.name for path in (ROOT / "web" / "package" / "test").glob("*.test.js")}
    names |= {path.name for path in (ROOT / "addons/c/tests").glob("*_test.c")}
    for path in (path for folder in ("proptests", "addons") for path in (ROOT / folder).rglob("*_test.cpp")):
        text = path.read_text(encoding="utf-8")
        names |= {".".join(pair) for pair in re.findall(r"^(?:TEST|TEST_F|TEST_P|LGS_LAW)\((\w+),\s*(\w+)", text, re.M)}
    return names


# What is there to be left half changed. When memory runs out the program ends; an exception would go on with it.
STATE = "World Transaction Loops Islands Pieces GroundHashes Terrain TerrainBase"


def leaves_half(function):
    """Whether a function could go on with an exception from the middle of a change."""
    changes = any(re.fullmatch(rf"(?!const )({STATE.replace(' ', '|')})(<.*>)?&", t) for t in function.arguments)
    is_member = function.name.removeprefix("box2d::").partition("::")[0] in STATE.split()
    return function.may_throw and (changes or (is_member and "::" in function.name.partition("(")[0]))


def complaints():
    functions = {(f.interface, f.name): f for f in declared.all_functions()}
    rows, doors, known = listed(), attacked(), tests()
    for key in functions.keys() - rows.keys():
        yield f"{' '.join(key)}: in no row of doors.txt. `table.py --write` adds it; then name what attacks it"
    for function in filter(leaves_half, functions.values()):
        yield f"{function.interface} {function.name}: is not noexcept, so it can leave a world half changed"
    for key in rows.keys() - functions.keys():
        yield f"{' '.join(key)}: a row of doors.txt, but no public function"
    for (interface, name), test in rows.items():
        if test == "attack":
            if interface != "JavaScript" and name not in doors:
                yield f"{interface} {name}: no door of proptests/attack has this name"
        elif test not in known:
            yield f"{interface} {name}: nothing attacks it, as there is no test {test}"
    named = {name for (interface, name), test in rows.items() if test == "attack" and interface != "JavaScript"}
    for name in doors - named:
        yield f"{name}: a door of proptests/attack, but in no row of doors.txt as `attack`"
    expected = [row(f, rows.get(key, NO_TEST)) for key, f in functions.items()]
    if expected != [line for line in TABLE.read_text(encoding="utf-8").splitlines() if not line.startswith("#")]:
        yield "the rows of doors.txt are not in the order of the headers, or have other kinds: `table.py --write`"


HEAD = """# Every public function, the kinds of its arguments, and what attacks it with hostile values: `attack` is
# proptests/attack, or web/package/test/attack; anything else is a test. Made by proptests/attack/table.py --write, which keeps the last column.
"""


def main():
    if declared.clang() is None:
        print("skipped: there is no clang++ to read the headers")
        return 77
    if sys.argv[1:] == ["--write"]:
        rows = listed() if TABLE.exists() else {}
        doors = attacked()
        lines = [row(f, rows.get((f.interface, f.name),
                                 "attack" if f.interface == "JavaScript" or f.name in doors else NO_TEST))
                 for f in declared.all_functions()]
        TABLE.write_text(HEAD + "\n".join(lines) + "\n", encoding="utf-8")
        return 0
    found = sorted(set(complaints()))
    print("\n".join(found) or f"{len(listed())} public functions, each with what tries it")
    return bool(found)


if __name__ == "__main__":
    sys.exit(main())
