#!/usr/bin/env python3
"""Every option of the lgs command, as its own --help lists them, with hostile values.

    cli/tests/options_test.py LGS [COMMAND...]

Each run ends by itself: with status 2 and a sentence; or with status 0, if the value is a good one for this option.
Status 1 is for options that name an engine, which must be there: a word that names none is a mismatch. A signal, a
report of a sanitizer and a run without an end are faults. An option whose kind of value is in no table here is one, too.
"""
import pathlib
import re
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor

ROOT = pathlib.Path(__file__).resolve().parents[2]
SECONDS = 60
TRACE, MAP = ROOT / "docs/hill.trace", ROOT / "examples/maps/landscape.tmx"
WORLD = ROOT / "docs/ride.trace"

NO_NUMBERS = ["nan", "-nan", "NAN", "nan(1)", "inf", "-inf", "infinity", "", " ", "text", "0x", "1e", "--", "1,5", "½"]
NUMBERS = ["-0", "-0.0", "1e-320", "5e-324", "1e308", "-1e308", "1e400", "-1", "-0.5", "9223372036854775807",
           "18446744073709551615", "18446744073709551616", "-9223372036854775808", "9" * 400, "0x10", "1e1000000000"]
WORDS = ["", " ", "text", "nan", "-1", "\x1b[31m", "%s%n", "9" * 4_000, "a=b=c", "=", "=7", "x=-1", "x=4294967296", "é\n"]
FILES = ["", " ", "{folder}", "{folder}/none/none", "/dev/null/x", "/proc/self/mem/x", "x" * 4_000]

# What an option takes, by the word for it in the help; and which answers to a number are good beside status 2.
REALS = {"SECONDS", "CELLS", "F", "V", "PX", "PIXELS", "X Y"}
WHOLES = {"N", "S", "K"}
TEXTS = {"NAME", "NAME=NUMBER", "NAME[=VALUE]", "TEXT", "KIND", "WxH", "COMMAND", "'WORD ...'", "LETTERS", "CLASS", "ADDRESS"}
PATHS = {"FILE", "FILE...", "FOLDER", "FOLDER...", "FILE.lgs", "DIR", "TRACE", "FILE.so", "MAP"}
ENGINES = {"--engine", "--engine-so"}  # the only options with which a mismatch is an answer

# What each command needs to end soon, and what options need beside them.
COMMANDS = {
    "replay": [str(TRACE)],
    "check": ["--edits", "3", "--oracle", "naive", "--out", "{folder}/out"],
    "oracle": [],
    "import": [str(MAP), "-o", "{folder}/map.trace", "--report", "{folder}/report"],
    "bench": ["--rounds", "1", "--side", "4"],
    "ride": [str(WORLD), "--steps", "3"],
}
WITH_MAP = ["--map", str(MAP)]
OF_ENGINES = ["--engine-timeout", "--assume", "--report", "--known", "--replay", "--json", "--junit", "--laws", "--site"]
NEEDS = {option: ["--engine", "true"] for option in OF_ENGINES} | {"--whole-every": WITH_MAP}


def run(lgs, arguments, folder):
    words = [word.replace("{folder}", folder) for word in arguments]
    try:
        return subprocess.run([lgs, *words], stdin=subprocess.DEVNULL, capture_output=True, cwd=folder, check=False,
                              timeout=SECONDS)
    except subprocess.TimeoutExpired:
        return None


def options(lgs, command):
    """Pairs of an option and what it takes; "" for a flag."""
    text = subprocess.run([lgs, command, "--help"], capture_output=True, text=True, check=True).stdout
    found = []
    for line in text.splitlines():
        listed = re.match(r"  (?:-\w,)?(--[a-z-]+)(?: (\S.*?))?(?:  .*)?$", line)
        if listed:
            taken = re.sub(r" (Needs|Excludes): .*", "", (listed[2] or "").strip())
            found.append((listed[1], re.sub(r"^(Needs|Excludes): .*", "", taken)))
    return found


def values(kind):
    if kind in REALS | WHOLES:
        return NO_NUMBERS + NUMBERS
    if kind in PATHS:
        return FILES + WORDS
    return WORDS + NO_NUMBERS + NUMBERS[:4] + FILES[2:3]


def answers(option, kind, value):
    """The statuses that are right."""
    if kind in REALS | WHOLES and value in NO_NUMBERS:
        return {2}
    if option in ENGINES | set(OF_ENGINES):
        return {0, 1, 2}
    return {0, 2}


def fault(lgs, command, option, kind, value, folder, needs_map):
    base = [word for word in COMMANDS[command]]
    if option in base:
        at = base.index(option)
        del base[at:at + 2]
    base += NEEDS.get(option, WITH_MAP if needs_map else [])
    words = [option, value] + ([value] if kind == "X Y" else [])
    done = run(lgs, [command, *base, *words], folder)
    said = f"lgs {command} {option} {value[:60]!r}: "
    if done is None:
        return said + "does not end"
    text = (done.stdout + done.stderr).decode(errors="replace")
    if done.returncode not in answers(option, kind, value):
        return said + f"status {done.returncode}: {text[-600:]}"
    if "Sanitizer" in text or "runtime error" in text:
        return said + text[-600:]
    if done.returncode == 2 and not done.stderr.strip():
        return said + "status 2 without a sentence"
    return None


def main():
    lgs = str(pathlib.Path(sys.argv[1]).resolve())
    wanted = sys.argv[2:] or list(COMMANDS)
    listed = re.findall(r"^  ([a-z]+) ", subprocess.run([lgs, "--help"], capture_output=True, text=True,
                                                        check=True).stdout, re.MULTILINE)
    faults = [f"lgs {name}: a command that is in no table of this test" for name in listed if name not in COMMANDS]
    count = 0
    with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor() as pool:
        jobs = []
        of_import = {option for option, _ in options(lgs, "import")}  # which `lgs check` takes with a map alone
        for command in [name for name in wanted if name in listed]:
            found = options(lgs, command)
            if len(found) < 2:
                faults.append(f"lgs {command}: its help lists no options that this test can read")
            for option, kind in found:
                if kind == "":
                    continue
                if not (kind in REALS | WHOLES | TEXTS | PATHS or "|" in kind):
                    faults.append(f"lgs {command} {option}: '{kind}' is in no table of this test")
                count += 1
                for k, value in enumerate(values(kind)):
                    place = pathlib.Path(folder, f"{command}{option}{k}")
                    place.mkdir()
                    jobs.append(pool.submit(fault, lgs, command, option, kind, value, str(place),
                                            command == "check" and option in of_import))
        faults += [found for found in (job.result() for job in jobs) if found]
    for line in faults:
        print(line)
    print(f"options: {count} options with {len(jobs)} values, {len(faults)} faults")
    return 1 if faults or count < 2 else 0


if __name__ == "__main__":
    sys.exit(main())
