"""Runs a unit: starts its program, and reads what came of it."""

import contextlib
import itertools
import os
import re
import resource
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import findings
from units import KINDS, ROOT, Unit

LIMIT = 2 * 3600  # seconds; a unit that takes longer is lost
PASS, FINDING, LOST = "pass", "finding", "lost"

COMMITS = re.compile(r"^(\d+) commits, (\d+) compared with CGAL, (\d+) with the naive reference; (\d+) edits", re.M)


def program(name: str, build: Path) -> str:
    folder = {"lgs_fuzz": "fuzz", "lgs_brush_tests": "proptests/brush"}.get(name, "proptests")
    return str(build / folder / name)


def command(unit: Unit, build: Path, scratch: Path) -> tuple[list[str], dict[str, str]]:
    """What a unit runs, and its environment beside that of this process."""
    numbers = range(unit.number, unit.number + unit.count)
    tests = [program(KINDS[unit.kind].program, build)]
    seed = {"LGS_TEST_SCALE": f"{unit.scale:g}", "LGS_TEST_SEED": str(unit.seed + unit.number)}
    if unit.kind in ("cgal", "naive"):
        law = "AgreesWithBothReferences" if unit.kind == "cgal" else "AgreesWithTheNaiveReference"
        blocks = ":".join(f"Bulk/Bulk.{law}/{k}" for k in numbers)
        # A block is the same at any scale that has so many.
        return tests + ["--gtest_filter=" + blocks], {"LGS_TEST_SCALE": str(numbers.stop // 16 + 1),
                                                     "LGS_TEST_SEED": str(unit.seed)}
    if unit.kind == "laws":
        return tests + ["--gtest_filter=-Bulk*"], seed
    if unit.kind == "brushes":
        return tests, seed
    if unit.kind == "fuzz":
        return tests + ["smoke", unit.target, str(ROOT / "fuzz/corpus" / unit.target), "--seconds",
                        str(60 * unit.count), "--seed", str(unit.seed + unit.number), "--out", str(scratch)], {}
    planting = [sys.executable, str(ROOT / "proptests/bugs/run.py"), "--jobs", "1", "--results", str(scratch / "bugs.jsonl")]
    if unit.kind == "canary":
        return planting + ["--canary", str(unit.seed), "--scale", f"{unit.scale:g}"], {}
    planting += ["--numbers", f"{numbers.start}-{numbers.stop - 1}"]
    if unit.kind == "mutants":
        return planting + ["--mutants", "--sample", str(numbers.stop), "--seed", str(unit.seed)], {}
    return planting + ["--scale", f"{unit.scale:g}"], {}


@contextlib.contextmanager
def workshops():
    """A folder for planted bugs and mutants that no other unit on this machine uses. It is kept, since what was built
    there serves the next one."""
    import fcntl
    for number in itertools.count():
        folder = ROOT / "build" / "farm" / str(number)
        folder.mkdir(parents=True, exist_ok=True)
        with (folder / "taken").open("w") as lock:
            try:
                fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
            except BlockingIOError:
                continue
            yield folder
            return


def outcome_of(status: int) -> str:
    """By the exit status of a program. One that was killed from outside said nothing about the code."""
    if status == 0:
        return PASS
    crashes = {-signal.SIGSEGV, -signal.SIGABRT, -signal.SIGBUS, -signal.SIGFPE, -signal.SIGILL}
    return FINDING if status == 1 or status in crashes else LOST


def figures_of(text: str) -> dict[str, int]:
    sums = [sum(map(int, column)) for column in zip(*COMMITS.findall(text))] or [0, 0, 0, 0]
    executions = sum(int(n) for n in re.findall(r"(\d+) (?:executions|inputs)", text))
    return dict(zip(["commits", "cgal", "naive", "edits"], sums)) | {"executions": executions}


def run(unit: Unit, build: Path) -> dict:
    """The result of a unit, as its line of JSON has it."""
    with tempfile.TemporaryDirectory(prefix="lgs-farm-") as folder, workshops() as own:
        words, extra = command(unit, build, Path(folder))
        extra["LGS_WORKSHOPS"] = str(own)
        before, begin = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
        log = Path(folder) / "log"
        why = ""
        with log.open("wb") as output:
            try:
                status = subprocess.run(words, cwd=folder, env=os.environ | extra, stdout=output, stdin=subprocess.DEVNULL,
                                        stderr=subprocess.STDOUT, timeout=LIMIT, check=False).returncode
            except subprocess.TimeoutExpired:
                status, why = -signal.SIGKILL, f"it ran for more than {LIMIT} s"
            except OSError as error:
                status, why = 127, str(error)
        text = log.read_text(encoding="utf-8", errors="replace")
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        outcome = outcome_of(status)
        found = findings.read(text, Path(folder)) if outcome == FINDING else []
        if outcome == FINDING and not found:
            found = [findings.without_trace(unit.kind, text, words, extra)]
        if outcome == LOST and not why:
            why = f"killed by {signal.Signals(-status).name}" if status < 0 else f"exit status {status}: {text[-300:]}"
        cpu = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
        return {"unit": unit.key, "outcome": outcome, "why": why, "findings": found, "figures": figures_of(text),
                "seconds": round(time.monotonic() - begin, 1), "cpu": round(cpu, 1),
                "memory": after.ru_maxrss * 1024, "host": os.environ.get("LGS_FARM_HOST", os.uname().nodename),
                "when": time.strftime("%Y-%m-%dT%H:%M:%SZ", time.gmtime())}
