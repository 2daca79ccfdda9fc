"""Which tests can see a change of which folders: the table for mutants.

Not in it are `lib/include`, which the references use too, so that a mutant would stand on both sides; and the terrain
for Box2D 3, which is not built where Box2D 2.4 is.
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
    "terrain": Component(("lib/box2d/include", "lib/box2d/src", "lib/box2d/v2"), "lgs_box2d_tests", "*"),
}
