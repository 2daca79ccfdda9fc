"""The page of a run, in Markdown; and the same in HTML, with the pictures, without anything from elsewhere."""

import html

from ledger import Ledger, compare
from units import KINDS
from work import FINDING, PASS


def rows_of_kinds(ledger: Ledger) -> list[list[str]]:
    rows = []
    for kind in KINDS:
        of_kind = [unit for unit in ledger.units if unit.kind == kind]
        if not of_kind:
            continue
        done = [ledger.counted[unit] for unit in of_kind if ledger.counted[unit]]
        rows.append([kind, str(len(of_kind)), str(sum(r["outcome"] == PASS for r in done)),
                     str(sum(r["outcome"] == FINDING for r in done)), str(len(of_kind) - len(done)),
                     f"{sum(r['figures'].get('commits', 0) for r in done):,}", f"{sum(r['cpu'] for r in done) / 3600:.2f}"])
    return rows


def canary(ledger: Ledger) -> str:
    canaries = [unit for unit in ledger.units if unit.kind == "canary"]
    if not canaries:
        return "There is no canary in this plan: nothing shows that the run can find a bug."
    dead = [unit for unit in canaries if unit not in ledger.having(PASS)]
    if dead:
        return f"RED: the canary was not found ({', '.join(unit.key for unit in dead)}). Trust nothing on this page."
    return f"The canary was found: {len(canaries)} planted bug{'s' if len(canaries) > 1 else ''}."


def over_time(ledger: Ledger) -> list[list[str]]:
    hours: dict[str, int] = {}
    for result in ledger.counted.values():
        if result:
            hours[result["when"][:13]] = hours.get(result["when"][:13], 0) + result["figures"].get("commits", 0)
    total, rows = 0, []
    for hour in sorted(hours):
        total += hours[hour]
        rows.append([hour.replace("T", " ") + " h", f"{hours[hour]:,}", f"{total:,}"])
    return rows


def table(head: list[str], rows: list[list[str]]) -> list[str]:
    escaped = [[cell.replace("|", "\\|").replace("\n", " ") for cell in row] for row in rows]
    return ["| " + " | ".join(head) + " |", "|" + "---|" * len(head), *("| " + " | ".join(row) + " |" for row in escaped), ""]


def summary(ledger: Ledger) -> str:
    return (f"{len(ledger.units)} units: {len(ledger.having(PASS))} passed, {len(ledger.having(FINDING))} with findings, "
            f"{len(ledger.missing)} missing. {ledger.attempts} attempts. {ledger.total('commits'):,} commits, "
            f"{ledger.total('cgal'):,} compared with CGAL, {ledger.total('naive'):,} with the naive reference, "
            f"{ledger.cpu / 3600:.2f} CPU hours.")


def markdown(ledger: Ledger, before: Ledger | None) -> str:
    commits = ", ".join(sorted({unit.commit[:12] for unit in ledger.units}))
    lines = [f"# A run of the farm at {commits}", "", summary(ledger), "", canary(ledger), ""]
    lines += table(["kind", "units", "passed", "findings", "missing", "commits", "CPU hours"], rows_of_kinds(ledger))
    found = ledger.findings()
    state = compare(before, ledger) if before else {}
    lines += ["## Findings", ""] if found or state else ["No finding.", ""]
    for name in sorted(found.keys() | state.keys(), key=lambda n: (state.get(n, ""), n)):
        finding = found.get(name) or before.findings()[name]
        lines += [f"### {name}: {finding['fault']}" + (f" ({state[name]})" if name in state else ""), "",
                  f"{finding['count']} times, first {finding['first']}, last {finding['last']}; in {finding['units'][0]}. "
                  f"Again: `{finding['again'] or 'scripts/farm.py run'}`", "", "```", finding["trace"].strip() or
                  finding["words"].strip()[-1_500:], "```", "", f"<!-- picture {name} -->", ""]
    if ledger.torn:
        lines += ["## Passed and failed", "", "The same unit did both: something that is not in the unit decides.", "",
                  *(f"- {unit.key}" for unit in ledger.torn), ""]
    lost = [[unit.key, str(len(ledger.lost[unit])), "; ".join(sorted({a["why"] for a in ledger.lost[unit]})),
             "no" if unit in ledger.missing else "yes"] for unit in ledger.units if ledger.lost[unit]]
    if lost:
        lines += ["## Lost", "", *table(["unit", "attempts lost", "why", "done later"], lost)]
    if never := sum(not ledger.lost[unit] for unit in ledger.missing):
        lines += ["## Never begun", "", f"{never} units. `scripts/farm.py show PLAN --left RESULTS` names them.", ""]
    if ledger.foreign:
        lines += ["## Not of this plan", "", f"{len(ledger.foreign)} results are of units that the plan has not, such as "
                  f"{ledger.foreign[0]}. They do not count.", ""]
    slowest = sorted((u for u in ledger.units if ledger.counted[u]), key=lambda u: -ledger.counted[u]["seconds"])[:5]
    lines += ["## Slowest units", "", *table(["unit", "seconds", "peak MB", "host"], [
        [u.key, f"{ledger.counted[u]['seconds']:.0f}", f"{ledger.counted[u]['memory'] / 1e6:.0f}", ledger.counted[u]["host"]]
        for u in slowest])]
    lines += ["## Commits over time", "", *table(["hour, UTC", "commits", "in all"], over_time(ledger))]
    return "\n".join(lines)


STYLE = """body{font:16px/1.5 system-ui,sans-serif;max-width:70em;margin:2em auto;padding:0 1em;color:#222;background:#fff}
table{border-collapse:collapse}td,th{padding:.2em .7em;border-bottom:1px solid #8884;text-align:left}
pre{background:#8881;padding:.7em;overflow:auto}.red{background:#c00;color:#fff;padding:.5em}img{max-width:100%}
@media(prefers-color-scheme:dark){body{color:#ddd;background:#181818}}"""


def inline(text: str) -> str:
    parts = html.escape(text).split("`")
    return "".join(f"<code>{part}</code>" if k % 2 else part for k, part in enumerate(parts))


def as_html(text: str, pictures: dict[str, str]) -> str:
    """Of the Markdown that markdown() writes: headings, tables, lists, code and paragraphs."""
    out, is_code, is_table = [], False, False
    for line in text.splitlines():
        if line == "```":
            out.append("</pre>" if is_code else "<pre>")
            is_code = not is_code
        elif is_code:
            out.append(html.escape(line))
        elif line.startswith("<!-- picture "):
            svg = pictures.get(line.split()[2], "")
            out.append(f'<img alt="the finding" src="data:image/svg+xml,{quoted(svg)}">' if svg else "")
        elif line.startswith("|"):
            if not set(line) <= set("|-"):
                cell = "td" if is_table else "th"
                words = line.replace("\\|", "\0").strip("|").split("|")
                row = "".join(f"<{cell}>{inline(word.strip()).replace(chr(0), '|')}</{cell}>" for word in words)
                out.append(("" if is_table else "<table>") + f"<tr>{row}</tr>")
                is_table = True
            continue
        elif line.startswith("#"):
            level = len(line) - len(line.lstrip("#"))
            out.append(f"<h{level}>{inline(line[level:].strip())}</h{level}>")
        elif line:
            mark = ' class="red"' if line.startswith("RED") else ""
            out.append(f"<p{mark}>{inline(line)}</p>")
        if is_table:
            out.insert(len(out) - 1, "</table>")
            is_table = False
    return f'<!doctype html><meta charset="utf-8"><title>A run of the farm</title><style>{STYLE}</style>\n' + "\n".join(out)


def quoted(svg: str) -> str:
    from urllib.parse import quote
    return quote(svg)
