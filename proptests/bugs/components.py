"""Which tests can see a change of which folders: the table for mutants.

Not in it are `lib/include`, which the references use too, so that a mutant would stand on both sides; the terrain for
Box2D 3, which is not built where Box2D 2.4 is; and the naive reference for the article, `web/wasm/reference.cpp`.
"""

from dataclasses import dataclass

from googletest import GoogleTests, Program
from package import PackageTests


@dataclass(frozen=True)
class Component:
    """Its tests are an object that knows
    - `sources`: what its results depend on, beside what all do (workshop.py);
    - `kind(file)`: which build of a workshop a mutant of the file is tried with;
    - `build(workshop, kind)`: builds them, and returns the files of which a mutant must change one;
    - `measure(…)`: runs all of them, and returns the result and how long each took, in seconds of the clock;
    - `run(…)`: runs some of them until one fails."""
    folders: tuple[str, ...]
    tests: GoogleTests | PackageTests
    without: tuple[str, ...] = ()  # files


JUDGE = ("Check*:Compare*:Comparable*:Reference*:Preserve*:Naive*:Canonical*:Shrink*:Validity*:Window*:TraceBrush*:"
         "Fuzz*")
# Of the engines under the harness those that are quick, and wait for nothing.
ENGINES = ("PlantedBugs*:Capabilities*:Comparable*:Checker*:Reports.StaySmall:Reports.PagesShowWhatIsCompared:"
           "Reports.AreWrittenAsTheRunGoes-PlantedBugs.ItHangsNowAndThen")

COMPONENTS = {
    "engine": Component(("lib/geometry", "lib/storage", "lib/ground", "lib/outline", "lib/world"),
                        GoogleTests(Program("lgs_engine_tests"))),
    "importer": Component(("addons/tiled",), GoogleTests(Program("lgs_tiled_tests"))),
    "brushes": Component(("lib/brush",), GoogleTests(Program("lgs_brush_tests"))),
    "C": Component(("addons/c/src",), GoogleTests(Program("lgs_attack"))),
    "debug": Component(("addons/debug",), GoogleTests(Program("lgs_debug_tests"))),
    "judge": Component(("oracle/check", "oracle/reference"), GoogleTests(
        Program("lgs_oracle_tests", JUDGE),
        Program("lgs_engines_tests", ENGINES, runs=(("lgs_cli", "lgs"),)))),
    "views": Component(("lib/views", "lib/pieces", "addons/falling/src"), GoogleTests(Program("lgs_view_tests"))),
    "terrain": Component(("addons/box2d/include", "addons/box2d/src", "addons/box2d/both", "addons/box2d/v2"),
                         GoogleTests(Program("lgs_box2d_tests"))),
    "WebAssembly": Component(("web/wasm",), PackageTests(), without=("web/wasm/reference.cpp",)),
}
NATIVE = [name for name, component in COMPONENTS.items() if isinstance(component.tests, GoogleTests)]
