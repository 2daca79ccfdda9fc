"""Mutants: bugs that nobody chose. Each is the code with one small change by rule: an operator for another, a constant
one more or less, a condition negated, a statement dropped, two arguments swapped (rules.py)."""

from dataclasses import dataclass
from functools import cache

from bugs import ROOT
from finders import Package, Tests
from rules import Change, changes_of

EXPLAINED = ROOT / "proptests/bugs/equivalent.txt"

JUDGE = ("Check*:Compare*:Comparable*:Reference*:Preserve*:Canonical*:Shrink*:Validity*:Window*:TraceBrush*:"
         "Fuzz*")
# Of the engines under the harness those that are quick, and wait for nothing.
ENGINES = ("PlantedBugs*:Capabilities*:Comparable*:Checker*:Reports.StaySmall:Reports.PagesShowWhatIsCompared:"
           "Reports.AreWrittenAsTheRunGoes-PlantedBugs.ItHangsNowAndThen")
# Tests of the package that see no WebAssembly, but how it is packed, typed and described; and those of a browser.
NOT_OF_MODULES = {"example", "pack", "readme", "size", "types"}

# Which tests can see a change of which folders. Not in it are `lib/include`, which the references use too, so that a
# mutant would stand on both sides, and the terrain for Box2D 3, which is not built where Box2D 2.4 is.
COMPONENTS = {
    "engine": (("lib/geometry", "lib/storage", "lib/ground", "lib/outline", "lib/world"),
               [Tests("lgs_engine_tests", "*")]),
    "brushes": (("lib/brush",), [Tests("lgs_brush_tests", "*")]),
    "views": (("lib/views", "lib/pieces"), [Tests("lgs_view_tests", "*")]),
    "checker": (("oracle/check", "oracle/reference"),
              [Tests("lgs_oracle_tests", JUDGE), Tests("lgs_engines_tests", ENGINES)]),
    "importer": (("addons/tiled",), [Tests("lgs_tiled_tests", "*")]),
    "C": (("addons/c/src",), [Tests("lgs_attack", "*")]),
    "debug": (("addons/debug",), [Tests("lgs_debug_tests", "*")]),
    "falling": (("addons/falling/src",), [Tests("lgs_falling_tests", "*")]),
    "terrain": (("addons/box2d/include", "addons/box2d/src", "addons/box2d/both", "addons/box2d/v2"),
                [Tests("lgs_box2d_tests", "*")]),
    "WebAssembly": (("web/wasm",), [Package(path.name) for path in sorted((ROOT / "web/package/test").glob("*.test.js"))
                                    if path.name.removesuffix(".test.js") not in NOT_OF_MODULES]),
}
HEART = ("engine", "brushes", "views", "checker")


@cache
def text_of(file: str) -> str:
    return (ROOT / file).read_text()


@dataclass(frozen=True)
class Mutant:
    component: str
    file: str
    change: Change

    def plant(self, text: str) -> str:
        return text[:self.change.start] + self.change.text + text[self.change.end:]

    def lines(self) -> tuple[str, str]:
        """The lines that are changed: before, and after."""
        text = text_of(self.file)
        first = text.rfind("\n", 0, self.change.start) + 1
        last = text.find("\n", self.change.end)
        return (" ".join(text[first:last].split()),
                " ".join((text[first:self.change.start] + self.change.text + text[self.change.end:last]).split()))

    def __str__(self) -> str:
        was, now = self.lines()
        line = text_of(self.file).count("\n", 0, self.change.start) + 1
        return f"{self.file}:{line}: {was} ==> {now}"


def mutants_of(component: str) -> list[Mutant]:
    paths = sorted(path for folder in COMPONENTS[component][0] for path in (ROOT / folder).rglob("*")
                   if path.suffix in (".h", ".cpp") and "tests" not in path.parts
                   and path.name != "reference.cpp")  # which is for the article
    return [Mutant(component, file, change) for file in (str(path.relative_to(ROOT)) for path in paths)
            for change in changes_of(text_of(file))]


def read_explained() -> dict[tuple[str, str, str], str]:
    """Mutants that no test can tell from the code, and why: file, line as it was, line as the mutant has it."""
    explained, file = {}, ""
    for line in EXPLAINED.read_text().splitlines():
        if line.startswith("  "):
            change, _, why = line.strip().partition("  // ")
            was, _, now = change.partition(" ==>")
            explained[file, was, now.strip()] = why
        elif not line.startswith("#"):
            file = line
    return explained


def stale(explained: dict) -> list[str]:
    """Explanations of lines that are no more."""
    return [f"{EXPLAINED.name}: {file} has no such line: {was}" for file, was, _ in explained
            if not (ROOT / file).is_file() or was not in " ".join(text_of(file).split())]
