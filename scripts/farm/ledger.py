"""The ledger: a file for each attempt at a unit, written whole or not at all. Ledgers add up: any number of folders, of
any number of machines, is one ledger."""

import json
import os
import tempfile
from pathlib import Path

from units import Unit
from work import FINDING, LOST, PASS


def write(folder: Path, result: dict) -> Path:
    """Beside the place, flushed, and renamed: whoever reads meets all of it or nothing."""
    folder.mkdir(parents=True, exist_ok=True)
    handle, name = tempfile.mkstemp(dir=folder, suffix=".part")
    with os.fdopen(handle, "w", encoding="utf-8") as file:
        json.dump(result, file)
        file.write("\n")
        file.flush()
        os.fsync(file.fileno())
    attempt = Path(name).stem.removeprefix("tmp")  # no two attempts, on whatever machine, have one name
    place = folder / f"{result['unit']}.{result['host']}-{attempt}.json"
    os.rename(name, place)
    return place


def read(folders: list[Path]) -> list[dict]:
    results = []
    for path in sorted(path for folder in folders for path in folder.rglob("*.json")):
        try:
            result = json.loads(path.read_text(encoding="utf-8"))
            result["outcome"], result["unit"]  # it is a result
        except (ValueError, KeyError, TypeError) as error:
            raise ValueError(f"{path}: this is no result: {error}") from None
        results.append(result)
    return results


def of_unit(results: list[dict]) -> dict[str, list[dict]]:
    units: dict[str, list[dict]] = {}
    for result in results:
        units.setdefault(result["unit"], []).append(result)
    return units


def verdict(attempts: list[dict]) -> dict | None:
    """The attempt that counts: a finding before a pass, and the first of each; None if all are lost."""
    for outcome in (FINDING, PASS):
        said = sorted((a for a in attempts if a["outcome"] == outcome), key=lambda a: a["when"])
        if said:
            return said[0]
    return None


class Ledger:
    """A plan, and what is known of each of its units. No unit counts twice."""

    def __init__(self, plan: list[Unit], results: list[dict]):
        attempts = of_unit(results)
        planned = {unit.key for unit in plan}
        self.units = plan
        self.counted = {unit: verdict(attempts.get(unit.key, [])) for unit in plan}
        self.lost = {unit: [a for a in attempts.get(unit.key, []) if a["outcome"] == LOST] for unit in plan}
        self.foreign = sorted(key for key in attempts if key not in planned)
        self.attempts = sum(len(attempts.get(unit.key, [])) for unit in plan)
        # A unit does the same wherever it runs. If two attempts differ, something that is not in the unit decides.
        self.torn = [unit for unit in plan
                     if {PASS, FINDING} <= {a["outcome"] for a in attempts.get(unit.key, [])}]

    def having(self, outcome: str) -> list[Unit]:
        return [unit for unit, result in self.counted.items() if result and result["outcome"] == outcome]

    @property
    def missing(self) -> list[Unit]:
        """Lost in each attempt, or never begun."""
        return [unit for unit, result in self.counted.items() if result is None]

    def total(self, figure: str) -> int:
        return sum(result["figures"].get(figure, 0) for result in self.counted.values() if result)

    @property
    def cpu(self) -> float:
        return sum(result["cpu"] for result in self.counted.values() if result)

    def findings(self) -> dict[str, dict]:
        """By id: the one with the shortest trace, how often there was each, and when first and last."""
        found: dict[str, dict] = {}
        for unit, result in self.counted.items():
            for finding in result["findings"] if result else []:
                known = found.setdefault(finding["id"], finding | {"count": 0, "units": [], "first": result["when"],
                                                                   "last": result["when"]})
                if len(finding["trace"]) < len(known["trace"]):
                    known.update(finding)
                known["count"] += 1
                known["units"].append(unit.key)
                known["first"], known["last"] = min(known["first"], result["when"]), max(known["last"], result["when"])
        return found


def compare(before: Ledger, now: Ledger) -> dict[str, str]:
    """What became of each finding between two runs. One that merely stayed away is rare; it is resolved only where the
    unit that found it, with another commit, passes."""
    old, new = before.findings(), now.findings()

    def same_work(key: str) -> str:
        return key.split("-", 1)[1]

    passed = {same_work(unit.key) for unit in now.having(PASS)}
    words = {name: "ongoing" if name in old else "new" for name in new}
    for name in old.keys() - new.keys():
        words[name] = "resolved" if all(same_work(key) in passed for key in old[name]["units"]) else "rare"
    return words
