"""Numbers as a person reads them."""


def duration(ns):
    """Three digits and a unit: '412 ns', '3.41 µs', '12.5 ms', '1.02 s'."""
    for limit, unit, scale in ((1e3, "ns", 1), (1e6, "µs", 1e3), (1e9, "ms", 1e6), (float("inf"), "s", 1e9)):
        if ns < 0.9995 * limit:
            return f"{digits(ns / scale)} {unit}"
    raise ValueError(ns)


def digits(value):
    """Three digits: '412', '12.5', '3.41'. Below 10 there are no zeros at the end."""
    if value >= 100:
        return f"{value:,.0f}"
    return f"{value:.1f}" if value >= 10 else f"{value:.2f}".rstrip("0").rstrip(".") if value else "0"


def ratio(value):
    """'23,000×', '4.1×'"""
    if value < 100:
        return f"{value:.1f}×"
    step = 10 ** (len(str(int(value))) - 3)
    return f"{int(round(value / step) * step):,}×"


def count(value):
    """'10²' for a power of ten from 100 on, '32' for another number."""
    text = str(int(value))
    if text.strip("0") == "1" and len(text) > 2:
        return "10" + "".join("⁰¹²³⁴⁵⁶⁷⁸⁹"[int(d)] for d in str(len(text) - 1))
    return f"{int(value):,}"


def table(head, rows):
    """A Markdown table. All columns but the first are aligned to the right."""
    lines = ["| " + " | ".join(head) + " |", "|---|" + "---:|" * (len(head) - 1)]
    lines += ["| " + " | ".join(row) + " |" for row in rows]
    return "\n".join(lines)
