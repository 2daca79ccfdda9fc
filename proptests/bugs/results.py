"""What became of which bug, a line of JSON each, with the commit; and what changed since a commit."""

import hashlib
import json
import subprocess
import threading
from pathlib import Path

from bugs import ROOT, Wrong


def git(*words: str) -> str:
    done = subprocess.run(["git", *words], cwd=ROOT, text=True, capture_output=True)
    if done.returncode != 0:
        raise Wrong(done.stderr.strip())
    return done.stdout


def now(file: Path) -> str:
    """The commit; with a digest of what is not committed."""
    changes = git("diff", "HEAD", "--", ".", f":!*{file.name}")
    return git("rev-parse", "--short=10", "HEAD").strip() + (
        f"+{hashlib.sha256(changes.encode()).hexdigest()[:6]}" if changes else "")


def changed_since(revision: str) -> tuple[set[str], set[str]]:
    """The files, and what begins a line that was added to a list of bugs."""
    files = git("diff", "--name-only", revision, "--").splitlines()
    lines = git("diff", "-U0", revision, "--", "*.bugs").splitlines()
    return set(files), {line[1:].partition(" [fuzz ")[0].strip() for line in lines
                        if line.startswith("+ ")}


class Results:
    """Of one way to look for bugs. The file has the last outcome of each bug and each way, in order."""

    def __init__(self, file: Path, method: str):
        self.file, self.method, self.commit = file, method, now(file)
        self.lock = threading.Lock()
        file.parent.mkdir(parents=True, exist_ok=True)

    def read(self) -> dict[tuple[str, str], dict]:
        lines = self.file.read_text().splitlines() if self.file.exists() else []
        entries = [json.loads(line) for line in lines]
        return {(entry["bug"], entry["with"]): entry for entry in entries}

    def last(self, bug) -> dict:
        """What found it at any commit."""
        return self.read().get((str(bug), self.method), {})

    def of_now(self, bug) -> dict | None:
        entry = self.last(bug)
        return entry if entry.get("commit") == self.commit else None

    def put(self, bug, outcome: dict) -> dict:
        import fcntl  # not where there is Windows, which can list the bugs
        entry = {"bug": str(bug), "with": self.method, "commit": self.commit, **outcome}
        with self.lock, self.file.open("a") as opened:
            fcntl.flock(opened, fcntl.LOCK_EX)
            entries = self.read() | {(str(bug), self.method): {k: v for k, v in entry.items() if k != "output"}}
            text = "".join(json.dumps(entries[key], ensure_ascii=False) + "\n" for key in sorted(entries))
            opened.truncate(0)
            opened.write(text)
        return entry
