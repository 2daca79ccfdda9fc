#!/usr/bin/env python3
"""Writes the release archive: the libraries as CMake builds them, the amalgamation, the examples, the documents.

The same files give the same archive, byte for byte.
"""
import argparse
import gzip
import io
import re
import subprocess
import sys
import tarfile
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PARTS = ["CHANGELOG.md", "CMakeLists.txt", "LICENSE", "LICENSES.md", "README.md", "SECURITY.md", "cmake", "docs", "examples",
         "lib", "addons"]


def files():
    """Path in the archive, and on the disk."""
    found = {}
    for part in PARTS:
        path = ROOT / part
        for file in [path] if path.is_file() else path.rglob("*"):
            if file.is_file() and file.suffix != ".bugs" and not {"__pycache__", "tests", "fuzz", "ride"} & set(file.relative_to(ROOT).parts):
                found[file.relative_to(ROOT).as_posix()] = file
    return found


def version():
    return re.search(r"project\(LocalGridSeg VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text())[1]


def write(archive, contents):
    root = f"localgridseg-{version()}"
    with open(archive, "wb") as raw, gzip.GzipFile(filename="", fileobj=raw, mode="wb", mtime=0) as packed:
        with tarfile.open(fileobj=packed, mode="w", format=tarfile.USTAR_FORMAT) as tar:
            for name, path in sorted(contents.items()):
                data = path.read_bytes()
                entry = tarfile.TarInfo(f"{root}/{name}")
                entry.size = len(data)
                entry.mode = 0o755 if path.stat().st_mode & 0o100 else 0o644
                tar.addfile(entry, io.BytesIO(data))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("archive", type=Path, help="what to write, a .tar.gz")
    parser.add_argument("--expected", type=Path, help="the header of tl::expected, for the amalgamation")
    args = parser.parse_args()
    contents = files()
    with tempfile.TemporaryDirectory() as folder:
        command = [sys.executable, ROOT / "scripts/amalgamate.py", folder]
        if args.expected:
            command += ["--expected", args.expected]
        subprocess.run(command, check=True)
        contents |= {f"two_files/{path.name}": path for path in Path(folder).iterdir()}
        args.archive.parent.mkdir(parents=True, exist_ok=True)
        write(args.archive, contents)


main()
