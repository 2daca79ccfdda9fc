"""Work units: what is to be done, as values. A unit says by itself all that decides what it does, so it may run
anywhere, twice, and in any order."""

import dataclasses
import json
import math
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
OUT = ROOT / "out" / "farm"


@dataclasses.dataclass(frozen=True, order=True)
class Unit:
    commit: str  # of the code
    kind: str  # a name in KINDS
    number: int  # which blocks, seeds, bugs or slices: from this one on
    count: int  # so many of them
    scale: float  # of kinds that have one
    seed: int
    target: str = ""  # of fuzzing

    @property
    def key(self) -> str:
        words = [self.kind, self.target, str(self.number), f"n{self.count}", f"x{self.scale:g}", f"seed{self.seed}"]
        return "-".join([self.commit[:12], *filter(None, words)])

    def line(self) -> str:
        return json.dumps(dataclasses.asdict(self))


@dataclasses.dataclass(frozen=True)
class Kind:
    about: str
    count: int  # of a unit that takes ten to twenty minutes of a core
    program: str  # what must be built, in a preset's folder


# In minutes of one core of a machine of two cores (AMD EPYC): a block of cgal 4 s, of naive 3 s; all other laws 6
# minutes at scale 0.5; a planted bug or a mutant some half a minute.
KINDS = {
    "cgal": Kind("numbered blocks: the engine against CGAL and the naive reference", 200, "lgs_engine_tests"),
    "naive": Kind("numbered blocks: the engine against the naive reference", 250, "lgs_engine_tests"),
    "laws": Kind("all other laws of the engine, by seed", 1, "lgs_engine_tests"),
    "brushes": Kind("the laws of brushes, by seed", 1, "lgs_brush_tests"),
    "fuzz": Kind("a slice of fuzzing: minutes of one target, by seed", 10, "lgs_fuzz"),
    "bugs": Kind("planted bugs by their place in the list: all must be found", 20, ""),
    "mutants": Kind("mutants of a random sample: none may live", 20, ""),
    "canary": Kind("a planted bug that the seed draws: the numbered blocks must find it", 1, ""),
}
TARGETS = sorted(path.stem for path in (ROOT / "fuzz" / "corpus").glob("*.tar"))


def split(commit: str, kind: str, total: int, scale: float, seed: int, most: int | None = None) -> list[Unit]:
    """Units that together do `total` of a kind, `most` each."""
    most = most or KINDS[kind].count
    return [Unit(commit, kind, first, min(most, total - first), scale, seed) for first in range(0, total, most)]


def split_fuzz(commit: str, minutes: int, seed: int) -> list[Unit]:
    """The minutes are shared out evenly. No two slices of a target begin from the same seed."""
    slices = math.ceil(minutes / KINDS["fuzz"].count)
    return [Unit(commit, "fuzz", k // len(TARGETS), KINDS["fuzz"].count, 1.0, seed, TARGETS[k % len(TARGETS)])
            for k in range(slices)]


def read_plan(path: Path) -> list[Unit]:
    units = []
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        try:
            unit = Unit(**json.loads(line))
        except (ValueError, TypeError) as error:
            raise ValueError(f"{path}:{number}: this is no unit: {error}") from None
        if unit.kind not in KINDS:
            raise ValueError(f"{path}:{number}: there is no kind '{unit.kind}'")
        units.append(unit)
    if len({unit.key for unit in units}) != len(units):
        raise ValueError(f"{path}: a unit comes twice")
    return units
