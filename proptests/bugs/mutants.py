#!/usr/bin/env python3
"""Makes mutants of the C++ code by rule, takes a sample of them, and shows which the tests let live.

A mutant is the code with one small change: an operator for another, a constant one more or less, a condition negated,
a statement dropped, two arguments swapped (rules.py). If the tests that are built with it are the same program as
without it, it is none. Any other is given to the tests of its component, at a small scale, the quick ones first. What
lives is printed as a diff; what is listed in equivalent.toml, with the reason why no test can tell it from the code,
does not count.

The score is killed / (killed + living). A mutant on which the tests run out of CPU time is neither. Results are kept in
out/bugs/mutants.jsonl as they come, so that an interrupted run goes on where it was; they hold for the state of the
code and its tests that they were made with. Exit status: 0 when no mutant lives, 1 when one does, 2 on bad usage, or
when the tests fail without a mutant.
"""

import argparse
import random
import sys

import mutation
import tables
from components import COMPONENTS, NATIVE
from mutation import Mutant
from options import add_common, positive, regex, whole_number
from results import Results
from workshop import AtFault, sources, state_of


def parser() -> argparse.ArgumentParser:
    first, rest = __doc__.split("\n\n", 1)
    result = argparse.ArgumentParser(description=first, epilog=rest,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    result.add_argument("--sample", metavar="N", type=whole_number, help="how many, by --seed (default: all there are)")
    result.add_argument("--from", metavar="N", type=int, default=0, dest="first",
                        help="without the first N of the sample, which others try")
    result.add_argument("--of", metavar="COMPONENT", choices=COMPONENTS, nargs="+", default=NATIVE,
                        help=f"of {', '.join(COMPONENTS)} (default: of all but WebAssembly, which needs what "
                        "scripts/web_setup.sh installs)")
    result.add_argument("--only", metavar="REGEX", type=regex, help="of the sample, those whose file and diff match")
    result.add_argument("--list", action="store_true", help="show the sample as diffs, and build nothing")
    result.add_argument("--again", choices=mutation.VERDICTS, help="try those again that had this verdict")
    result.add_argument("--scale", metavar="X", type=positive, default=0.02,
                        help="LGS_TEST_SCALE (default: 0.02); results of another scale stay, see --again")
    add_common(result)
    return result


def sample(arguments: argparse.Namespace) -> list[Mutant]:
    """By file, so that one change after the other has to compile little; headers, which take longest, at the end."""
    everything = [m for name in arguments.of for m in mutation.mutants_of(name)]
    count = min(arguments.sample or len(everything), len(everything))
    chosen = random.Random(arguments.seed).sample(everything, count)[arguments.first:]
    if arguments.only:
        chosen = [m for m in chosen if arguments.only.search(m.diff())]
    return sorted(chosen, key=lambda m: (m.file.endswith(".h"), m.component, m.file, m.change.start, m.change.text))


def main() -> int:
    arguments = parser().parse_args()
    mutants = sample(arguments)
    if arguments.list:
        for mutant in mutants:
            print(mutant.diff())
        print(f"{len(mutants)} mutants")
        return 0
    files = sources()
    results = Results("mutants", state_of(files), arguments.fresh)
    explained = mutation.Explained()
    done: dict[Mutant, dict] = {}

    def show(mutant: Mutant, result: dict) -> None:
        if result["verdict"] in ("lives", "time-out") and explained.of(mutant):
            result = {"verdict": "explained"}
        done[mutant] = result
        print(f"[{len(done)}/{len(mutants)}] {mutant.place()} {mutant.change.rule}: {tables.say(result)}", flush=True)

    try:
        mutation.run(mutants, files, results, arguments, show)
    except AtFault as error:
        print(f"mutants.py: {error}", file=sys.stderr)
        return 2
    print(tables.mutants(done))
    for entry in explained.stale():
        print(f"{mutation.EXPLAINED.name}: this line is no more: {entry}")
    return int(any(r["verdict"] == "lives" for r in done.values()))


if __name__ == "__main__":
    sys.exit(main())
