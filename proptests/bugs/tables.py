"""What is printed of a result, and docs/reports/planted-bugs.md."""

import re
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


BLOCK = re.compile(r"(<!-- planted: (\S+) -->\n).*?(<!-- end -->)", re.S)
COLUMNS = ("| bug | what a game suffers | in | found by | case | edits |", "|---|---|---|---|---:|---:|")
NOT_YET = "not in a run yet"


def planted(page: str, groups: dict[str, Group], bugs: list[Bug], results: dict[Bug, dict]) -> str:
    """The page with its blocks written anew: one table for each group, and the summary. What people wrote around the
    blocks stays. A bug that was not tried keeps the outcome of its row; groups without a block come at the end."""
    known = {cells[0]: cells[3:] for line in page.splitlines() if len(cells := line.strip("| ").split(" | ")) >= 4}
    outcomes = {bug: outcome(results[bug]) if bug in results else known.get(bug.name, [NOT_YET]) for bug in bugs}
    for name, group in groups.items():
        if f"<!-- planted: {name} -->" not in page:
            page = page.rstrip("\n") + f"\n\n## {group.title}\n\n<!-- planted: {name} -->\n<!-- end -->\n"
    blocks = {name: [*COLUMNS, *(row(b, outcomes[b]) for b in bugs if b.group == name)] for name in groups}
    blocks["summary"] = [summary(list(outcomes.values()))]
    return BLOCK.sub(lambda m: m[1] + "\n".join(blocks.get(m[2], [])) + "\n" + m[3], page)


def summary(outcomes: list[list[str]]) -> str:
    found = [cells[0] for cells in outcomes if cells[0].startswith("`")]
    others = Counter(cells[0].strip("*") for cells in outcomes if not cells[0].startswith("`"))
    by_law = sum("(of another law)" not in cell for cell in found)
    parts = [f"{len(outcomes)} bugs are listed", f"{len(found)} were found, {by_law} of them by a test of their law",
             *(f"{count} {verdict}" for verdict, count in others.items())]
    return "; ".join(parts) + "."


def outcome(r: dict) -> list[str]:
    """The last three cells of a row: found by, case, edits."""
    by = f"`{r['test']}`" if r["verdict"] == "found" else f"**{r['verdict']}**"
    by += "" if r.get("by_law", True) else " (of another law)"
    by += f", which {r['how']}" if "how" in r else ""
    return [by, str(r.get("cases", "")), str(r.get("shrunk_edits", ""))]


def row(bug: Bug, cells: list[str]) -> str:
    by, case, edits = [*cells, "", ""][:3]
    return f"| {bug.name} | {bug.game} | `{Path(bug.file).name}` | {by} | {case} | {edits} |"


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
