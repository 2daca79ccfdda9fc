#!/usr/bin/env python3
"""The engines of examples/engines that need no library are right.

    oracle/tests/engines/examples_test.py LGS NAME

Exit status 77, with a word, where the compiler or the interpreter is missing.
"""
import pathlib
import shlex
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[3]
ENGINES = ROOT / "examples/engines"

# What compiles an engine, if anything has to, and how lgs is told of it. {source}, {made}: files.
RUNS = {
    "naive.py": ([], ["--engine", f"{shlex.quote(sys.executable)} {{source}}"]),
    "incremental.py": ([], ["--engine", f"{shlex.quote(sys.executable)} {{source}}"]),
    "squares.mjs": ([], ["--engine", "node {source}"]),
    "squares_so.c": (["cc", "-std=c99", "-Wall", "-Wextra", "-Wpedantic", "-Werror", "-shared", "-fPIC",
                      f"-I{ROOT}/oracle/engine/include", "{source}", "-o", "{made}"], ["--engine-so", "{made}"]),
    "squares_so.rs": (["rustc", "--edition", "2021", "-O", "--crate-type", "cdylib", "{source}", "-o", "{made}"],
                      ["--engine-so", "{made}"]),
}


def main():
    lgs, name = sys.argv[1:]
    compiler, engine = RUNS[name]
    tool = compiler[0] if compiler else shlex.split(engine[1])[0]
    if shutil.which(tool) is None:
        print(f"there is no {tool}")
        return 77
    with tempfile.TemporaryDirectory() as folder:
        files = {"source": str(ENGINES / name), "made": f"{folder}/engine"}
        if compiler:
            subprocess.run([word.format(**files) for word in compiler], check=True)
        arguments = [word.format(**files) for word in engine]
        return subprocess.run([lgs, "check", *arguments, "--edits", "1000"], cwd=folder, check=False).returncode


sys.exit(main())
