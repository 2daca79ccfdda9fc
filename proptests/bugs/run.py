#!/usr/bin/env python3
"""Plants bugs in lib/ one at a time and shows which test finds each.

A bug is a substitution in one file of lib/, listed by the law that it breaks in the *.toml files beside this script. For
each one the engine's tests are built with it and run: first the tests of its law, then, if those pass, all others. A bug
that no test finds is a defect of the tests; one that does not apply, or does not compile, is a defect of the list.

Results are kept in out/bugs/ as they come, so that an interrupted run goes on where it was; they hold for the state of
lib/, oracle/ and proptests/ that they were made with. Exit status: 0 when every bug is found, 1 when one is not, 2 when
the list is at fault or the tests fail without any bug.
"""

import argparse
import hashlib
import json
import os
import re
import shutil
import subprocess
import sys
import textwrap
import threading
import time
import tomllib
from concurrent.futures import FIRST_COMPLETED, ThreadPoolExecutor, wait
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
TREE = ROOT / "build" / "bugs" / "tree"
BUILD = ROOT / "build" / "bugs" / "build"
RESULTS = ROOT / "out" / "bugs" / "results.json"
TIME_LIMIT = 180  # seconds for one test; what takes longer hangs, and a hang is found too


@dataclass(frozen=True)
class Law:
    title: str
    tests: list[str]  # prefixes of GoogleTest names, those most to the point first


@dataclass(frozen=True)
class Bug:
    group: str
    name: str
    file: str
    find: str
    replace: str

    def key(self, state: str) -> str:
        return hashlib.sha256("\0".join([state, self.group, self.file, self.find, self.replace]).encode()).hexdigest()


def read_bugs() -> tuple[dict[str, Law], list[Bug]]:
    laws, bugs = {}, []
    for path in sorted(Path(__file__).parent.glob("*.toml")):
        listed = tomllib.loads(path.read_text())
        laws[path.stem] = Law(listed["law"], listed["tests"])
        for bug in listed["bug"]:
            bugs.append(Bug(path.stem, bug["name"], "lib/" + bug["file"], bug["find"], bug["replace"]))
    return laws, bugs


def faults(bugs: list[Bug]) -> list[str]:
    found = []
    for bug in bugs:
        count = (ROOT / bug.file).read_text().count(bug.find)
        if count != 1:
            found.append(f"{bug.group}: {bug.name}: to be found once in {bug.file}, found {count} times")
        if bug.find == bug.replace:
            found.append(f"{bug.group}: {bug.name}: changes nothing")
    for name, count in {b.name: sum(c.name == b.name for c in bugs) for b in bugs}.items():
        if count > 1:
            found.append(f"{count} bugs are called: {name}")
    return found


# --- The tree in which bugs are planted: a copy, so that the working tree stays as it is --------------------------------


def sources() -> list[str]:
    listed = subprocess.run(["git", "ls-files", "-co", "--exclude-standard"], cwd=ROOT, check=True, text=True,
                            capture_output=True).stdout.splitlines()
    return [f for f in listed if (ROOT / f).is_file()]


def state_of(files: list[str]) -> str:
    """Of all that can change a result: the code, its tests, and how they are built."""
    digest = hashlib.sha256()
    for file in sorted(files):
        code = file == "CMakeLists.txt" or file.startswith(("lib/", "oracle/", "proptests/", "cmake/"))
        if code and not file.startswith("proptests/bugs/"):
            digest.update(file.encode() + (ROOT / file).read_bytes())
    return digest.hexdigest()


def copy_tree(files: list[str]) -> None:
    """Writes only what differs, so that little has to be built again."""
    for stale in TREE.rglob("*"):
        if stale.is_file() and str(stale.relative_to(TREE)) not in set(files):
            stale.unlink()
    for file in files:
        source, target = ROOT / file, TREE / file
        if target.exists() and target.read_bytes() == source.read_bytes():
            continue
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(source, target)


def build(jobs: int) -> subprocess.CompletedProcess:
    return subprocess.run(["cmake", "--build", BUILD, "-j", str(jobs), "--target", "lgs_engine_tests"], text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)


def configure() -> None:
    subprocess.run(["cmake", "-S", TREE, "-B", BUILD, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
                    "-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG"], check=True, stdout=subprocess.DEVNULL)


# --- The tests ----------------------------------------------------------------------------------------------------------


def program() -> Path:
    return next(BUILD.rglob("lgs_engine_tests"))


def list_tests() -> list[str]:
    tests, suite = [], ""
    out = subprocess.run([program(), "--gtest_list_tests"], check=True, text=True, capture_output=True).stdout
    for line in out.splitlines():
        if line.endswith("."):
            suite = line
        elif line.startswith("  "):
            tests.append(suite + line.split("#")[0].strip())
    return tests


class Runner:
    """Runs tests side by side until one fails."""

    def __init__(self, jobs: int, seed: int):
        self.jobs, self.seed = jobs, seed
        self.running: set[subprocess.Popen] = set()
        self.lock = threading.Lock()
        self.stopped = False

    def run_one(self, test: str) -> dict | None:
        """What the failure of a test says; None if it passes or was not run to its end."""
        report = BUILD / "reports" / f"{test.replace('/', '-')}.json"
        report.parent.mkdir(exist_ok=True)
        report.unlink(missing_ok=True)
        environment = {**os.environ, "RC_PARAMS": f"seed={self.seed}", "TMPDIR": str(report.parent)}
        begin = time.monotonic()
        with self.lock:
            if self.stopped:
                return None
            process = subprocess.Popen([program(), f"--gtest_filter={test}", f"--gtest_output=json:{report}"],
                                       stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace",
                                       env=environment)
            self.running.add(process)
        try:
            output, _ = process.communicate(timeout=TIME_LIMIT)
        except subprocess.TimeoutExpired:
            process.kill()
            process.communicate()
            output = None
        with self.lock:
            self.running.discard(process)
            if self.stopped or process.returncode == 0:
                return None
        found = {"test": test, "seconds": round(time.monotonic() - begin, 1)}
        if output is None:
            found["how"] = "hangs"
        elif process.returncode != 1:
            found["how"] = "crashes"
        if counted := re.search(r"Falsifiable after (\d+) test", output or ""):
            found["cases"] = int(counted[1])
        found.update(details(report))
        return found

    def stop(self) -> None:
        with self.lock:
            self.stopped = True
            for process in self.running:
                process.kill()

    def first_failure(self, tests: list[str]) -> dict | None:
        self.stopped = False
        with ThreadPoolExecutor(self.jobs) as pool:
            waiting = {pool.submit(self.run_one, test) for test in tests}
            while waiting:
                done, waiting = wait(waiting, return_when=FIRST_COMPLETED)
                failures = [f.result() for f in done if f.result()]
                if failures:
                    self.stop()
                    return failures[0]
        return None


def details(report: Path) -> dict:
    """What a test recorded about its failure: after how many cases, and how small the case was made."""
    try:
        suites = json.loads(report.read_text())["testsuites"]
    except (OSError, ValueError):
        return {}
    test = suites[0]["testsuite"][0]
    return {k: int(test[k]) for k in ("cases", "shrunk_edits") if k in test}


# --- The run ------------------------------------------------------------------------------------------------------------


def in_order(tests: list[str], law: Law) -> tuple[list[str], list[str]]:
    """The tests of a law, as they are listed there; all others."""
    own = [t for prefix in law.tests for t in tests if t.startswith(prefix)]
    own = list(dict.fromkeys(own))
    return own, [t for t in tests if t not in own]


def try_bug(bug: Bug, law: Law, tests: list[str], runner: Runner, jobs: int) -> dict:
    target = TREE / bug.file
    original = target.read_text()
    target.write_text(original.replace(bug.find, bug.replace))
    try:
        built = build(jobs)
        if built.returncode != 0:
            return {"verdict": "does not compile", "output": built.stdout[-2000:]}
        own, others = in_order(tests, law)
        for by_law, some in ((True, own), (False, others)):
            if found := runner.first_failure(some):
                return {"verdict": "found", "by_law": by_law, **found}
        return {"verdict": "SURVIVES"}
    finally:
        target.write_text(original)


def say(result: dict) -> str:
    if result["verdict"] != "found":
        return result["verdict"]
    text = result["test"] + ("" if result["by_law"] else " (of another law)")
    if "how" in result:
        text += f", {result['how']}"
    if "cases" in result:
        text += f", case {result['cases']}"
    if "shrunk_edits" in result:
        text += f", shrunk to {result['shrunk_edits']} edits"
    return text


def table(laws: dict[str, Law], bugs: list[Bug], results: dict[Bug, dict], command: str) -> str:
    found = [r for r in results.values() if r["verdict"] == "found"]
    by_law = sum(r["by_law"] for r in found)
    prose = [
        "Each is planted in `lib/` by itself; then the engine's tests are built and run until one fails: those of the law "
        "that it breaks first, then all others. Made by:",
        f"    {command}",
        f"{len(found)} of {len(bugs)} are found, {by_law} of them by a test of their law.",
        "*Case*: the number of the random case that showed it, or of the world in `SmallWorlds`. *Edits*: how many are left "
        "of that case when it is shrunk. More than four are left where the bug needs them: two chunks, a crowded row, or a "
        "history. Tests that go through all there is of something other than worlds, or through examples, have neither "
        "number; nor has a case that fails only after those before it a number of edits.",
    ]
    lines = ["# Planted bugs", ""]
    for paragraph in prose:
        lines += [paragraph if paragraph.startswith(" ") else textwrap.fill(paragraph, 120), ""]
    for group, law in laws.items():
        lines += [f"## {law.title}", "", "| bug | in | found by | case | edits |", "|---|---|---|---:|---:|"]
        for bug in bugs:
            if bug.group != group or bug not in results:
                continue
            r = results[bug]
            test = r.get("test", r["verdict"])
            test = f"`{test}`" if "test" in r else f"**{test}**"
            test += "" if r.get("by_law", True) else " (of another law)"
            test += f", which {r['how']}" if "how" in r else ""
            lines.append(f"| {bug.name} | `{Path(bug.file).name}` | {test} | {r.get('cases', '')} | "
                         f"{r.get('shrunk_edits', '')} |")
        lines.append("")
    return "\n".join(lines)


def regex(text: str) -> re.Pattern:
    try:
        return re.compile(text)
    except re.error as error:
        raise argparse.ArgumentTypeError(f"'{text}' is no regular expression: {error}") from None


def jobs(text: str) -> int:
    if not re.fullmatch(r"0*[1-9]\d*", text):
        raise argparse.ArgumentTypeError(f"'{text}' is not a whole number from 1 on")
    return int(text)


def report_file(text: str) -> Path:
    path = Path(text)
    if path.is_dir() or not os.access(path if path.exists() else path.parent, os.W_OK):
        raise argparse.ArgumentTypeError(f"'{text}' can not be written")
    return path


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0], epilog=__doc__.split("\n\n", 1)[1],
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--only", metavar="REGEX", type=regex, default="", help="bugs whose group or name matches")
    parser.add_argument("--list", action="store_true", help="list the bugs, see that each applies, and build nothing")
    parser.add_argument("--fresh", action="store_true", help="forget the results of earlier runs")
    parser.add_argument("--jobs", metavar="N", type=jobs, default=os.cpu_count(), help="processes at once (default: all cores)")
    parser.add_argument("--seed", metavar="N", type=int, default=1, help="of the random cases (default: 1)")
    parser.add_argument("--report", metavar="FILE", type=report_file, help="write the table there, as Markdown")
    arguments = parser.parse_args()

    laws, everything = read_bugs()
    bugs = [b for b in everything if arguments.only.search(f"{b.group}: {b.name}")]
    if not bugs:
        parser.error("no bug's name matches that")
    if arguments.list:
        for bug in bugs:
            print(f"{bug.group:22}  {bug.name}")
        print(f"{len(bugs)} bugs")
    if wrong := faults(bugs):
        print(*wrong, sep="\n", file=sys.stderr)
        return 2
    if arguments.list:
        return 0

    files = sources()
    state = state_of(files) + str(arguments.seed)
    stored = json.loads(RESULTS.read_text()) if RESULTS.exists() and not arguments.fresh else {}
    RESULTS.parent.mkdir(parents=True, exist_ok=True)
    runner = Runner(arguments.jobs, arguments.seed)
    live = sys.stdout.isatty()
    results, tests = {}, []

    def show(text: str, lasting: bool = True) -> None:
        if live:
            print("\r\033[K", end="")
        if lasting or live:
            print(text, end="\n" if lasting else "", flush=True)

    for number, bug in enumerate(bugs, 1):
        head = f"[{number}/{len(bugs)}] {bug.group}: {bug.name}"
        key = bug.key(state)
        if key not in stored:
            if not tests:
                show("building and running the tests without a bug …", lasting=False)
                copy_tree(files)
                configure()
                built = build(arguments.jobs)
                if built.returncode != 0:
                    show(built.stdout[-4000:] + "\nrun.py: the tests do not build")
                    return 2
                tests = list_tests()
                if found := runner.first_failure(tests):
                    show(f"run.py: without any bug {found['test']} fails; mend that first")
                    return 2
            show(head + " …", lasting=False)
            stored[key] = try_bug(bug, laws[bug.group], tests, runner, arguments.jobs)
            RESULTS.write_text(json.dumps(stored, indent=1))
        results[bug] = stored[key]
        show(f"{head}: {say(stored[key])}")
        if "output" in stored[key]:
            show(stored[key]["output"])

    if arguments.report:
        only = f" --only '{arguments.only.pattern}'" if arguments.only.pattern else ""
        command = f"proptests/bugs/run.py --seed {arguments.seed}{only} --report {arguments.report}"
        arguments.report.write_text(table(laws, bugs, results, command))
    verdicts = [r["verdict"] for r in results.values()]
    print(f"{verdicts.count('found')} of {len(bugs)} bugs found, {verdicts.count('SURVIVES')} survive, "
          f"{verdicts.count('does not compile')} do not compile")
    return 2 if "does not compile" in verdicts else 1 if "SURVIVES" in verdicts else 0


if __name__ == "__main__":
    sys.exit(main())
