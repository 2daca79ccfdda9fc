"""Tests of a component that are programs of GoogleTest's."""

from dataclasses import dataclass
from pathlib import Path

import programs
from workshop import Workshop


@dataclass(frozen=True)
class Program:
    name: str
    pattern: str = "*"  # a filter
    runs: tuple[tuple[str, str], ...] = ()  # others that its tests run: the target, and the program that it makes


class GoogleTests:
    sources = ()

    def __init__(self, *tests: Program):
        self.tests = tests

    def kind(self, file: str) -> str:
        return "batches" if file.endswith(".h") else "tests"

    def build(self, workshop: Workshop, kind: str) -> list[Path]:
        others = [other for program in self.tests for other in program.runs]
        workshop.build(kind, *(program.name for program in self.tests), *(target for target, _ in others))
        names = [program.name for program in self.tests] + [name for _, name in others]
        return [workshop.program(kind, name) for name in names]

    def measure(self, workshop: Workshop, kind: str, limit: float, environment: dict[str, str]):
        times, cpu = {}, 0.0
        for program in self.tests:
            result = self.run_one(program, program.pattern, workshop, kind, limit, environment)
            if result["verdict"] != "passes":
                return result, {}
            times.update({f"{program.name}:{test}": t for test, t in programs.times(workshop.folder).items()})
            cpu += result["cpu"]
        return {"verdict": "passes", "cpu": cpu}, times

    def run(self, workshop: Workshop, kind: str, tests: tuple[str, ...], limit: float,
            environment: dict[str, str]) -> dict:
        """Each is named by its program, too. One program after the other, until a test fails."""
        cpu = 0.0
        for program in self.tests:
            mine = [test.removeprefix(f"{program.name}:") for test in tests if test.startswith(f"{program.name}:")]
            if not mine:
                continue
            result = self.run_one(program, ":".join(mine), workshop, kind, limit - cpu, environment)
            cpu += result["cpu"]
            if result["verdict"] != "passes":
                return {**result, "cpu": round(cpu, 2)}
        return {"verdict": "passes", "cpu": round(cpu, 2)}

    def run_one(self, program: Program, pattern: str, workshop: Workshop, kind: str, limit: float,
                environment: dict[str, str]) -> dict:
        return programs.run_tests(workshop.program(kind, program.name), pattern, workshop.folder, limit, environment)
