"""What looks for a bug: tests of GoogleTest's, tests of the npm package, a fuzz target, the command `lgs check`.

A finder knows how a workshop must be built for it (`kind`), which targets make which programs (`targets`), and looks
(`search`, which is told where a program is). The answer is a dictionary with a verdict, "found", "passes" or
"time-out"; by which test; seconds of CPU; and how many calls are left after shrinking."""

import json
import os
import re
import shutil
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from bugs import ROOT, Wrong
from workshop import Workshop, make, run

# What is said of a case that used up its time, or the program's: not that the code is wrong.
TIME_OUT = re.compile(r"hung (asleep )?for \d+ s|CPU time limit exceeded")
REPORT = "report.json"
# What tests of a program run: the target, and the program that it makes.
RUN_BY = {"lgs_engines_tests": {"lgs_cli": "lgs", "lgs-bench": "lgs-bench"}}


@dataclass(frozen=True)
class Tests:
    """Some tests of a program of GoogleTest's: those that match a filter."""
    program: str
    filter: str
    seed: int = 1
    scale: float = 1.0
    limit: float = 300  # seconds of CPU

    kind = "tests"

    @property
    def targets(self) -> dict[str, str]:
        return {self.program: self.program, **RUN_BY.get(self.program, {})}

    def search(self, shop: Workshop, program: Callable[[str], Path]) -> dict:
        report = shop.folder / REPORT
        report.unlink(missing_ok=True)
        ran = run([program(self.program), f"--gtest_filter={self.filter}", "--gtest_fail_fast",
                   f"--gtest_output=json:{report}"], self.limit,
                  {"TMPDIR": str(shop.folder), "LGS_TEST_SEED": str(self.seed), "LGS_TEST_SCALE": str(self.scale)} |
                  ({"LGS_COMMAND": str(program("lgs"))} if self.program in RUN_BY else {}))
        if ran.status == 0:
            return {"verdict": "passes", "seconds": ran.seconds}
        failed = re.search(r"\[  FAILED  \] ([^\s,]+)", ran.output)
        begun = re.findall(r"\[ RUN      \] (\S+)", ran.output)
        test = failed[1] if failed else begun[-1] if begun else "before the first test"
        said = ran.output.partition(f"[ RUN      ] {test}\n")[2].partition("[  FAILED  ]")[0]
        result = {"verdict": "time-out" if ran.timed_out or TIME_OUT.search(said) else "found", "by": test,
                  "seconds": ran.seconds}
        recorded = next((t for t in reported(shop) if t["name"] == test), {})
        return result | {to: int(recorded[key]) for key, to in (("cases", "case"), ("shrunk_edits", "calls"))
                         if key in recorded} | ({} if failed else {"how": "crashes"})


def reported(shop: Workshop) -> list[dict]:
    """What the tests have recorded that ran last: GoogleTest of their times, and they of their failures."""
    try:
        suites = json.loads((shop.folder / REPORT).read_text())["testsuites"]
    except (OSError, ValueError):
        return []
    return [{**test, "name": f"{suite['name']}.{test['name']}"} for suite in suites for test in suite["testsuite"]]


@dataclass(frozen=True)
class Fuzz:
    """A target searches: one that reads records from nothing, one that reads texts from its corpus, as it takes
    millions of tries to hit on a whole map. What it finds must be reported in the log, too."""
    target: str
    executions: int

    kind, limit = "fuzz", 1_800

    @property
    def targets(self) -> dict[str, str]:
        return {name: name for name in (f"fuzz_{self.target}", "lgs_fuzz")}

    def search(self, shop: Workshop, program: Callable[[str], Path]) -> dict:
        out = shop.folder / "findings"
        shutil.rmtree(out, ignore_errors=True)
        out.mkdir(parents=True)
        options = ["-max_len=1024"]
        dictionary = shop.tree / "fuzz" / "dictionaries" / f"{self.target}.dict"
        if dictionary.exists():  # what is new goes there, not into the project's corpus
            shutil.unpack_archive(shop.tree / f"fuzz/corpus/{self.target}.tar", out / "corpus")
            options = ["-max_len=4096", f"-dict={dictionary}", out / "corpus"]
        fixed = ["-seed=1", f"-runs={self.executions}", f"-artifact_prefix={out}/"]
        ran = run([program(f"fuzz_{self.target}"), *fixed, *options], self.limit,
                  {"LGS_FUZZ_OUT": str(out), "LGS_FUZZ_SHRINK": "5"})
        text = ran.output
        tries = re.findall(r"^#(\d+)", text, re.MULTILINE)
        result = {"by": f"fuzz:{self.target}", "seconds": ran.seconds, "case": int(tries[-1]) if tries else 0}
        if ran.status == 0 or ran.timed_out:
            return {"verdict": "time-out" if ran.timed_out else "passes", **result}
        unit = re.search(r"Test unit written to (\S+)", text)
        if unit and "FINDING in " not in text:  # it crashed: shrunk in child processes
            text += run([program("lgs_fuzz"), "report", self.target, unit[1], "--out", out], self.limit).output
        told = "FINDING in " in text and (not list(out.glob("*.trace"))
                                          or re.search(r"^(trace|saved) .*\.trace$", text, re.MULTILINE))
        return {"verdict": "found" if told else "its report is lost", **result, **shrunk(out)}


def shrunk(folder: Path) -> dict:
    """How many calls are left in a trace that was saved there."""
    for trace in folder.glob("*.trace"):
        lines = [line.split("#")[0].split() for line in trace.read_text().splitlines()]
        return {"calls": sum(bool(line) and line[0] not in ("lgs-trace", "preserve", "commit") for line in lines)}
    return {}


@dataclass(frozen=True)
class Command:
    """`lgs check`, for each seed. It is bounded by edits, so that the answer is the same on each
    machine, and begins nothing more once it has taken a minute. What it takes is told in CPU seconds, up to the
    mismatch, without shrinking."""
    edits: int
    seeds: tuple[int, ...] = (1, 2, 3)

    kind, limit = "tests", 600
    targets = {"lgs_cli": "lgs"}

    def search(self, shop: Workshop, program: Callable[[str], Path]) -> dict:
        seconds, out = 0.0, shop.folder / "check"
        for seed in self.seeds:
            if seconds > 60:
                return {"verdict": "passes", "seconds": round(seconds, 2), "how": "a minute is over"}
            words = ["check", "--edits", str(self.edits), "--seed", str(seed)]
            command = [program("lgs"), *words, "--out", out, "--shrink"]
            shutil.rmtree(out, ignore_errors=True)
            ran = run([*command, 0], self.limit, memory="unlimited")
            seconds += ran.seconds
            if ran.status != 0:
                break
        else:
            return {"verdict": "passes", "seconds": round(seconds, 2)}
        result = {"verdict": "time-out" if ran.timed_out else "found", "by": " ".join(["lgs", *words]),
                  "seconds": round(seconds, 2)}
        if how := re.search(r"crashed with \w+|hung (asleep )?for \d+ s", ran.output):
            result["how"] = how[0]
        if not ran.timed_out and "hung" not in result.get("how", ""):
            run([*command, 60], self.limit, memory="unlimited")
            result |= shrunk(out)
        return result


@dataclass(frozen=True)
class Suites:
    """Suites of others, as `lgs check` plays them."""
    paths: tuple[str, ...]

    kind, limit = "tests", 600
    targets = Command.targets

    def search(self, shop: Workshop, program: Callable[[str], Path]) -> dict:
        out = shop.folder / "check"
        ran = run([program("lgs"), "check", "--suite", *self.paths, "--out", out, "--shrink", 0], self.limit,
                  memory="unlimited")
        case = re.search(r"^case +(.*)$", ran.output, re.MULTILINE)
        return {"verdict": "passes" if ran.status == 0 else "time-out" if ran.timed_out else "found",
                "by": Path(case[1]).name if case else "the suites", "seconds": ran.seconds}


@dataclass(frozen=True)
class Replay:
    """Traces of proptests/regressions whose names begin so, as CTest replays them."""
    begin: str

    kind, limit = "tests", 60
    targets = Command.targets

    def search(self, shop: Workshop, program: Callable[[str], Path]) -> dict:
        seconds = 0.0
        for trace in sorted((ROOT / "proptests/regressions").glob(f"{self.begin}*.trace")):
            ran = run([program("lgs"), "replay", trace, "--check", "--views"], self.limit, memory="unlimited")
            seconds += ran.seconds
            if ran.status != 0:
                return {"verdict": "time-out" if ran.timed_out else "found", "by": f"lgs replay {trace.name}",
                        "seconds": round(seconds, 2)}
        return {"verdict": "passes", "seconds": round(seconds, 2)}


MODULES = {"lgs_web": "lgs.wasm", "lgs_web_full": "lgs-full.wasm", "lgs_web_islands": "lgs-islands.wasm"}
PACKAGE = Path("web/package")
ENTRIES = ("index", "full", "islands", "pieces", "trace", "draw", "planck", "box2d3")  # what needs no module as text


@dataclass(frozen=True)
class Package:
    """A file of tests of the npm package, or those of its tests whose name begins so: FILE:BEGIN. Node runs them."""
    test: str
    limit: float = 600

    kind, targets = "web", MODULES

    def search(self, shop: Workshop, _: Callable[[str], Path]) -> dict:
        file, _, begin = self.test.partition(":")
        native = os.environ.get("LGS_COMMAND", str(ROOT / "build/release/cli/lgs"))  # which some tests compare with
        ran = run(["node", "--test-reporter=tap", f"--test-name-pattern=^{begin}", shop.tree / PACKAGE / "test" / file],
                  self.limit, {"LGS_COMMAND": native}, memory="unlimited")
        failed = re.search(r"^ *not ok \d+ - (.*)$", ran.output, re.MULTILINE)
        verdict = "passes" if ran.status == 0 else "time-out" if ran.timed_out else "found"
        return {"verdict": verdict, "by": f"{file}: {failed[1]}" if failed else file, "seconds": ran.seconds}


def bundle(shop: Workshop) -> list[Path]:
    """Builds the package around the modules, with its types the first time, and returns what of it runs."""
    for needed in ("web/node_modules/.package-lock.json", "build/web-sources/complete"):
        if not (ROOT / needed).exists():
            raise Wrong(f"{needed} is missing: the web side is not set up (scripts/web_setup.sh)")
    package = shop.tree / PACKAGE
    modules = shop.tree / "web/node_modules"
    if not modules.exists():
        modules.symlink_to(ROOT / "web/node_modules")
    if not (package / "dist" / "index.d.ts").exists():
        make(["node", "scripts/build.mjs"], package)
    options = ["--outdir=dist", "--format=esm", "--target=es2022", "--bundle", "--splitting", "--external:planck"]
    make([ROOT / "web/node_modules/.bin/esbuild", *(f"src/{name}.ts" for name in ENTRIES), *options], package)
    for name in MODULES.values():
        shutil.copy(shop.program("web", name), package / "dist")
    return sorted(file for file in (package / "dist").iterdir() if file.suffix in (".js", ".wasm"))
