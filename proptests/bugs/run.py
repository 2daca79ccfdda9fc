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


def parser() -> argparse.ArgumentParser:
    first, rest = __doc__.split("\n\n", 1)
    result = argparse.ArgumentParser(description=first, epilog=rest,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    result.add_argument("--only", metavar="REGEX", type=regex, help="bugs whose group or name matches")
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
    chosen = [b for b in bugs if arguments.only.search(f"{b.group}: {b.name}")] if arguments.only else bugs
    return [b for b in chosen if arguments.method != "fuzz" or b.fuzz]


def try_all(arguments: argparse.Namespace, groups: dict[str, Group], bugs: list[Bug]) -> dict[Bug, dict]:
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
    if wrong := faults(everything):
        print(*wrong, sep="\n", file=sys.stderr)
        return 2
    if arguments.list:
        report(arguments, groups, everything, {})
        return 0

    try:
        results = try_all(arguments, groups, bugs)
    except AtFault as error:
        print(f"run.py: {error}", file=sys.stderr)
        return 2
    report(arguments, groups, everything, results)
    verdicts = [r["verdict"] for r in results.values()]
    print(", ".join(f"{verdicts.count(v)} {v}" for v in dict.fromkeys(["found", *verdicts])) + f", of {len(bugs)} bugs")
    return 2 if "does not compile" in verdicts else int(verdicts.count("found") < len(bugs))


if __name__ == "__main__":
    sys.exit(main())
