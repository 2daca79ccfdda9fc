"""Writes a source file with a planted bug: plant.py BUGS.toml NAME LIB OUT"""

import pathlib
import sys
import tomllib

bugs, name, lib, out = sys.argv[1:]
with open(bugs, "rb") as file:
    bug = next(bug for bug in tomllib.load(file)["bug"] if bug["name"] == name)
text = (pathlib.Path(lib) / bug["file"]).read_text()
if text.count(bug["find"]) != 1:
    sys.exit(f"plant.py: '{bug['find']}' is not there once in {bug['file']}")
target = pathlib.Path(out) / bug["file"]
target.parent.mkdir(parents=True, exist_ok=True)
target.write_text(text.replace(bug["find"], bug["replace"]))
