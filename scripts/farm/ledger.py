"""The ledger: a file for each attempt at a unit, written whole or not at all. Ledgers add up: any number of folders, of
any number of machines, is one ledger."""

import json
import os
import tempfile
from pathlib import Path

from units import Unit
from work import FINDING, PASS


def write(folder: Path, result: dict) -> None:
    """Beside the place, flushed, and renamed: whoever reads meets all of it or nothing."""
    folder.mkdir(parents=True, exist_ok=True)
    handle, name = tempfile.mkstemp(dir=folder, suffix=".part")
    with os.fdopen(handle, "w", encoding="utf-8") as file:
        json.dump(result, file)
        file.write("\n")
        file.flush()
        os.fsync(file.fileno())
    attempt = Path(name).stem.removeprefix("tmp")  # no two attempts, on whatever machine, have one name
    os.rename(name, folder / f"{result['unit']}.{result['host']}-{attempt}.json")


def read(folders: list[Path]) -> dict[str, list[dict]]:
    """All attempts at each unit, by its key."""
    attempts: dict[str, list[dict]] = {}
    for path in sorted(path for folder in folders for path in folder.rglob("*.json")):
        try:
            result = json.loads(path.read_text(encoding="utf-8"))
            attempts.setdefault(result["unit"], []).append(result)
            result["outcome"]  # it is a result
        except (ValueError, KeyError, TypeError) as error:
            raise ValueError(f"{path}: this is no result: {error}") from None
    return attempts


def verdict(attempts: list[dict]) -> dict | None:
    """The attempt that counts: a finding before a pass, and the first of each; None if all are lost."""
    said = [a for a in attempts if a["outcome"] in (FINDING, PASS)]
    return min(said, key=lambda a: (a["outcome"] != FINDING, a["when"]), default=None)


class Ledger:
    """A plan, and what is known of each of its units. No unit counts twice."""

    def __init__(self, plan: list[Unit], attempts: dict[str, list[dict]]):
        self.attempts = {unit: attempts.get(unit.key, []) for unit in plan}
        self.counted = {unit: verdict(of_unit) for unit, of_unit in self.attempts.items()}
        # A unit does the same wherever it runs. If two attempts differ, something that is not in the unit decides.
        self.torn = [unit for unit, of_unit in self.attempts.items()
                     if {PASS, FINDING} <= {a["outcome"] for a in of_unit}]
        self.missing = [unit for unit, result in self.counted.items() if result is None]

    def having(self, outcome: str) -> list[Unit]:
        return [unit for unit, result in self.counted.items() if result and result["outcome"] == outcome]

    def total(self, figure: str) -> int:
        return sum(result["figures"].get(figure, 0) for result in self.counted.values() if result)

    def findings(self) -> dict[str, list[Unit]]:
        """What was found, each once, and the units that found it."""
        found: dict[str, list[Unit]] = {}
        for unit in self.having(FINDING):
            found.setdefault(self.counted[unit]["finding"], []).append(unit)
        return found

    def dead_canaries(self) -> list[Unit]:
        return [unit for unit in self.counted if unit.kind == "canary" and unit not in self.having(PASS)]

    def told(self) -> str:
        """Everything that there is to say, in Markdown."""
        cpu = sum(result["cpu"] for result in self.counted.values() if result)
        lines = [f"{len(self.counted)} units of {', '.join(sorted({unit.commit[:12] for unit in self.counted}))}: "
                 f"{len(self.having(PASS))} passed, {len(self.having(FINDING))} with findings, {len(self.missing)} missing. "
                 f"{self.total('commits'):,} commits, {self.total('cgal'):,} compared with CGAL, "
                 f"{self.total('naive'):,} with the naive reference; {self.total('executions'):,} fuzzed inputs; "
                 f"{cpu / 3600:.2f} CPU hours.", "", self.canary(), ""]
        for words, units in sorted(self.findings().items()):
            lines += [f"## Found {len(units)} times, first in {units[0].key}", "", "```", words.strip(), "```",
                      f"Again: `{self.counted[units[0]]['again']}`", ""]
        lines += [f"- passed and failed, by something that is not in the unit: {unit.key}" for unit in self.torn]
        for unit in self.missing:
            why = "; ".join(sorted({a["why"] for a in self.attempts[unit]}))
            lines.append(f"- missing: {unit.key}, {'lost: ' + why if why else 'never begun'}")
        return "\n".join(lines)

    def canary(self) -> str:
        if dead := self.dead_canaries():
            return f"RED: the canary was not found ({', '.join(unit.key for unit in dead)}). Trust nothing of this run."
        count = sum(unit.kind == "canary" for unit in self.counted)
        return f"The canary was found: {count}." if count else "There is no canary: nothing shows that the run can find a bug."
