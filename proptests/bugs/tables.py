"""What is printed of a result, and docs/reports/planted-bugs.md."""

import argparse
import shlex
import textwrap
from collections import Counter
from pathlib import Path

from components import COMPONENTS
from listed import Bug, Group
from mutation import Mutant


def say(result: dict) -> str:
    """A line about one bug; what the compiler said, if it did not compile."""
    if result["verdict"] == "does not compile":
        return "\n".join(["does not compile", *result.get("output", "").splitlines()])
    if "test" not in result:
        return result["verdict"]
    text = ("" if result["verdict"] in ("found", "killed") else result["verdict"] + ": ") + result["test"]
    text += "" if result.get("by_law", True) else " (of another law)"
    text += f", {result['how']}" if "how" in result else ""
    text += f", case {result['cases']}" if "cases" in result else ""
    if "executions" in result:
        text += f", after {result['executions']} executions" if result["executions"] else ", in its corpus"
    return text + (f", shrunk to {result['shrunk_edits']} edits" if "shrunk_edits" in result else "")


def command(name: str, arguments: argparse.Namespace) -> str:
    given = [f"--only {shlex.quote(arguments.only.pattern)}"] if arguments.only else []
    given += [f"--with {arguments.method}"] if arguments.method != "tests" else []
    given += [f"--scale {arguments.scale:g}"] if arguments.scale != 1 else []
    return " ".join([f"proptests/bugs/{name} --seed {arguments.seed}", *given, f"--report {arguments.report}"])


def planted(groups: dict[str, Group], results: dict[Bug, dict], command_line: str) -> str:
    found = [r for r in results.values() if r["verdict"] == "found"]
    by_law = sum(r.get("by_law", True) for r in found)
    late = sum(r["verdict"] == "time-out" for r in results.values())
    prose = [
        "Each is planted by itself; then the tests are built and run until one fails: those of the law that it breaks "
        "first, in the order that is given there, then all others. That test passes without the bug. Made by:",
        f"    {command_line}",
        f"{len(found)} of {len(results)} are found, {by_law} of them by a test of their law"
        + (f"; {late} ran out of time." if late else "."),
        "*Case*: the number of the random case that showed it, or of the world in `SmallWorlds`. *Edits*: how many are "
        "left of that case when it is shrunk. More than four are left where the bug needs them: two chunks, a crowded "
        "row, or a history. Tests that go through all there is of something other than worlds, or through examples, "
        "have neither number; nor has a case that fails only after those before it a number of edits.",
    ]
    lines = ["# Planted bugs", ""]
    for paragraph in prose:
        lines += [paragraph if paragraph.startswith(" ") else textwrap.fill(paragraph, 120), ""]
    for name, group in groups.items():
        rows = [row(bug, results[bug]) for bug in results if bug.group == name]
        if rows:
            lines += [f"## {group.title}", "", "| bug | what a game suffers | in | found by | case | edits |",
                      "|---|---|---|---|---:|---:|", *rows, ""]
    return "\n".join(lines)


def row(bug: Bug, r: dict) -> str:
    by = f"`{r['test']}`" if r["verdict"] == "found" else f"**{r['verdict']}**"
    by += "" if r.get("by_law", True) else " (of another law)"
    by += f", which {r['how']}" if "how" in r else ""
    return (f"| {bug.name} | {bug.game} | `{Path(bug.file).name}` | {by} | {r.get('cases', '')} | "
            f"{r.get('shrunk_edits', '')} |")


def mutants(results: dict[Mutant, dict]) -> str:
    """The score, as a table in Markdown, and what lives, as diffs."""
    columns = ["sample", "does not compile", "same code", "explained", "time-out", "killed", "lives", "score"]
    lines = ["", " | ".join(["| component", *columns, ""]).rstrip(), "|---" + "|---:" * len(columns) + "|"]
    counted = {name: Counter(r["verdict"] for m, r in results.items() if m.component == name) for name in COMPONENTS}
    for name, count in {**counted, "all": sum(counted.values(), Counter())}.items():
        judged = count["killed"] + count["lives"]
        cells = [count.total(), *(count[column] for column in columns[1:-1]),
                 f"{100 * count['killed'] / judged:.1f}%" if judged else ""]
        lines.append(f"| {name} | " + " | ".join(map(str, cells)) + " |")
    for verdict in ("lives", "time-out"):
        diffs = [mutant.diff() for mutant, r in results.items() if r["verdict"] == verdict]
        if diffs:
            lines += ["", f"{verdict}:", "", *diffs]
    return "\n".join(lines)
