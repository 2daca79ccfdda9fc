"""Tests of a component that are a program of GoogleTest's."""

from dataclasses import dataclass
from pathlib import Path

import programs
from workshop import Workshop


@dataclass(frozen=True)
class GoogleTests:
    program: str
    pattern: str = "*"  # a filter

    sources = ()

    def kind(self, file: str) -> str:
        return "batches" if file.endswith(".h") else "tests"

    def build(self, workshop: Workshop, kind: str) -> list[Path]:
        workshop.build(kind, self.program)
        return [workshop.program(kind, self.program)]

    def measure(self, workshop: Workshop, kind: str, limit: float, environment: dict[str, str]):
        result = self.run(workshop, kind, (self.pattern,), limit, environment)
        return result, programs.times(workshop.folder)

    def run(self, workshop: Workshop, kind: str, tests: tuple[str, ...], limit: float,
            environment: dict[str, str]) -> dict:
        program = workshop.program(kind, self.program)
        return programs.run_tests(program, ":".join(tests), workshop.folder, limit, environment)
