"""Which commit brought a finding: git bisect, in a worktree of its own, with the trace that shows it."""

import subprocess
import tempfile
from pathlib import Path

from units import ROOT

# 125: this commit cannot be judged. A mismatch is status 1, and so is a crash of the engine under test.
STEP = """#!/bin/sh
cmake -S . -B build/bisect -G Ninja -DCMAKE_BUILD_TYPE=Release >build.log 2>&1 || exit 125
cmake --build build/bisect --target lgs_cli >>build.log 2>&1 || exit 125
build/bisect/cli/lgs replay "$1" --check
status=$?
[ $status -eq 2 ] && exit 125
[ $status -ne 0 ] && exit 1
exit 0
"""


def bisect(trace: str, good: str, bad: str) -> int:
    with tempfile.TemporaryDirectory(prefix="lgs-bisect-") as folder:
        tree, step, file = Path(folder) / "tree", Path(folder) / "step.sh", Path(folder) / "finding.trace"
        step.write_text(STEP, encoding="utf-8")
        file.write_text(trace, encoding="utf-8")
        git = ["git", "-C", str(tree)]
        subprocess.run(["git", "-C", str(ROOT), "worktree", "add", "--detach", str(tree), bad], check=True)
        try:
            subprocess.run([*git, "bisect", "start", bad, good], check=True)
            return subprocess.run([*git, "bisect", "run", "sh", str(step), str(file)], check=False).returncode
        finally:
            subprocess.run([*git, "bisect", "reset"], check=False, capture_output=True)
            subprocess.run(["git", "-C", str(ROOT), "worktree", "remove", "--force", str(tree)], check=False)
