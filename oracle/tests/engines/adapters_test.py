#!/usr/bin/env python3
"""Adapters of libraries under the harness: each departs from the laws as docs/reports/engines.md says, in no other way.

    oracle/tests/engines/adapters_test.py LGS NAME [FILE.so]

Exit status 77, with a word, where the library is missing.
"""
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[3]
ENGINES = ROOT / "examples/engines"
PYTHONS = [sys.executable, "/usr/bin/python3"]  # Debian's packages are for Debian's Python
PACKAGES = ENGINES / "node_modules"

# What an engine is assumed to be able to do, and the kinds of findings that there must be then; some of them of regions.
LINKS = {"ghosts squares merged": {"wrong link"}}
RUNS = {
    "shapely": {"several slants": set(), "ghosts several slants": {"wrong link"}},
    "polygon-clipping": {"squares merged": set(), "several slants merged": {"missing cut"}} | LINKS,
    "clipper": {"squares merged": set(), "several slants merged": {"missing cut", "order of edits matters"}} | LINKS,
    "shapely regions": {"slants regions round=1 cells=1000": set(), "regions": set()},
    "boost regions": {"slants regions round=1": {"extra solid", "missing solid", "no boundary"}},
    "lgs regions": {"ghosts blocks slants preserve regions round=1": set(), "regions": set()},
    "polygon-clipping regions": {"slants regions round=1 cells=1000": {"crash"}},
    "ioverlay regions": {"slants regions round=1": set()},
}


def runs(*command):
    try:
        return subprocess.run(command, capture_output=True, check=False).returncode == 0
    except OSError:
        return False


def skip(what):
    print(f"skipped: {what} is not there")
    sys.exit(77)


def python(script):
    """Runs a script by a Python that has Shapely."""
    runner = next((p for p in PYTHONS if runs(p, "-c", "import shapely")), None) or skip("Shapely (python3-shapely)")
    return ["--engine", shlex.join(["exec", runner, str(ENGINES / script)])]


def regions(name, files):
    """The same of an engine of regions."""
    if files:
        return ["--engine", shlex.join(["exec", *files])]
    if name == "shapely regions":
        return python("shapely_regions.py")
    package = {"polygon-clipping regions": "polygon-clipping", "ioverlay regions": "ishape_wasm"}[name]
    script = ENGINES / (name.replace("-", "_").replace(" ", "_") + ".mjs")
    there = (PACKAGES / package).is_dir() and runs("node", "--version")
    return ["--engine", shlex.join(["exec", "node", str(script)])] if there else skip(f"{package} (npm ci --prefix examples/engines)")


def engine(name, files):
    """The options of lgs that name the engine."""
    if name.endswith(" regions"):
        return regions(name, files)
    if name == "clipper":
        return ["--engine-so", files[0]] if files else skip("Clipper (libpolyclipping-dev)")
    if name == "polygon-clipping":
        script = ENGINES / "polygon_clipping.cjs"
        there = (PACKAGES / "polygon-clipping").is_dir() and runs("node", "--version")
        return ["--engine", f"exec node {shlex.quote(str(script))}"] if there else skip("polygon-clipping (npm ci --prefix examples/engines)")
    return python("shapely_engine.py")


def kinds(lgs, options, assumed):
    """The kinds of findings in some edits."""
    with tempfile.TemporaryDirectory() as folder:
        worlds = ["--case-edits", "15"] if "regions" in assumed else []  # all strokes are united anew at each commit
        command = [lgs, "check", *options, *worlds, "--assume", assumed]
        edits = "1200" if "--engine-so" in options else "200"  # which is quick
        command += ["--edits", edits, "--shrink", "0", "--report", folder]
        done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
        report = pathlib.Path(folder, "report.md")
        if done.returncode not in (0, 1) or not report.is_file():
            sys.exit(f"{shlex.join(command)}\n{done.stdout}{done.stderr}")
        return set(re.findall(r"^\| ([^|]+) \| \d+ \|", report.read_text(encoding="utf-8"), re.MULTILINE))


def main():
    lgs, name, *files = sys.argv[1:]
    options = engine(name, files)
    wrong = {}
    for assumed, must in RUNS[name].items():
        found = kinds(lgs, options, assumed)
        if found != must and not ("regions" in assumed and found and found < must):
            wrong[assumed] = found
    for assumed, found in wrong.items():
        print(f"{name}, assumed '{assumed}': found {sorted(found)}, not {sorted(RUNS[name][assumed])}")
    sys.exit(1 if wrong else 0)


main()
