"""Copies of the project in which its code can be changed without harm, each with builds of its own."""

import contextlib
import os
import shutil
import signal
import subprocess
import tempfile
import threading
from dataclasses import dataclass
from pathlib import Path

from bugs import ROOT, Wrong

FOLDER = Path(os.environ.get("LGS_WORKSHOPS", ROOT / "build" / "bugs"))  # of each run its own, if several are at work

QUICK = "-DCMAKE_PROJECT_LocalGridSeg_INCLUDE={tree}/proptests/bugs/quick.cmake"
KINDS = {
    # A changed source file costs its object and a link.
    "tests": ["--preset", "release", QUICK, "-DLGS_BUGS_AS_ONE=OFF"],
    # Each library is one file. That takes a third of the time of all its files, which a changed header would cost.
    "headers": ["--preset", "release", QUICK, "-DLGS_BUGS_AS_ONE=ON"],
    "fuzz": ["--preset", "fuzz", "-DCMAKE_BUILD_TYPE=Release", "-DLGS_SANITIZE="],
    # Without what makes the modules small: then they are linked at once.
    "web": ["--preset", "web", f"-DLGS_WEB_SOURCES={ROOT}/build/web-sources",
            "-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG -fno-lto", "-DCMAKE_EXE_LINKER_FLAGS_RELEASE=-O0"],
}


MEMORY = 6_000_000  # KiB that a process may have: a bug may ask for all there is


class DoesNotBuild(Exception):
    """What the compiler said."""


@contextlib.contextmanager
def alone():
    """The workshops are used by one run at a time."""
    import fcntl  # not where there is Windows, which can list the bugs
    FOLDER.mkdir(parents=True, exist_ok=True)
    with (FOLDER / "lock").open("w") as lock:
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError as error:
            raise Wrong(f"another run is at work in {FOLDER}") from error
        yield


def sources() -> set[str]:
    """What Git knows of, and what it would."""
    listed = subprocess.run(["git", "ls-files", "-co", "--exclude-standard"], cwd=ROOT, check=True, text=True,
                            capture_output=True).stdout.splitlines()
    return {file for file in listed if (ROOT / file).is_file()}


class Workshop:
    def __init__(self, number: int, jobs: int):
        self.folder, self.jobs = FOLDER / str(number), jobs
        self.tree = self.folder / "tree"
        self.configured: set[str] = set()
        self.copy(sources())

    def copy(self, wanted: set[str]) -> None:
        """Writes only what differs, so that little has to be built again."""
        for folder in [self.tree, *(f for f in self.tree.glob("*") if f.name != "build")]:
            for stale in folder.glob("*") if folder == self.tree else folder.rglob("*"):
                if stale.is_file() and not stale.is_symlink() and str(stale.relative_to(self.tree)) not in wanted:
                    stale.unlink()
        for file in wanted:
            source, target = ROOT / file, self.tree / file
            if not target.exists() or target.read_bytes() != source.read_bytes():
                target.parent.mkdir(parents=True, exist_ok=True)
                shutil.copy(source, target)

    def build(self, kind: str, *targets: str) -> float:
        """Seconds of CPU that it took."""
        if kind not in self.configured:
            options = [option.replace("{tree}", str(self.tree)) for option in KINDS[kind]]
            make(["cmake", *options, "-B", self.place(kind)], self.tree)
            self.configured.add(kind)
        return make(["cmake", "--build", self.place(kind), "-j", str(self.jobs), "--target", *targets])

    def place(self, kind: str) -> Path:
        return self.tree / "build" / kind

    def program(self, kind: str, name: str) -> Path:
        return next(p for p in self.place(kind).rglob(name) if p.is_file())

    @contextlib.contextmanager
    def changed(self, file: str, text: str):
        """While it lasts, a file has another text."""
        target = self.tree / file
        original = target.read_text()
        target.write_text(text)
        try:
            yield
        finally:
            target.write_text(original)


@dataclass(frozen=True)
class Ran:
    status: int  # negative: the signal that ended it
    seconds: float  # of CPU, those of its child processes included
    output: str

    @property
    def timed_out(self) -> bool:
        return self.status in (-signal.SIGXCPU, -signal.SIGKILL)


def run(command: list, limit: float, environment: dict[str, str] | None = None, memory: int | str = MEMORY,
        folder: Path | None = None) -> Ran:
    """Ends a process that takes more CPU seconds than `limit`, and a program that sleeps, after ten times as long."""
    limited = f"ulimit -S -t {int(limit) + 1}; ulimit -c 0; ulimit -v {memory}; exec \"$@\""
    with tempfile.TemporaryFile() as output:
        process = subprocess.Popen(["sh", "-c", limited, "sh", *map(str, command)], stdin=subprocess.DEVNULL,
                                   stdout=output, stderr=subprocess.STDOUT, start_new_session=True, cwd=folder,
                                   env={**os.environ, **(environment or {})})
        asleep = threading.Timer(10 * limit + 60, os.killpg, (process.pid, signal.SIGKILL))
        asleep.start()
        _, raw, usage = os.wait4(process.pid, 0)
        asleep.cancel()
        process.returncode = os.waitstatus_to_exitcode(raw)
        output.seek(0)
        text = output.read().decode(errors="replace")
    return Ran(process.returncode, round(usage.ru_utime + usage.ru_stime, 2), text)


def make(command: list, folder: Path | None = None) -> float:
    """Seconds of CPU that it took."""
    ran = run(command, 36_000, memory="unlimited", folder=folder)
    if ran.status != 0:
        raise DoesNotBuild(ran.output[-4000:])
    return ran.seconds
