#!/usr/bin/env python3
"""Plants bugs in the code one at a time and shows what finds each: the tests, a fuzz target, or the one command.

A bug is a substitution in one file, listed in a file *.bugs. For each the tests are built with it and run until one
fails: first the one that found it last time, then those of its group, then all others. With --score `lgs check` looks
for it instead: seeds 1 to 3, bounded by edits. With --mutants the bugs are made by rule. What fails with a bug is run
without it as well, and must pass.

A bug that nothing finds is a defect of the tests; one that does not apply, or does not compile, is a defect of the
list; a test that runs out of CPU time has neither found its bug nor let it pass. Outcomes go into results.jsonl as they
come, each with its commit, so that an interrupted run goes on where it was. Exit status: 0 when every bug is found, 1
when one is not, 2 when the list or the code is at fault.
"""

import argparse
import dataclasses
import os
import random
import re
import sys
import threading
import time
from collections import deque
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import bugs
import mutants
import trying
from bugs import Bug, Wrong
from finished import ROOMS, Finished
from mutants import Mutant
from results import Results, changed_since
from workshop import Workshop, alone


def regex(text: str) -> re.Pattern:
    try:
        return re.compile(text)
    except re.error as error:
        raise argparse.ArgumentTypeError(f"'{text}' is no regular expression: {error}") from None


def span(text: str) -> tuple[int, int]:
    first, _, last = text.partition("-")
    if not (first.isdigit() and last.isdigit() and int(first) <= int(last)):
        raise argparse.ArgumentTypeError(f"'{text}' is no range such as 0-19")
    return int(first), int(last)


def positive(number):
    def parse(text: str):
        if not 0 < number(text) <= 1e12:
            raise ValueError
        return number(text)
    parse.__name__ = "positive number"
    return parse


def parser() -> argparse.ArgumentParser:
    first, rest = __doc__.split("\n\n", 1)
    result = argparse.ArgumentParser(description=first, epilog=rest,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    which = result.add_argument_group("which bugs; all that are listed, if nothing is said")
    which.add_argument("--only", metavar="REGEX", type=regex, help="those whose list or name matches")
    which.add_argument("--changed", metavar="REV", help="those in files that changed since, and new ones")
    which.add_argument("--numbers", metavar="FIRST-LAST", type=span, help="those at these places, from 0 on")
    which.add_argument("--sample", metavar="N", type=positive(int), help="so many of them, drawn by --seed")
    which.add_argument("--canary", metavar="SEED", type=int,
                       help="one bug of laws 1 and 2, drawn by this seed, which the numbered blocks alone must find")
    which.add_argument("--mutants", action="store_true", help="mutants instead of listed bugs")
    which.add_argument("--of", metavar="COMPONENT", choices=mutants.COMPONENTS, nargs="+", default=mutants.HEART,
                       help=f"mutants of {', '.join(mutants.COMPONENTS)}; without it of {', '.join(mutants.HEART)}")
    how = result.add_argument_group("what looks for them")
    how.add_argument("--score", action="store_true", help="the command lgs check, for bugs of what it can see")
    how.add_argument("--suite", metavar="FILE", nargs="+",
                     help="the command with these suites of others, for bugs of brushes")
    how.add_argument("--edits", metavar="N", type=positive(int), default=25_000,
                     help="of the command, for each of three seeds (default: 25000, some 60 s in all)")
    how.add_argument("--fuzz", metavar="TARGET", nargs="?", const="own",
                     help="this fuzz target; or, of the bugs that name one, each bug's own")
    how.add_argument("--executions", metavar="N", type=positive(int), default=100_000, help="of a fuzz target")
    how.add_argument("--built", metavar="BUILD", type=Path,
                     help="plant in copies of single objects of this finished build, and let only what is named look")
    how.add_argument("--scale", metavar="X", type=positive(float), help="LGS_TEST_SCALE (bugs: 1; mutants: 0.02)")
    result.add_argument("--list", action="store_true", help="show them, see that each applies, and build nothing")
    result.add_argument("--seed", metavar="N", type=int, default=1, help="of what is random (default: 1)")
    result.add_argument("--minutes", metavar="N", type=positive(float), default=1e9, help="begin no bug after that")
    result.add_argument("--jobs", metavar="N", type=positive(int), default=os.cpu_count(),
                        help="copies of the project to work in side by side (default: one a core)")
    result.add_argument("--results", metavar="FILE", type=Path, help="default: results.jsonl; of mutants out/bugs/")
    result.add_argument("--fresh", action="store_true", help="try again what was tried at this commit")
    return result


def select(arguments: argparse.Namespace) -> list[Bug | Mutant]:
    if arguments.mutants:
        chosen = [mutant for name in arguments.of for mutant in mutants.mutants_of(name)]
    else:
        chosen = bugs.read_all()
    if arguments.canary is not None:
        bug = random.Random(arguments.canary).choice([b for b in chosen if b.list.startswith(("law1-", "law2-"))])
        bulk = dataclasses.replace(bug.group, program="lgs_engine_tests", tests=("Bulk/",))
        return [dataclasses.replace(bug, group=bulk)]
    if arguments.score:
        of_others = ("other-engines", "regions", "suites")  # what they need is no part of the one command
        chosen = [bug for bug in chosen if bug.file.startswith(trying.SEEN)
                  and getattr(bug, "list", "") not in of_others]
    if arguments.suite:
        chosen = [bug for bug in chosen if bug.file.startswith("lib/brush/")]
    if arguments.built:
        built = Finished(arguments.built)
        any_program = arguments.score or arguments.suite
        programs = {bug.group.program for bug in chosen if not any_program} - {"lgs_cost_tests"}
        programs = {name for name in programs if built.has(name)}
        chosen = [bug for bug in chosen if bug.file.split("/")[0] in ROOMS and "/include/" not in bug.file
                  and (any_program or bug.group.program in programs)]  # what many objects see takes too long
    if arguments.fuzz == "own":
        chosen = [bug for bug in chosen if bug.fuzz]
    if arguments.changed:
        touched, added = changed_since(arguments.changed)
        chosen = [bug for bug in chosen if bug.file in touched or getattr(bug, "name", "") in added]
    if arguments.only:
        chosen = [bug for bug in chosen if arguments.only.search(str(bug))]
    if arguments.sample:
        chosen = random.Random(arguments.seed).sample(chosen, min(arguments.sample, len(chosen)))
    if arguments.numbers:
        chosen = chosen[arguments.numbers[0]:arguments.numbers[1] + 1]
    return chosen


def try_all(arguments: argparse.Namespace, chosen: list, results: Results) -> dict:
    """The outcome of each that was tried. Takes them in order, each to a free workshop. Stops at an error."""
    done, lock, stop = {}, threading.Lock(), threading.Event()
    ends = time.monotonic() + 60 * arguments.minutes
    explained = mutants.read_explained()

    def tell(bug, outcome: dict) -> None:
        if outcome["verdict"] in ("passes", "time-out") and isinstance(bug, Mutant):
            if (bug.file, *bug.lines()) in explained:
                outcome = {**outcome, "verdict": "explained"}
        done[bug] = outcome
        print(f"[{len(done)}/{len(chosen)}] {bug}: {say(outcome)}", flush=True)

    def work(number: int) -> None:
        try:
            shop = (Finished(arguments.built, number) if arguments.built
                    else Workshop(number, max(1, (os.cpu_count() or 1) // jobs)))
            bench = trying.Bench(shop, arguments, results)
            while not stop.is_set() and time.monotonic() < ends:
                with lock:
                    if not waiting:
                        return
                    bug = waiting.popleft()
                outcome = bench.attempt(bug)
                with lock:
                    tell(bug, results.put(bug, outcome))
        except BaseException:
            stop.set()
            raise

    for bug in chosen:
        if known := None if arguments.fresh else results.of_now(bug):
            tell(bug, known)
    # File by file, since the one that was changed before is compiled again, too. Headers at the end: they take longest.
    waiting = deque(sorted((bug for bug in chosen if bug not in done), key=lambda b: (b.file.endswith(".h"), b.file)))
    jobs = min(arguments.jobs, len(waiting))
    if waiting:
        with alone(), ThreadPoolExecutor(jobs) as threads:
            try:
                for future in [threads.submit(work, number) for number in range(jobs)]:
                    future.result()
            finally:
                stop.set()  # after Ctrl-C no other is begun
    return done


def say(outcome: dict) -> str:
    if outcome["verdict"] == "does not compile":
        return "\n".join(["does not compile", *outcome.get("output", "").splitlines()])
    words = {"by": "{}", "how": "{}", "seconds": "{:g} s", "case": "case {}", "calls": "shrunk to {}",
             "built": "built in {:g} s"}
    verdict = {"found": [], "passes": ["SURVIVES"]}.get(outcome["verdict"], [outcome["verdict"]])
    return ", ".join(verdict + [text.format(outcome[key]) for key, text in words.items() if key in outcome])


def median(numbers: list) -> str:
    return f"{sorted(numbers)[len(numbers) // 2]:g}" if numbers else ""


def summary(done: dict) -> str:
    """A table in Markdown: a line for each part of the code."""
    rooms: dict[str, list[dict]] = {}
    for bug, outcome in sorted(done.items(), key=lambda item: item[0].file):
        rooms.setdefault("/".join(bug.file.split("/")[:2]), []).append(outcome)
    rooms["all"] = list(done.values())
    columns = ["", "tried", "found", "survive", "other", "s to find, median", "most", "calls left", "s to build"]
    lines = ["| " + " | ".join(columns) + " |", "|---" + "|---:" * (len(columns) - 1) + "|"]
    for room, outcomes in rooms.items():
        found = [o for o in outcomes if o["verdict"] == "found"]
        survive = sum(o["verdict"] == "passes" for o in outcomes)
        seconds = [o["seconds"] for o in found]
        cells = [room, len(outcomes), len(found), survive, len(outcomes) - len(found) - survive, median(seconds),
                 max(seconds, default=""), median([o["calls"] for o in found if "calls" in o]),
                 median([o["built"] for o in outcomes if "built" in o])]
        lines.append("| " + " | ".join(map(str, cells)) + " |")
    return "\n".join(lines)


def main() -> int:
    arguments = parser().parse_args()
    try:
        chosen = select(arguments)
        wrong = mutants.stale(mutants.read_explained()) if arguments.mutants or arguments.list else []
        wrong += [] if arguments.mutants else bugs.faults(chosen)
        if arguments.list:
            print(*chosen, f"{len(chosen)} bugs", sep="\n")
        if wrong:
            raise Wrong("\n".join(wrong))
        if not chosen and not arguments.changed:
            raise Wrong("there is no such bug")
        if arguments.list:
            return 0
        file = arguments.results or (bugs.ROOT / "out/bugs/mutants.jsonl" if arguments.mutants else results_file())
        done = try_all(arguments, chosen, Results(file, trying.method(arguments)))
    except Wrong as error:
        print(f"run.py: {error}", file=sys.stderr)
        return 2
    print("", summary(done), "", sep="\n")
    for bug, outcome in done.items():
        if outcome["verdict"] not in ("found", "same code", "explained"):
            print(f"{say(outcome).splitlines()[0]}: {bug}")
    if len(done) < len(chosen):
        print(f"time is up: {len(chosen) - len(done)} were not tried")
    verdicts = [outcome["verdict"] for outcome in done.values()]
    if "does not compile" in verdicts and not arguments.mutants:
        return 2
    bad = {"passes", "its report is lost"} | (set() if arguments.mutants else {"same code"})
    bad |= set() if arguments.mutants or arguments.built else {"time-out"}
    others = arguments.canary is not None and any(outcome.get("how") == "of another group" for outcome in done.values())
    return int(bool(bad & set(verdicts)) or others)


def results_file() -> Path:
    return Path(__file__).parent / "results.jsonl"


if __name__ == "__main__":
    sys.exit(main())
