"""Mutants: where they come from, and what the tests make of them."""

import argparse
import functools
import hashlib
import threading
import tomllib
from dataclasses import dataclass
from pathlib import Path

import pool
from components import COMPONENTS
from results import Results
from rules import Change, changes_of
from workshop import ROOT, AtFault, DoesNotBuild, Workshop, state_of

VERDICTS = ("killed", "lives", "time-out", "same code", "does not compile")
QUICK = (0.05, 0.5)  # seconds: tests that take less are run before the others
EXPLAINED = Path(__file__).parent / "equivalent.toml"


@functools.cache
def text_of(file: str) -> str:
    return (ROOT / file).read_text()


@dataclass(frozen=True)
class Mutant:
    component: str
    file: str
    change: Change

    def text(self) -> str:
        text = text_of(self.file)
        return text[:self.change.start] + self.change.text + text[self.change.end:]

    def lines(self) -> tuple[str, str]:
        """The lines that are changed: before, and after."""
        text = text_of(self.file)
        first = text.rfind("\n", 0, self.change.start) + 1
        last = text.find("\n", self.change.end)
        return text[first:last], text[first:self.change.start] + self.change.text + text[self.change.end:last]

    def place(self) -> str:
        return f"{self.file}:{text_of(self.file).count(chr(10), 0, self.change.start) + 1}"

    def diff(self) -> str:
        before, after = self.lines()
        shown = [f"-{line}" for line in before.splitlines()] + [f"+{line}" for line in after.splitlines()]
        return "\n".join([f"{self.place()} {self.change.rule}", *shown])

    def words(self) -> list:
        """What a result depends on, beside the state of the code."""
        return [self.file, self.change.start, self.change.end, self.change.text]


def mutants_of(component: str) -> list[Mutant]:
    return [Mutant(component, file, change) for file in files_of(component) for change in changes_of(text_of(file))]


def files_of(component: str) -> list[str]:
    files = sorted(str(path.relative_to(ROOT)) for folder in COMPONENTS[component].folders
                   for path in (ROOT / folder).rglob("*") if path.suffix in (".h", ".cpp"))
    return [file for file in files if file not in COMPONENTS[component].without]


# --- Those that are explained -----------------------------------------------------------------------------------------


def squeezed(text: str) -> str:
    return " ".join(text.split())


class Explained:
    """equivalent.toml: mutants that no test can tell from the code, and why."""

    def __init__(self):
        listed = tomllib.loads(EXPLAINED.read_text()).get("mutant", [])
        self.why = {(m["file"], squeezed(m["was"]), squeezed(m["is"])): m["why"] for m in listed}

    def of(self, mutant: Mutant) -> str | None:
        before, after = mutant.lines()
        return self.why.get((mutant.file, squeezed(before), squeezed(after)))

    def stale(self) -> list[str]:
        """Entries whose line is no more."""
        return [f"{file}: {was}" for file, was, _ in self.why
                if not (ROOT / file).is_file() or was not in squeezed(text_of(file))]


# --- The tests --------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Batch:
    """Tests that are run together."""
    tests: tuple[str, ...]
    limit: float  # seconds of CPU


class Bench:
    """A workshop and how to try a mutant there."""

    preparing = threading.Lock()
    batches: dict[str, list[Batch]] = {}  # by component

    def __init__(self, workshop: Workshop, seed: int, scale: float):
        self.workshop = workshop
        self.environment = {"LGS_TEST_SCALE": str(scale), "LGS_TEST_SEED": str(seed)}
        self.clean: dict[tuple[str, str], bytes] = {}  # of a build and a component: the digest without a mutant

    def build(self, kind: str, name: str) -> bytes:
        """Builds the tests of a component, and gives a digest of what they run."""
        digest = hashlib.sha256()
        for built in COMPONENTS[name].tests.build(self.workshop, kind):
            digest.update(built.read_bytes())
        return digest.digest()

    def prepare(self, kind: str, name: str) -> None:
        if (kind, name) in self.clean:
            return
        try:
            digest = self.build(kind, name)
        except DoesNotBuild as error:
            raise AtFault(f"without any mutant the tests of {name} do not build:\n{error}") from error
        self.clean[kind, name] = digest
        with self.preparing:
            if name not in self.batches:
                self.batches[name] = self.measure(kind, name)

    def measure(self, kind: str, name: str) -> list[Batch]:
        """The tests by how long they take."""
        result, times = COMPONENTS[name].tests.measure(self.workshop, kind, 3_600, self.environment)
        if result["verdict"] != "passes":
            raise AtFault(f"without any mutant {result['test']} fails; mend that first")
        a_second = result["cpu"] / max(sum(times.values()), 0.01)  # of the clock, in CPU seconds
        batches, least = [], 0.0
        for most in (*QUICK, 1e9):
            tests = tuple(t for t in sorted(times, key=times.get) if least <= times[t] < most)
            if tests:
                batches.append(Batch(tests, 10 + 5 * a_second * sum(times[t] for t in tests)))
            least = most
        return batches

    def try_mutant(self, mutant: Mutant) -> dict:
        name, tests = mutant.component, COMPONENTS[mutant.component].tests
        kind = tests.kind(mutant.file)
        self.prepare(kind, name)
        with self.workshop.changed(mutant.file, mutant.text()):
            try:
                digest = self.build(kind, name)
            except DoesNotBuild:
                return {"verdict": "does not compile"}
            if digest == self.clean[kind, name]:
                return {"verdict": "same code"}
            for batch in self.batches[name]:
                result = tests.run(self.workshop, kind, batch.tests, batch.limit, self.environment)
                if result["verdict"] != "passes":
                    return {**result, "verdict": "killed" if result["verdict"] == "found" else "time-out"}
        return {"verdict": "lives"}


def run(mutants: list[Mutant], files: list[str], results: Results, arguments: argparse.Namespace, show) -> None:
    """show(mutant, result) for each: those that are known first."""
    waiting = []
    sources = {COMPONENTS[mutant.component].tests.sources for mutant in mutants}
    states = {folders: [state_of(files, folders)] if folders else [] for folders in sources}

    def words(mutant: Mutant) -> list:
        return [*states[COMPONENTS[mutant.component].tests.sources], *mutant.words()]

    for mutant in mutants:
        known = results.get(*words(mutant))
        if known and known["verdict"] != arguments.again:
            show(mutant, known)
        else:
            waiting.append(mutant)

    def done(mutant: Mutant, result: dict) -> None:
        show(mutant, results.put(result, *words(mutant)))

    pool.spread(waiting, files, arguments.jobs, lambda w: Bench(w, arguments.seed, arguments.scale).try_mutant, done)
