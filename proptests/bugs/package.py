"""The tests of the npm package, which Node runs against the modules of WebAssembly that were built."""

import os
import re
import shutil
import subprocess
import time
from dataclasses import dataclass
from pathlib import Path

import programs
from workshop import ROOT, AtFault, Workshop

MODULES = {"lgs_web": "lgs.wasm", "lgs_web_full": "lgs-full.wasm", "lgs_web_islands": "lgs-islands.wasm"}
# Of a browser, of how the package is packed, typed and described; and bugs in its TypeScript.
OF_OTHER_THINGS = {"example", "pack", "planted", "readme", "size", "types"}
FOLDER = Path("web/package")


def test_files(root: Path) -> list[str]:
    return sorted(path.name for path in (root / FOLDER / "test").glob("*.test.js")
                  if path.name.removesuffix(".test.js") not in OF_OTHER_THINGS)


def command() -> Path | None:
    """The native one, which some tests compare with; the same choice as in web/package/test/lgs.js."""
    built = [ROOT / "build" / preset / "cli" / "lgs" for preset in ("release", "asan")]
    named = [Path(os.environ["LGS_COMMAND"])] if "LGS_COMMAND" in os.environ else built
    return next((path for path in named if path.exists()), None)


def see_that_all_is_there() -> None:
    for needed in ("web/node_modules/.package-lock.json", "build/web-sources/complete"):
        if not (ROOT / needed).exists():
            raise AtFault(f"{needed} is missing: the web side is not set up (scripts/web_setup.sh)")
    if not shutil.which("node"):
        raise AtFault("Node is missing: the web side is not set up (scripts/web_setup.sh)")
    if not command():
        raise AtFault("the command lgs is not built (cmake --build --preset release --target lgs_cli)")


@dataclass(frozen=True)
class PackageTests:
    sources = ("CMakePresets.json", "web/wasm/", "web/package/")

    def kind(self, _: str) -> str:
        return "web"

    def build(self, workshop: Workshop, kind: str) -> list[Path]:
        see_that_all_is_there()
        workshop.build(kind, *MODULES)
        modules = [workshop.program(kind, name) for name in MODULES.values()]
        dist = workshop.tree / FOLDER / "dist"
        if not (dist / "index.js").exists():
            self.build_scripts(workshop, kind)
        for module in modules:
            shutil.copy(module, dist)
        return modules

    def build_scripts(self, workshop: Workshop, kind: str) -> None:
        """What is no WebAssembly: once, since no mutant changes it."""
        for link, to in (("web/node_modules", ROOT / "web/node_modules"), ("build/web", workshop.folder / kind)):
            link = workshop.tree / link
            link.parent.mkdir(exist_ok=True)
            link.unlink(missing_ok=True)
            link.symlink_to(to.resolve())
        done = subprocess.run(["node", "scripts/build.mjs"], cwd=workshop.tree / FOLDER, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        if done.returncode != 0:
            raise AtFault(f"without any mutant the npm package does not build:\n{done.stdout[-4000:]}")

    def measure(self, workshop: Workshop, kind: str, limit: float, environment: dict[str, str]):
        times, cpu = {}, 0.0
        for file in test_files(workshop.tree):
            begin = time.monotonic()
            result = self.run(workshop, kind, (file,), limit, environment)
            if result["verdict"] != "passes":
                return result, {}
            times[file] = time.monotonic() - begin
            cpu += result["cpu"]
        return {"verdict": "passes", "cpu": cpu}, times

    def run(self, workshop: Workshop, _: str, tests: tuple[str, ...], limit: float,
            environment: dict[str, str]) -> dict:
        """One file after the other, until one fails."""
        cpu = 0.0
        for file in tests:
            ran = programs.run(["node", "--test-reporter=tap", workshop.tree / FOLDER / "test" / file], limit - cpu,
                               {"LGS_COMMAND": str(command()), **environment}, memory="unlimited")
            cpu += ran.seconds
            if ran.status != 0:
                failed = re.search(r"^ *not ok \d+ - (.*)$", ran.output, re.MULTILINE)
                return {"verdict": "time-out" if ran.timed_out else "found", "cpu": round(cpu, 2),
                        "test": f"{file}: {failed[1]}" if failed else file, **({} if failed else {"how": "crashes"})}
        return {"verdict": "passes", "cpu": round(cpu, 2)}
