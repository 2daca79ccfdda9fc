"""Plants a bug in a workshop, builds what looks for it, and lets it look."""

import argparse
import dataclasses
import hashlib
import shutil
from pathlib import Path

import finders
from bugs import Bug, Wrong
from finders import Command, Fuzz, Package, Replay, Suites, Tests
from mutants import COMPONENTS, Mutant
from results import Results
from workshop import DoesNotBuild, Workshop

# The code that `lgs check` sees: the engine, what follows from it, and the checker itself.
SEEN = ("lib/", "oracle/")
QUICK = 0.05  # seconds: tests that take less look for a mutant before the others


def method(arguments: argparse.Namespace) -> str:
    if arguments.score:
        return f"lgs check, {arguments.edits} edits"
    if arguments.suite:
        return f"suites {' '.join(Path(path).name for path in arguments.suite)}"
    return f"fuzz {arguments.fuzz}" if arguments.fuzz else "tests"


class Bench:
    """A workshop, and its programs as they are without a bug."""

    def __init__(self, shop: Workshop, arguments: argparse.Namespace, results: Results):
        self.shop, self.arguments, self.results = shop, arguments, results
        self.clean: dict[tuple, bytes] = {}  # digests of programs, by how and for what they were built
        self.passed: set = set()  # finders that find nothing without a bug
        self.split: dict[Tests, list[Tests]] = {}

    def attempt(self, bug: Bug | Mutant) -> dict:
        looking = self.finders(bug)
        is_header = looking[0].kind == "tests" and bug.file.endswith(".h") and not self.arguments.built
        kind = "headers" if is_header else looking[0].kind
        targets = {target: name for finder in looking for target, name in finder.targets.items()}
        self.prepare(kind, targets, looking)
        if isinstance(bug, Mutant):
            looking = [part for finder in looking for part in self.by_speed(kind, finder)]
        with self.shop.changed(bug.file, bug.plant((self.shop.tree / bug.file).read_text())):
            try:
                seconds, digest = self.build(kind, targets)
            except DoesNotBuild as error:
                return {"verdict": "does not compile", "output": str(error)[-2000:]}
            built = {"built": round(seconds, 1)}
            if digest == self.clean[kind, *targets]:
                unseen = {"verdict": "passes", "seconds": 0.0, "how": "the command has none of it"}
                return (unseen if self.arguments.score else {"verdict": "same code"}) | built
            finder, outcome = self.look(looking, kind, isinstance(bug, Bug) and bug.group.each)
        if outcome["verdict"] == "found" and isinstance(finder, Tests):
            self.must_pass(kind, dataclasses.replace(finder, filter=outcome["by"]))
            if isinstance(bug, Bug) and not outcome["by"].startswith(bug.group.tests):
                outcome["how"] = "of another group"
        return outcome | built

    def finders(self, bug: Bug | Mutant) -> list:
        a = self.arguments
        if a.score:
            return [Command(a.edits)]
        if a.suite:
            return [Suites(tuple(a.suite))]
        if a.fuzz:
            return [Fuzz(bug.fuzz if a.fuzz == "own" else a.fuzz, a.executions)]
        if isinstance(bug, Mutant):
            return [dataclasses.replace(f, seed=a.seed, scale=a.scale or 0.02) if isinstance(f, Tests) else f
                    for f in COMPONENTS[bug.component][1]]
        if bug.group.program == "node":
            return [Package(test) for test in bug.group.tests]
        if bug.group.program == "lgs":
            return [Command(a.edits) if test == "check" else Replay(test) for test in bug.group.tests]
        own = [f"{prefix}*" for prefix in bug.group.tests]
        if a.built:  # in a bounded time
            return [Tests(bug.group.program, text, a.seed, a.scale or 1.0, limit=120) for text in own]
        last = self.results.last(bug).get("by", "")
        filters = [*([last] if last.startswith(bug.group.tests) else []), *own, "*-" + ":".join(own)]
        return [Tests(bug.group.program, text, a.seed, a.scale or 1.0) for text in filters]

    def look(self, looking: list, kind: str, each: bool) -> tuple:
        """Stops at the first that finds it; at the first that does not, where each must."""
        seconds = 0.0
        for finder in looking:
            outcome = finder.search(self.shop, lambda name: self.shop.program(kind, name))
            seconds += outcome["seconds"]
            if outcome["verdict"] != ("found" if each else "passes"):
                break
        return finder, outcome | {"seconds": round(seconds, 2)}

    # --- Without a bug

    def prepare(self, kind: str, targets: dict[str, str], looking: list) -> None:
        # Of tests in a program only the one that will have found something is run without a bug.
        unseen = [finder for finder in looking if not isinstance(finder, Tests) and finder not in self.passed]
        if (kind, *targets) in self.clean and not unseen:
            return
        try:
            _, self.clean[kind, *targets] = self.build(kind, targets)
        except DoesNotBuild as error:
            raise Wrong(f"without any bug {' '.join(targets)} does not build:\n{error}") from error
        self.kept(kind).mkdir(parents=True, exist_ok=True)
        for name in targets.values():
            shutil.copy(self.shop.program(kind, name), self.kept(kind))
        for finder in unseen:
            self.must_pass(kind, finder)

    def kept(self, kind: str) -> Path:
        return self.shop.folder / "clean" / kind

    def must_pass(self, kind: str, finder) -> None:
        if finder in self.passed:
            return
        outcome = finder.search(self.shop, lambda name: self.kept(kind) / name)
        if outcome["verdict"] != "passes":
            raise Wrong(f"without any bug there is {outcome}; mend that first")
        self.passed.add(finder)

    def by_speed(self, kind: str, finder) -> list:
        """Tests of a program in two parts: the quick ones, which find most mutants, and the others."""
        if not isinstance(finder, Tests):
            return [finder]
        if finder not in self.split:
            self.must_pass(kind, dataclasses.replace(finder, limit=3_600))
            ran = {test["name"]: float(test["time"].rstrip("s")) for test in finders.reported(self.shop)}
            parts = [([name for name in ran if (ran[name] < QUICK) == quick],
                      20 + 10 * sum(t for t in ran.values() if (t < QUICK) == quick)) for quick in (True, False)]
            self.split[finder] = [dataclasses.replace(finder, filter=":".join(part), limit=limit)
                                  for part, limit in parts if part]
        return self.split[finder]

    def build(self, kind: str, targets: dict[str, str]) -> tuple[float, bytes]:
        """Builds them, and returns the seconds of CPU that it took, and a digest of what will be run."""
        seconds = self.shop.build(kind, *targets)
        programs = [self.shop.program(kind, name) for name in targets.values()]
        files = finders.bundle(self.shop) if kind == "web" else programs
        digest = hashlib.sha256()
        for file in files:
            digest.update(file.read_bytes())
        return seconds, digest.digest()
