"""A finished build as a workshop: bugs can be planted in it, and it stays as it is. The objects of the libraries that
see the changed file are compiled anew from a copy of the sources, and linked into a program before all others, so that
those are not taken; a program's own objects are replaced. A bug costs an object and a link."""

import contextlib
import json
import os
import re
import shutil
import subprocess
from pathlib import Path

from bugs import ROOT, Wrong
from workshop import FOLDER, make

ROOMS = ("lib", "oracle", "bench", "cli")  # of whose files objects are made anew


class Finished:
    def __init__(self, build: Path, number: int = 0):
        self.build_folder, self.folder = build.resolve(), FOLDER / f"finished{number}"
        self.tree = self.folder / "tree"
        self.planted = ""
        shutil.rmtree(self.folder / "made", ignore_errors=True)  # of a run that was killed
        for room in ROOMS:
            shutil.rmtree(self.tree / room, ignore_errors=True)
            shutil.copytree(ROOT / room, self.tree / room)
        try:
            entries = json.loads(self.ninja("compdb"))
        except (OSError, subprocess.CalledProcessError, ValueError) as error:
            raise Wrong(f"{build} is no build by Ninja: {error}") from error
        self.commands = {entry["output"]: entry["command"] for entry in entries
                         if entry["output"].endswith(".o") and entry["output"].split("/")[0] in ROOMS
                         and "tests" not in entry["output"]}
        self.sees: dict[str, set[str]] = {}
        for line in self.ninja("deps", *self.commands).splitlines():
            if line.startswith(" "):
                self.sees[of].add(os.path.normpath(self.build_folder / line.strip()))
            elif line:
                of = line.partition(":")[0]
                self.sees[of] = set()

    def ninja(self, tool: str, *words: str) -> str:
        return subprocess.run(["ninja", "-C", self.build_folder, "-t", tool, *words], check=True, text=True,
                              capture_output=True).stdout

    def has(self, program: str) -> bool:
        return any(path.is_file() for path in self.build_folder.rglob(program))

    @contextlib.contextmanager
    def changed(self, file: str, text: str):
        """While it lasts, programs are linked with the file as it is in this text."""
        original = (self.tree / file).read_text()
        (self.tree / file).write_text(text)
        self.planted = file
        try:
            yield
        finally:
            (self.tree / file).write_text(original)
            self.planted = ""
            shutil.rmtree(self.folder / "made", ignore_errors=True)

    def build(self, _: str, *targets: str) -> float:
        """Seconds of CPU that it took."""
        if not self.planted:
            return 0
        (self.folder / "made").mkdir(parents=True, exist_ok=True)
        objects = [name for name, sees in self.sees.items() if str(ROOT / self.planted) in sees]
        seconds = sum(self.compile(name, self.made(name)) for name in objects)
        for target in targets:
            link = self.ninja("commands", target).splitlines()[-1]
            before, _, rest = link.partition(" -o ")
            made = self.folder / "made" / Path(rest.split()[0]).name
            for name in objects:
                own, new = f" {name}", f" {self.made(name)}"
                if own in before:
                    before = before.replace(own, new)
                elif name.startswith("lib/") or f"lib{re.search('([^/]*)[.]dir/', name)[1]}.a" in rest:
                    before += new
            seconds += self.shell(f"{before} -o {made} {rest.partition(' ')[2]}")
        return seconds

    def made(self, name: str) -> Path:
        return self.folder / "made" / name.replace("/", "_")

    def compile(self, name: str, made: Path) -> float:
        command = self.commands[name].replace(name, str(made))
        source = Path(command.split()[-1])
        if source.suffix == ".cxx":  # several sources in one
            copy = made.with_suffix(".cxx")
            copy.write_text(self.moved(source.read_text()))
            command = command.replace(str(source), str(copy))
        return self.shell(self.moved(command) + " -O1 -w")

    def moved(self, text: str) -> str:
        text = text.replace(f" -I{ROOT} ", f" -I{self.tree} -I{ROOT} ")
        return re.sub(rf"{re.escape(str(ROOT))}/({'|'.join(ROOMS)})\b", rf"{self.tree}/\1", text)

    def shell(self, command: str) -> float:
        return make(["sh", "-c", command], self.build_folder)

    def program(self, _: str, name: str) -> Path:
        made = self.folder / "made" / name
        return made if made.is_file() else next(p for p in self.build_folder.rglob(name) if p.is_file())
