#!/usr/bin/env python3
"""Measures everything and writes it down: figures as JSON, the tables of the docs.

    bench/report/run.py            all of it, some minutes; refreshes docs/timings.md and README.md
    bench/report/run.py --quick    smaller worlds, half a minute; leaves the docs alone

The figures need a quiet machine. If Node is here and polygon-clipping is not, npm installs it.
"""

import argparse
import datetime
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys

from results import Results
from tables import TABLES

ROOT = pathlib.Path(__file__).resolve().parents[2]
DOCS = (ROOT / "docs/timings.md", ROOT / "README.md")

# For `lgs bench`: how many rounds, by the side of the worlds, and whether all subjects run. The rest is for lgs_bench.
FULL = {
    "rounds": {10: 5, 32: 5, 316: 1, 100: 5}, "all": True, "max_cells": 10_000_000, "edits": 20_000, "min_time": 0.3,
}
QUICK = {
    "rounds": {10: 3, 32: 3, 100: 3}, "all": False, "max_cells": 1_000_000, "edits": 5_000, "min_time": 0.05,
}
TINY = {
    "rounds": {10: 1}, "all": False, "max_cells": 100, "edits": 20, "min_time": 0.001,
}


def say(text):
    print(text, flush=True)


def run(command, **options):
    """Runs a command; ends with its message if it fails."""
    done = subprocess.run([str(word) for word in command], cwd=ROOT, text=True, **options)
    if done.returncode != 0:
        if done.stdout:
            print(done.stdout, file=sys.stderr)
        sys.exit(f"run.py: that failed, with status {done.returncode}: {' '.join(map(str, command))}")
    return done.stdout


def build():
    setup = ROOT / "examples/engines"
    if shutil.which("npm") and not (setup / "node_modules").exists():
        say("installing polygon-clipping")
        done = subprocess.run(["npm", "ci", "--silent", "--no-audit", "--no-fund"], cwd=setup, check=False)
        if done.returncode != 0:
            say(f"npm failed, with status {done.returncode}: its rows will be missing")
    say("building")
    quiet = {"stdout": subprocess.PIPE, "stderr": subprocess.STDOUT}
    run(["cmake", "--preset", "release"], **quiet)
    run(["cmake", "--build", "--preset", "release", "--target", "lgs_cli", "lgs-bench", "lgs_bench"], **quiet)
    return ROOT / "build/release"


def compare(folder, out, scale):
    """The rows of `lgs bench`. Where two runs have the same scenario, the later run wins."""
    rows = []
    for side, rounds in scale["rounds"].items():
        say(f"comparing in worlds of {side}×{side} cells")
        file = out / f"comparison-{side}.json"
        command = [folder / "cli/lgs", "bench", "--side", side, "--rounds", rounds, "--json", file]
        text = run(command + (["--all"] if scale["all"] and side == 100 else []), stdout=subprocess.PIPE)
        (out / f"comparison-{side}.txt").write_text(text)
        for line in text.splitlines():
            if ": skipped, " in line:
                say(f"  {line}")
        rows += json.loads(file.read_text())
    return rows


def measure(folder, out, scale):
    say(f"measuring the engine in worlds of up to {scale['max_cells']:,} cells")
    file = out / "engine.json"
    options = [f"--max_cells={scale['max_cells']}", f"--edits={scale['edits']}"]
    options += [f"--benchmark_min_time={scale['min_time']}", f"--benchmark_out={file}"]
    run([folder / "bench/lgs_bench", *options], stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    return json.loads(file.read_text())


def machine():
    model = re.search(r"model name\s*: (.*)", pathlib.Path("/proc/cpuinfo").read_text())
    memory = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES") / 2**30
    return f"{model.group(1) if model else 'unknown processor'}, {os.cpu_count()} cores, {memory:.0f} GiB"


def commit():
    def git(*words):
        return subprocess.run(["git", *words], cwd=ROOT, capture_output=True, text=True, check=False).stdout.strip()

    own = ["--", ".", ":!docs", ":!README.md"]  # what this program writes itself
    return (git("rev-parse", "--short=10", "HEAD") or "unknown") + (" and changes" if git("status", "-s", *own) else "")


def refresh(results, paths):
    """Puts each table between its markers, <!-- timings: NAME --> and <!-- end -->."""
    for path in paths:
        parts = re.compile(r"(<!-- timings: (\w+) -->\n).*?(<!-- end -->)", re.S)
        text = path.read_text()
        path.write_text(parts.sub(lambda m: f"{m[1]}{TABLES[m[2]](results)}\n{m[3]}", text))


def read_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    size = parser.add_mutually_exclusive_group()
    size.add_argument("--quick", action="store_true", help="measure smaller worlds; leave the docs alone")
    size.add_argument("--tiny", action="store_true", help="measure the smallest worlds, for the tests")
    parser.add_argument("--build", type=pathlib.Path, metavar="DIR",
                        help="measure what is built there; default: build the release preset")
    parser.add_argument("--out", type=pathlib.Path, metavar="DIR", default=ROOT / "out/bench",
                        help="for figures and tables; default out/bench")
    return parser.parse_args()


def main():
    arguments = read_arguments()
    scale = QUICK if arguments.quick else TINY if arguments.tiny else FULL

    out = arguments.out.resolve()
    out.mkdir(parents=True, exist_ok=True)
    folder = arguments.build.resolve() if arguments.build else build()
    comparison = compare(folder, out, scale)
    engine = measure(folder, out, scale)
    about = {
        "machine": machine(),
        "compiler": engine["context"]["compiler"],
        "commit": commit(),
        "command": "bench/report/run.py" + (" --quick" if arguments.quick else " --tiny" if arguments.tiny else ""),
        "date": datetime.date.today().isoformat(),
    }
    results = Results(about, comparison, engine["benchmarks"])
    results.write_json(out / "results.json")
    say(f"figures: {out / 'results.json'}")
    docs = DOCS
    if scale is not FULL:
        docs = [out / path.name for path in DOCS]
        for source, copy in zip(DOCS, docs):
            shutil.copy(source, copy)
    refresh(results, docs)
    say(f"tables: {', '.join(str(path) for path in docs)}")


if __name__ == "__main__":
    main()
