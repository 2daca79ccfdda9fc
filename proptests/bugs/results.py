"""Results that are kept as they come, a line of JSON each."""

import hashlib
import json
import threading
from pathlib import Path

from workshop import ROOT

FOLDER = ROOT / "out" / "bugs"


class Results:
    """What was found out, by what it depends on: the state of the code and its tests, and the words of a key."""

    def __init__(self, name: str, state: str, fresh: bool):
        self.path: Path = FOLDER / f"{name}.jsonl"
        self.state = state
        self.known: dict[str, dict] = {}
        self.lock = threading.Lock()
        self.path.parent.mkdir(parents=True, exist_ok=True)
        if fresh:
            self.path.unlink(missing_ok=True)
        if self.path.exists():
            for line in self.path.read_text().splitlines():
                entry = json.loads(line)
                self.known[entry["key"]] = entry["result"]

    def key(self, *words) -> str:
        return hashlib.sha256("\0".join([self.state, *map(str, words)]).encode()).hexdigest()[:20]

    def get(self, *words) -> dict | None:
        with self.lock:
            return self.known.get(self.key(*words))

    def put(self, result: dict, *words) -> dict:
        with self.lock, self.path.open("a") as file:
            self.known[self.key(*words)] = result
            file.write(json.dumps({"key": self.key(*words), "result": result}) + "\n")
        return result
