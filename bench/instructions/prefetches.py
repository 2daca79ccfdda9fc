#!/usr/bin/env python3
"""Counts the prefetches in object files, and fails if one has too few: GCC deletes calls of functions that do nothing
but prefetch (lib/outline/fetch.h). Where the machine's code is not that of x86-64 the exit status is 77.

    prefetches.py OBJECTS NAME=LEAST...
"""
import re
import subprocess
import sys

SKIPPED = 77


def main():
    objects = sys.argv[1].split(";")
    failed = False
    for name, least in (rule.split("=") for rule in sys.argv[2:]):
        [path] = [o for o in objects if o.endswith(f"{name}.o")]
        done = subprocess.run(["objdump", "-d", path], capture_output=True, text=True)
        if done.returncode != 0 or "x86-64" not in done.stdout:
            return SKIPPED
        count = len(re.findall(r"\tprefetch\w+ ", done.stdout))
        print(f"{count} prefetches in {path}, {least} or more expected")
        failed |= count < int(least)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
