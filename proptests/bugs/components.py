"""Which tests can see a change of which folders: the table for mutants.

Not in it are `lib/include`, which the references use too, so that a mutant would stand on both sides; the terrain for
Box2D 3, which is not built where Box2D 2.4 is; and `web/wasm`, the bridge to JavaScript, whose tests are no program of
GoogleTest's.
"""

from dataclasses import dataclass


@dataclass(frozen=True)
class Component:
    folders: tuple[str, ...]
    program: str
    tests: str  # a GoogleTest filter


COMPONENTS = {
    "engine": Component(("lib/geometry", "lib/storage", "lib/ground", "lib/outline", "lib/world"), "lgs_engine_tests",
                        "*"),
    "importer": Component(("lib/tiled",), "lgs_tests", "Tiled*"),
    "brushes": Component(("lib/brush",), "lgs_brush_tests", "*"),
    "C": Component(("lib/c/src",), "lgs_attack", "*"),
    "debug": Component(("lib/debug",), "lgs_tests", "Debug*"),
    "judge": Component(("oracle/check", "oracle/reference"), "lgs_tests",
                       "Check*:Compare*:Comparable*:Reference*:Naive*:Canonical*:Shrink*:Validity*:Fuzz*"),
    "views": Component(("lib/views", "lib/pieces", "lib/falling/src"), "lgs_view_tests", "*"),
    "terrain": Component(("lib/box2d/include", "lib/box2d/src", "lib/box2d/both", "lib/box2d/v2"), "lgs_box2d_tests", "*"),
}
