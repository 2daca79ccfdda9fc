"""Copies of the project in which its code can be changed without harm, each with a build of its own."""

import contextlib
import hashlib
import os
import shutil
import subprocess
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
FOLDER = Path(os.environ.get("LGS_WORKSHOPS", ROOT / "build" / "bugs"))  # of each run its own, if several are at work


def sources() -> list[str]:
    listed = subprocess.run(["git", "ls-files", "-co", "--exclude-standard"], cwd=ROOT, check=True, text=True,
                            capture_output=True).stdout.splitlines()
    return [f for f in listed if (ROOT / f).is_file()]


# What can change any result: the code, what tests it, and how they are built.
SOURCES = ("CMakeLists.txt", "lib/", "oracle/", "proptests/", "fuzz/", "cmake/", "addons/", "bench/", "cli/", "examples/", "packaging/")


def state_of(files: list[str], folders: tuple[str, ...] = SOURCES) -> str:
    digest = hashlib.sha256()
    for file in sorted(files):
        if file.startswith(folders) and not file.startswith("proptests/bugs/"):
            digest.update(file.encode() + (ROOT / file).read_bytes())
    return digest.hexdigest()


class AtFault(Exception):
    """Nothing can be tried: the code fails as it is, or the list does not fit it."""


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
            raise AtFault(f"another run is at work in {FOLDER}") from error
        yield


class Workshop:
    """A copy of the project, with a build of each kind that is asked for. "tests": with optimisation and without
    assertions. "batches": the same, with the files of lib/ compiled in batches, which takes half the time when a header
    of many of them has changed. "fuzz": the fuzz targets, with clang and for libFuzzer. "web": the modules of
    WebAssembly, without what makes them small: then they are linked at once."""

    def __init__(self, number: int, files: list[str], jobs: int):
        self.folder = FOLDER / str(number)
        self.tree = self.folder / "tree"
        self.jobs = jobs
        self.configured: set[str] = set()
        self.copy(files)

    def copy(self, files: list[str]) -> None:
        """Writes only what differs, so that little has to be built again."""
        wanted = set(files)
        for stale in self.tree.rglob("*"):
            if stale.is_file() and str(stale.relative_to(self.tree)) not in wanted:
                stale.unlink()
        for file in files:
            source, target = ROOT / file, self.tree / file
            if target.exists() and target.read_bytes() == source.read_bytes():
                continue
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(source, target)

    def configure(self, kind: str) -> Path:
        build = self.folder / kind
        if kind in self.configured:
            return build
        tests = ["-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG",
                 f"-DCMAKE_PROJECT_LocalGridSeg_INCLUDE={self.tree}/proptests/bugs/quick_library.cmake"]
        options = {
            "tests": tests,
            "batches": [*tests, "-DLGS_BUGS_IN_BATCHES=ON"],
            "web": ["--preset", "web", f"-DLGS_WEB_SOURCES={ROOT}/build/web-sources",
                    "-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG -fno-lto", "-DCMAKE_EXE_LINKER_FLAGS_RELEASE=-O0"],
            "fuzz": ["-DCMAKE_CXX_COMPILER=clang++", "-DLGS_BUILD_TESTS=OFF", "-DLGS_BUILD_FUZZERS=ON"],
        }
        done = subprocess.run(["cmake", "-S", self.tree, "-B", build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
                               *options[kind]], text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        if done.returncode != 0:
            raise DoesNotBuild(done.stdout[-4000:])
        self.configured.add(kind)
        return build

    def build(self, kind: str, *targets: str) -> None:
        done = subprocess.run(["cmake", "--build", self.configure(kind), "-j", str(self.jobs), "--target", *targets],
                              text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        if done.returncode != 0:
            raise DoesNotBuild(done.stdout[-4000:])

    def program(self, kind: str, name: str) -> Path:
        return next(p for p in (self.folder / kind).rglob(name) if p.is_file())

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
