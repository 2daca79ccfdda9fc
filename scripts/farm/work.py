"""Runs a unit: starts its program, and reads what came of it."""

import contextlib
import itertools
import os
import re
import resource
import shlex
import signal
import subprocess
import sys
import tempfile
import threading
import time
from pathlib import Path

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
        return tests + ["smoke", unit.target, str(ROOT / f"fuzz/corpus/{unit.target}.tar"), "--seconds",
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


TRACE = re.compile(r"^lgs-trace \d\n(?:.+\n)*\n?(?:.+\n)*", re.M)  # with the paragraph that says what is wrong
FAILED = re.compile(r"^\[  FAILED  \] [\w/.]+|^.*: .*(?:SURVIVES|lives).*$", re.M)


def finding_of(text: str) -> str:
    """The shrunk trace that a failing program printed; or the names of what failed; or its last words."""
    return next((found[0] for found in TRACE.finditer(text)), "") or "\n".join(sorted(set(FAILED.findall(text)))) or text[-4_000:]


# The programs at work. stop() ends them, and no other is begun.
_running: set[subprocess.Popen] = set()
_lock = threading.Lock()
_is_stopped = False


def stop() -> None:
    global _is_stopped
    with _lock:
        _is_stopped = True
        for process in _running:
            with contextlib.suppress(ProcessLookupError):
                os.killpg(process.pid, signal.SIGKILL)


def wait_for(words: list[str], folder: str, environment: dict[str, str], log: Path) -> tuple[int, str]:
    """The exit status of a program, and why it has none of its own. It leads a group of processes, to be ended with it."""
    with log.open("wb") as output:
        with _lock:
            if _is_stopped:
                return -signal.SIGINT, "stopped"
            try:
                process = subprocess.Popen(words, cwd=folder, env=environment, stdout=output, stdin=subprocess.DEVNULL,
                                           stderr=subprocess.STDOUT, start_new_session=True)
            except OSError as error:
                return 127, str(error)
            _running.add(process)
        try:
            return process.wait(LIMIT), ""
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            process.wait()
            return -signal.SIGKILL, f"it ran for more than {LIMIT} s"
        finally:
            with _lock:
                _running.discard(process)


def run(unit: Unit, build: Path) -> dict | None:
    """The result of a unit, as its line of JSON has it; None if it was stopped."""
    with tempfile.TemporaryDirectory(prefix="lgs-farm-") as folder, workshops() as own:
        words, extra = command(unit, build, Path(folder))
        extra["LGS_WORKSHOPS"] = str(own)
        before, begin = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
        log = Path(folder) / "log"
        status, why = wait_for(words, folder, os.environ | extra, log)
        if _is_stopped and status != 0:
            return None
        text = log.read_text(encoding="utf-8", errors="replace")
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        outcome = outcome_of(status)
        if outcome == LOST and not why:
            why = f"killed by {signal.Signals(-status).name}" if status < 0 else f"exit status {status}: {text[-300:]}"
        cpu = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
        return {"unit": unit.key, "outcome": outcome, "why": why, "figures": figures_of(text),
                "finding": finding_of(text) if outcome == FINDING else "",
                "again": " ".join([*(f"{k}={v}" for k, v in extra.items()), shlex.join(words)]),
                "seconds": round(time.monotonic() - begin, 1), "cpu": round(cpu, 1), "host": os.uname().nodename,
                "when": time.strftime("%Y-%m-%dT%H:%M:%SZ", time.gmtime())}
