"""Options that the planted bugs and the mutants share."""

import argparse
import os
import re
from pathlib import Path


def regex(text: str) -> re.Pattern:
    try:
        return re.compile(text)
    except re.error as error:
        raise argparse.ArgumentTypeError(f"'{text}' is no regular expression: {error}") from None


def whole_number(text: str) -> int:
    if not re.fullmatch(r"0*[1-9]\d*", text):
        raise argparse.ArgumentTypeError(f"'{text}' is not a whole number from 1 on")
    return int(text)


def positive(text: str) -> float:
    try:
        value = float(text)
    except ValueError:
        value = 0
    if not 0 < value <= 1e6:
        raise argparse.ArgumentTypeError(f"'{text}' is no positive number")
    return value


def report_file(text: str) -> Path:
    path = Path(text)
    if path.is_dir() or not os.access(path if path.exists() else path.parent, os.W_OK):
        raise argparse.ArgumentTypeError(f"'{text}' can not be written")
    return path


def add_common(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--seed", metavar="N", type=int, default=1, help="of what is random (default: 1)")
    parser.add_argument("--jobs", metavar="N", type=whole_number, default=os.cpu_count(),
                        help="copies of the project to work in side by side (default: one a core)")
    parser.add_argument("--fresh", action="store_true", help="forget the results of earlier runs")
