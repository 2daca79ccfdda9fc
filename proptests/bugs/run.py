#!/usr/bin/env python3
"""Plants bugs in the code one at a time and shows what finds each: the tests, or a fuzz target.

A bug is a substitution in one file, listed by the law that it breaks in the *.toml files beside this script. For each
one the tests are built with it and run until one fails: first those of its law, in the order that is given there, then
all others; a fuzz target searches from a fixed seed. What fails with a bug is run without it as well, and must pass.

A bug that nothing finds is a defect of the tests; one that does not apply, or does not compile, is a defect of the
list; a test that runs out of CPU time has neither found its bug nor let it pass. Results are kept in
out/bugs/results.jsonl as they come, so that an interrupted run goes on where it was; they hold for the state of the
code and its tests that they were made with. Exit status: 0 when every bug is found, 1 when one is not, 2 when the list
or the code is at fault.
"""

import argparse
import dataclasses
import random
import sys

import search
import tables
from listed import Bug, Group, faults, read_list
from options import add_common, positive, regex, report_file, whole_number
from results import Results
from workshop import AtFault, sources, state_of


def method(text: str) -> str:
    if text not in ("tests", "fuzz") and not text.startswith("fuzz:"):
        raise argparse.ArgumentTypeError(f"'{text}' is not tests, fuzz or fuzz:TARGET")
    return text


def span(text: str) -> tuple[int, int]:
    first, _, last = text.partition("-")
    if not (first.isdigit() and last.isdigit() and int(first) <= int(last)):
        raise argparse.ArgumentTypeError(f"'{text}' is no range such as 0-19")
    return int(first), int(last)


def parser() -> argparse.ArgumentParser:
    first, rest = __doc__.split("\n\n", 1)
    result = argparse.ArgumentParser(description=first, epilog=rest,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    result.add_argument("--only", metavar="REGEX", type=regex, help="bugs whose group or name matches")
    result.add_argument("--numbers", metavar="FIRST-LAST", type=span, help="bugs by their places in the list, from 0 on")
    result.add_argument("--canary", metavar="SEED", type=int,
                        help="one bug of laws 1 and 2, drawn by this seed, which the numbered blocks alone must find")
    result.add_argument("--with", metavar="WHAT", type=method, default="tests", dest="method",
                        help="tests (default); fuzz: each bug's own fuzz target, for those that have one; fuzz:TARGET")
    result.add_argument("--list", action="store_true", help="list the bugs, see that each applies, and build nothing")
    result.add_argument("--executions", metavar="N", type=whole_number, default=100_000,
                        help="of a fuzz target, for each bug (default: 100000)")
    result.add_argument("--report", metavar="FILE", type=report_file, help="write the outcomes into the tables of this page; "
                        "what stands around them stays, and so do rows of bugs that were not tried")
    result.add_argument("--scale", metavar="X", type=positive, default=1.0, help="LGS_TEST_SCALE (default: 1)")
    add_common(result)
    return result


def select(arguments: argparse.Namespace, bugs: list[Bug]) -> list[Bug]:
    if arguments.canary is not None:
        basic = [b for b in bugs if b.group.startswith(("law1-", "law2-"))]
        return [random.Random(arguments.canary).choice(basic)]
    chosen = bugs[arguments.numbers[0]:arguments.numbers[1] + 1] if arguments.numbers else bugs
    chosen = [b for b in chosen if arguments.only.search(f"{b.group}: {b.name}")] if arguments.only else chosen
    return [b for b in chosen if arguments.method != "fuzz" or b.fuzz]


def try_all(arguments: argparse.Namespace, groups: dict[str, Group], bugs: list[Bug]) -> dict[Bug, dict]:
    if arguments.canary is not None:
        groups = {name: dataclasses.replace(group, tests=("Bulk/",)) for name, group in groups.items()}
    files = sources()
    results = Results("results", state_of(files), arguments.fresh)
    plan = search.Plan(arguments.method, arguments.seed, arguments.scale, arguments.executions, groups)
    done: dict[Bug, dict] = {}

    def show(bug: Bug, result: dict) -> None:
        done[bug] = result
        print(f"[{len(done)}/{len(bugs)}] {bug.group}: {bug.name}: {tables.say(result)}", flush=True)

    search.run(plan, bugs, files, results, arguments.jobs, show)
    return done


def report(arguments: argparse.Namespace, groups: dict[str, Group], bugs: list[Bug], results: dict[Bug, dict]) -> None:
    if arguments.report:
        page = arguments.report.read_text() if arguments.report.exists() else "# Planted bugs\n"
        arguments.report.write_text(tables.planted(page, groups, bugs, results))


def main() -> int:
    arguments = parser().parse_args()
    groups, everything = read_list()
    bugs = select(arguments, everything)
    if not bugs:
        parser().error("there is no such bug")
    if arguments.list:
        for bug in bugs:
            print(f"{bug.group:22}  {bug.name}\n{'':22}  {bug.game}")
        print(f"{len(bugs)} bugs")
        report(arguments, groups, everything, {})
    if wrong := faults(groups, everything):
        print(*wrong, sep="\n", file=sys.stderr)
        return 2
    if arguments.list:
        return 0

    try:
        results = try_all(arguments, groups, bugs)
    except AtFault as error:
        print(f"run.py: {error}", file=sys.stderr)
        return 2
    report(arguments, groups, everything, results)
    verdicts = [r["verdict"] for r in results.values()]
    print(", ".join(f"{verdicts.count(v)} {v}" for v in dict.fromkeys(["found", *verdicts])) + f", of {len(bugs)} bugs")
    if "does not compile" in verdicts:
        return 2
    others = arguments.canary is not None and not all(r.get("by_law", True) for r in results.values())
    return int(verdicts.count("found") < len(bugs) or others)


if __name__ == "__main__":
    sys.exit(main())
