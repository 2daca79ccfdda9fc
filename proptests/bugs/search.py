"""Plants bugs and lets tests or fuzz targets look for them."""

import shutil
from dataclasses import dataclass

import pool
import programs
from listed import Bug, Group
from results import Results
from workshop import AtFault, DoesNotBuild, Workshop

TEST_LIMIT = 300  # seconds of CPU for the tests of one prefix, and for a case in a process of its own
FUZZ_LIMIT = 1_800  # for all executions


@dataclass(frozen=True)
class Plan:
    method: str  # tests, fuzz, fuzz:TARGET
    seed: int
    scale: float
    executions: int
    groups: dict[str, Group]

    def target(self, bug: Bug) -> str:
        return self.method.partition(":")[2] or bug.fuzz

    def words(self, bug: Bug) -> list:
        """What a result depends on, beside the state of the code."""
        by = [self.seed, self.scale] if self.method == "tests" else [self.target(bug), self.executions]
        return [*by, bug.group, bug.file, bug.find, bug.replace]


class Bench:
    """A workshop, its programs without a bug, and how to try a bug there."""

    def __init__(self, workshop: Workshop, plan: Plan, results: Results):
        self.workshop, self.plan, self.results = workshop, plan, results
        self.clean = workshop.folder / "clean"
        self.ready: dict[str, list[str]] = {}  # a program's tests

    def try_bug(self, bug: Bug) -> dict:
        attempt = self.with_tests if self.plan.method == "tests" else self.with_target
        return attempt(bug)

    def plant(self, bug: Bug):
        return self.workshop.changed(bug.file, bug.change((self.workshop.tree / bug.file).read_text()))

    def build_clean(self, kind: str, *targets: str) -> None:
        """The programs as they are without a bug, kept aside."""
        if all(t in self.ready for t in targets):
            return
        try:
            self.workshop.build(kind, *targets)
        except DoesNotBuild as error:
            raise AtFault(f"without any bug {' '.join(targets)} does not build:\n{error}") from error
        self.clean.mkdir(exist_ok=True)
        for target in targets:
            shutil.copy(self.workshop.program(kind, target), self.clean / target)
            self.ready[target] = programs.list_tests(self.clean / target) if kind == "tests" else []

    # --- Tests

    def with_tests(self, bug: Bug) -> dict:
        group = self.plan.groups[bug.group]
        self.build_clean("tests", group.program)
        if idle := [p for p in group.tests if not any(t.startswith(p) for t in self.ready[group.program])]:
            raise AtFault(f"{bug.group}.toml: no test of {group.program} begins with {', '.join(idle)}")
        own = [f"{prefix}*" for prefix in group.tests]
        with self.plant(bug):
            try:
                self.workshop.build("tests", group.program)
            except DoesNotBuild as error:
                return {"verdict": "does not compile", "output": str(error)[-2000:]}
            program = self.workshop.program("tests", group.program)
            for pattern in [*own, "*-" + ":".join(own)]:
                result = self.run_tests(program, pattern)
                if result["verdict"] != "passes":
                    break
        if result["verdict"] == "passes":
            return {"verdict": "SURVIVES"}
        if result["verdict"] == "found":
            self.see_it_pass(group.program, result["test"])
        return {**result, "by_law": pattern in own}

    def run_tests(self, program, pattern: str) -> dict:
        environment = {"LGS_TEST_SEED": str(self.plan.seed), "LGS_TEST_SCALE": str(self.plan.scale)}
        return programs.run_tests(program, pattern, self.workshop.folder, TEST_LIMIT, environment)

    def see_it_pass(self, program: str, test: str) -> None:
        words = ["clean", program, test, self.plan.seed, self.plan.scale]
        result = self.results.get(*words) or self.results.put(self.run_tests(self.clean / program, test), *words)
        if result["verdict"] != "passes":
            raise AtFault(f"without any bug {test} fails; mend that first")

    # --- Fuzz targets

    def with_target(self, bug: Bug) -> dict:
        target = self.plan.target(bug)
        targets = [f"fuzz_{target}", "lgs_fuzz"]
        self.build_clean("fuzz", *targets)
        with self.plant(bug):
            try:
                self.workshop.build("fuzz", *targets)
            except DoesNotBuild as error:
                return {"verdict": "does not compile", "output": str(error)[-2000:]}
            folder = self.workshop.folder / "fuzz" / "fuzz"
            out = self.workshop.folder / "findings"
            result = programs.run_target(folder, target, self.workshop.tree / "fuzz" / "corpus", out,
                                         self.plan.executions, FUZZ_LIMIT)
        for found in (out / "findings").glob("*.input"):
            if programs.run([self.clean / "lgs_fuzz", "run", target, found, "--out", out], FUZZ_LIMIT).status != 0:
                raise AtFault(f"without any bug fuzz:{target} finds something too; mend that first: {found}")
        return result


def run(plan: Plan, bugs: list[Bug], files: list[str], results: Results, jobs: int, show) -> None:
    waiting = []
    for bug in bugs:
        known = results.get(*plan.words(bug))
        if known:
            show(bug, known)
        else:
            waiting.append(bug)

    def done(bug: Bug, result: dict) -> None:
        show(bug, results.put(result, *plan.words(bug)))

    pool.spread(waiting, files, jobs, lambda workshop: Bench(workshop, plan, results).try_bug, done)
