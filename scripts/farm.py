#!/usr/bin/env python3
"""The tests at length, on as many machines as there are: work units, and a ledger that loses nothing.

    scripts/farm.py plan --naive 400 --cgal 40 --laws 4 --canary -o out/farm/plan.jsonl
    scripts/farm.py run out/farm/plan.jsonl --jobs 2           # all units, or some: an index, or FIRST-LAST
    scripts/farm.py merge out/farm/plan.jsonl out/farm/results # totals, and what was found

A unit takes ten to twenty minutes of a core, does the same wherever it runs, and ends in one file of JSON. `run` skips
units that passed; so the same command goes on where it stopped. Units that were killed, or ran out of memory, are lost:
they have neither passed nor failed, and are run again.

Exit status of `run`: 0 all passed; 42 a finding; 75 something was lost, try again; 130 stopped by Ctrl-C. Of `merge`: 75
units are missing, whatever the others say; else 42 findings, or a canary that was not found; else 0. 2 is bad usage.
More: scripts/farm/README.md
"""
import argparse
import concurrent.futures
import re
import signal
import subprocess
import sys
from datetime import date
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent / "farm"))
import ledger
import work
from units import KINDS, OUT, ROOT, read_plan, split, split_fuzz

STATUS = {work.PASS: 0, work.FINDING: 42, work.LOST: 75}


def whole(text: str) -> int:
    if not re.fullmatch(r"\d{1,9}", text):
        raise argparse.ArgumentTypeError(f"'{text}' is not a whole number below 10^9")
    return int(text)


def commit_here() -> str:
    git = ["git", "-C", str(ROOT)]
    done = subprocess.run([*git, "rev-parse", "HEAD"], text=True, capture_output=True, check=False)
    if done.returncode != 0:
        raise ValueError("a plan names the commit of its code: this is no clone")
    if subprocess.run([*git, "diff", "--quiet", "HEAD"], check=False).returncode != 0:
        raise ValueError("there are changes that are not committed: a plan names the commit of its code")
    return done.stdout.strip()


def plan(arguments: argparse.Namespace) -> int:
    commit, seed = commit_here(), arguments.seed
    units = []
    for kind, total in (("cgal", arguments.cgal), ("naive", arguments.naive), ("laws", arguments.laws),
                        ("brushes", arguments.brushes), ("bugs", arguments.bugs), ("mutants", arguments.mutants)):
        units += split(commit, kind, total, arguments.scale, seed, arguments.count)
    units += split_fuzz(commit, arguments.fuzz, seed)
    if arguments.canary:
        units += split(commit, "canary", 1, 0.25, date.today().toordinal())
    arguments.output.parent.mkdir(parents=True, exist_ok=True)
    arguments.output.write_text("".join(unit.line() + "\n" for unit in units), encoding="utf-8")
    print(f"{len(units)} units in {arguments.output}")
    return 0


def chosen(units: list, words: list[str]) -> list:
    """By index from 0, as schedulers count: 7, or 0-9."""
    indices = []
    for word in words:
        if not (found := re.fullmatch(r"(\d{1,18})(?:-(\d{1,18}))?", word)):
            raise ValueError(f"'{word}' is no index, and no range such as 0-9")
        first, last = int(found[1]), int(found[2] or found[1])
        if last < first:
            raise ValueError(f"the range {word} ends before it begins")
        if last >= len(units):
            raise ValueError(f"there is no unit {last}: the plan has {len(units)}, from 0 on")
        indices += range(first, last + 1)
    return [units[k] for k in dict.fromkeys(indices)] if words else units


def run(arguments: argparse.Namespace) -> int:
    units = chosen(read_plan(arguments.plan), arguments.units)
    if units and not arguments.build_is_right and (here := commit_here()) != units[0].commit:
        raise ValueError(f"the plan is for commit {units[0].commit[:12]}, and this is {here[:12]}")
    known = ledger.Ledger(units, ledger.read([arguments.to]))
    left = [unit for unit in units if unit not in known.having(work.PASS)]
    print(f"{len(units) - len(left)} units passed before; {len(left)} to do", flush=True)

    def do(unit):
        if result := work.run(unit, arguments.build.resolve()):
            ledger.write(arguments.to, result)  # here, so that nothing which was done waits for anything
        return result

    worst = 0
    pool = concurrent.futures.ThreadPoolExecutor(arguments.jobs)
    try:
        running = [pool.submit(do, unit) for unit in left]
        for count, future in enumerate(concurrent.futures.as_completed(running), 1):
            result = future.result()
            worst = max(worst, STATUS[result["outcome"]], key=[0, 75, 42].index)
            words = result["finding"].strip().partition("\n")[0] or result["why"]
            print(f"[{count}/{len(left)}] {result['unit']}: {result['outcome']}, {result['seconds']:.0f} s"
                  + (f": {words}" if words else ""), flush=True)
    except KeyboardInterrupt:
        work.stop()
        print("stopped; what has passed is written down. The same command goes on", flush=True)
        worst = 130
    finally:
        pool.shutdown(cancel_futures=True)
    return worst


def merge(arguments: argparse.Namespace) -> int:
    now = ledger.Ledger(read_plan(arguments.plan), ledger.read(arguments.results))
    print(now.told())
    if now.missing:
        return 75
    return 42 if now.having(work.FINDING) or now.dead_canaries() else 0


def show(arguments: argparse.Namespace) -> int:
    known = ledger.Ledger(read_plan(arguments.plan), ledger.read([arguments.left] if arguments.left else []))
    for index, unit in enumerate(known.counted):
        if not arguments.left:
            print(f"{index}\t{unit.key}\t{KINDS[unit.kind].about}")
        elif known.counted[unit] is None:
            print(index)
    return 0


def parser() -> argparse.ArgumentParser:
    first, rest = __doc__.split("\n\n", 1)
    top = argparse.ArgumentParser(description=first, epilog=rest, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = top.add_subparsers(dest="command", required=True, metavar="COMMAND")

    def add(name: str, does, about: str) -> argparse.ArgumentParser:
        sub = commands.add_parser(name, help=about, description=about)
        sub.set_defaults(does=does)
        return sub

    sub = add("plan", plan, "Make the list of units, a line of JSON each")
    for kind in ("cgal", "naive", "laws", "brushes", "bugs", "mutants"):
        sub.add_argument(f"--{kind}", metavar="N", type=whole, default=0, help=f"so many {KINDS[kind].about}")
    sub.add_argument("--fuzz", metavar="MINUTES", type=whole, default=0, help="of fuzzing, over all targets")
    sub.add_argument("--canary", action="store_true", help="with today's canary, a planted bug that must be found")
    sub.add_argument("--seed", metavar="N", type=whole, default=1, help="where blocks and samples begin (default: 1)")
    sub.add_argument("--scale", metavar="X", type=float, default=0.5, help="LGS_TEST_SCALE of laws, brushes and bugs")
    sub.add_argument("--count", metavar="N", type=whole, help="so many in a unit; default: what takes some 15 minutes")
    sub.add_argument("-o", "--output", metavar="PLAN", type=Path, default=OUT / "plan.jsonl", help=f"default: {OUT.name}/plan.jsonl")

    sub = add("run", run, "Run units of a plan that have not passed yet")
    sub.add_argument("plan", metavar="PLAN", type=Path)
    sub.add_argument("units", metavar="INDEX", nargs="*", help="from 0 on: 7, or 0-9; default: all")
    sub.add_argument("--to", metavar="DIR", type=Path, default=OUT / "results", help="where results go (default: out/farm/results)")
    sub.add_argument("--jobs", metavar="N", type=whole, default=1, help="units side by side (default: 1)")
    sub.add_argument("--build", metavar="DIR", type=Path, default=ROOT / "build/release", help="with the programs, built")
    sub.add_argument("--build-is-right", action="store_true", help="the code here is not that of the plan, and the build is")

    sub = add("merge", merge, "Add up results, and tell what was found")
    sub.add_argument("plan", metavar="PLAN", type=Path)
    sub.add_argument("results", metavar="DIR", type=Path, nargs="+")

    sub = add("show", show, "List the units of a plan with their indices")
    sub.add_argument("plan", metavar="PLAN", type=Path)
    sub.add_argument("--left", metavar="DIR", type=Path, help="only the indices of units that have no result there")
    return top


def main() -> int:
    arguments = parser().parse_args()
    signal.signal(signal.SIGTERM, signal.default_int_handler)  # as schedulers end what they began
    try:
        return arguments.does(arguments)
    except (OSError, ValueError) as error:
        print(f"farm.py: {error}", file=sys.stderr)
        return 2


if __name__ == "__main__":
    sys.exit(main())
