"""Runs tests and fuzz targets within a limit of CPU time, and says what became of them."""

import json
import os
import re
import shutil
import signal
import subprocess
import tempfile
import threading
from dataclasses import dataclass
from pathlib import Path

# What a test says of a case that used up its time, or the program's: not that the code is wrong.
TIME_OUT = re.compile(r"hung (asleep )?for \d+ s|CPU time limit exceeded")
REPORT = "report.json"  # of the tests that ran last in a folder
MEMORY = 6_000_000  # KiB that a process may have: a bug may ask for all there is


@dataclass(frozen=True)
class Ran:
    status: int  # negative: the signal that ended it
    seconds: float  # of CPU, those of its child processes included
    output: str

    @property
    def timed_out(self) -> bool:
        return self.status in (-signal.SIGXCPU, -signal.SIGKILL)


def run(command: list, limit: float, environment: dict[str, str] | None = None, memory: int | str = MEMORY) -> Ran:
    """Ends a process that takes more CPU seconds than `limit`, and a program that sleeps, after ten times as long."""
    limited = f"ulimit -S -t {int(limit) + 1}; ulimit -c 0; ulimit -v {memory}; exec \"$@\""
    with tempfile.TemporaryFile() as output:
        process = subprocess.Popen(["sh", "-c", limited, "sh", *map(str, command)], stdin=subprocess.DEVNULL,
                                   stdout=output, stderr=subprocess.STDOUT, start_new_session=True,
                                   env={**os.environ, **(environment or {})})
        asleep = threading.Timer(10 * limit + 60, os.killpg, (process.pid, signal.SIGKILL))
        asleep.start()
        _, raw, usage = os.wait4(process.pid, 0)
        asleep.cancel()
        process.returncode = os.waitstatus_to_exitcode(raw)
        output.seek(0)
        text = output.read().decode(errors="replace")
    return Ran(process.returncode, round(usage.ru_utime + usage.ru_stime, 2), text)


# --- Tests ------------------------------------------------------------------------------------------------------------


def list_tests(program: Path) -> list[str]:
    tests, suite = [], ""
    for line in subprocess.run([program, "--gtest_list_tests"], check=True, text=True,
                               capture_output=True).stdout.splitlines():
        if line.startswith("  "):
            tests.append(suite + line.split("#")[0].strip())
        elif "." in line:
            suite = line.split("#")[0].strip()
    return tests


def run_tests(program: Path, pattern: str, folder: Path, limit: float, environment: dict[str, str]) -> dict:
    """Runs the tests that match until one fails. The verdict is "passes", "found" or "time-out"."""
    (folder / REPORT).unlink(missing_ok=True)
    ran = run([program, f"--gtest_filter={pattern}", "--gtest_fail_fast", f"--gtest_output=json:{folder / REPORT}"],
              limit, {"TMPDIR": str(folder), **environment})
    result = {"verdict": "passes", "cpu": ran.seconds}
    if ran.status == 0:
        return result
    failed = re.search(r"\[  FAILED  \] ([^\s,]+)", ran.output)
    begun = re.findall(r"\[ RUN      \] (\S+)", ran.output)
    result["test"] = failed[1] if failed else begun[-1] if begun else "before the first test"
    said = ran.output.partition(f"[ RUN      ] {result['test']}\n")[2].partition("[  FAILED  ]")[0]
    result["verdict"] = "time-out" if ran.timed_out or TIME_OUT.search(said) else "found"
    if not failed:
        result["how"] = "crashes"
    recorded = next((t for t in reported(folder) if t["name"] == result["test"]), {})
    result.update({k: int(recorded[k]) for k in ("cases", "shrunk_edits") if k in recorded})
    return result


def reported(folder: Path) -> list[dict]:
    """What the tests that ran there last have recorded: by GoogleTest, and by themselves about their failure."""
    try:
        suites = json.loads((folder / REPORT).read_text())["testsuites"]
    except (OSError, ValueError):
        return []
    return [{**test, "name": f"{suite['name']}.{test['name']}"} for suite in suites for test in suite["testsuite"]]


def times(folder: Path) -> dict[str, float]:
    """Of the tests that ran there last, in seconds of the clock."""
    return {test["name"]: float(test["time"].rstrip("s")) for test in reported(folder)}


# --- Fuzz targets -----------------------------------------------------------------------------------------------------


def run_target(programs: Path, target: str, corpus: Path, folder: Path, executions: int, limit: float) -> dict:
    """Lets a target search: one that reads records from nothing, one that reads texts from its corpus, as it takes
    millions of tries to hit on a whole map. The verdict is "SURVIVES", "found", "time-out" or "its report is lost"."""
    shutil.rmtree(folder, ignore_errors=True)
    findings = folder / "findings"
    findings.mkdir(parents=True)
    options = ["-max_len=1024"]
    dictionary = corpus.parent / "dictionaries" / f"{target}.dict"
    if dictionary.exists():
        shutil.unpack_archive(corpus / f"{target}.tar", folder / "corpus")
        options = ["-max_len=4096", f"-dict={dictionary}", folder / "corpus"]
    fixed = ["-seed=1", f"-runs={executions}", f"-artifact_prefix={findings}/"]
    ran = run([programs / f"fuzz_{target}", *fixed, *options], limit,
              {"LGS_FUZZ_OUT": str(findings), "LGS_FUZZ_SHRINK": "5"})
    text = ran.output
    tries = re.findall(r"^#(\d+)", text, re.MULTILINE)
    result = {"test": f"fuzz:{target}", "cpu": ran.seconds, "executions": int(tries[-1]) if tries else 0}
    if ran.status == 0:
        return {"verdict": "SURVIVES", **result}
    if ran.timed_out:
        return {"verdict": "time-out", **result}
    unit = re.search(r"Test unit written to (\S+)", text)
    if unit and "FINDING in " not in text:  # it crashed: shrunk in child processes
        text += run([programs / "lgs_fuzz", "report", target, unit[1], "--out", findings], limit).output
    (folder / "log").write_text(text)
    traces = list(findings.glob("*.trace"))
    told = "FINDING in " in text and (not traces or re.search(r"^(trace|saved) .*\.trace$", text, re.MULTILINE))
    if traces:
        lines = traces[0].read_text().splitlines()
        result["shrunk_edits"] = sum(line.startswith(("add", "remove")) for line in lines)
    return {"verdict": "found" if told else "its report is lost", **result}
