"""Runs the wheel where there is no PCL: a root folder with Python, NumPy and the wheel alone.

Usage, as root: python scripts/wheel_check.py PYTHON FOLDER_OF_WHEELS
The sample's results must be those of the package's own command there, and the commands must run.
"""

from __future__ import annotations

import re
import resource
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
SAMPLE = ROOT / "tests/data/sample.pcd"
FORBIDDEN = ("pcl", "flann", "boost", "gomp", "crypto", "lzf", "g++", "cmake")
# what every manylinux wheel may ask for
EVERYWHERE = (
    "libstdc++.so.6",
    "libgcc_s.so.1",
    "libpthread.so.0",
    "libdl.so.2",
    "librt.so.1",
    "libutil.so.1",
    "libm.so.6",
)
COMMANDS = (
    "tank_datum",
    "tank_datum_compare",
    "tank_datum_convert",
    "tank_datum_report",
    "tank_datum_curves",
    "tank_datum_synth",
)
PROGRAM = """
import subprocess, sys
import tank_datum
datum = tank_datum.extract_datum("/work/sample.pcd", no_checksum=True)
assert datum.status == "ok" and datum.verdict.word == "INCOMPLETE", datum
datum.save("/work/module")
for name in {commands!r}:
    run = [sys.executable, f"/site/bin/{{name}}", "--version"]
    assert subprocess.run(run, capture_output=True, text=True, check=True).stdout.startswith(name)
words = [sys.executable, "/site/bin/tank_datum_qa", "--help"]
subprocess.run(words, check=True, capture_output=True)
words = ["/work/sample.pcd", "-o", "/work/command", "--no-checksum", "--quiet"]
subprocess.run([sys.executable, "/site/bin/tank_datum", *words], check=True)
"""


# $ORIGIN, by which the executables find their libraries, is told by /proc
ENTER = 'mount --bind /proc "$0/proc" && exec chroot "$0" "$@"'


def libraries_of(binary: Path) -> set[Path]:
    """What the loader finds for a program or a module."""
    listed = subprocess.run(["ldd", binary], capture_output=True, text=True, check=False).stdout
    return {Path(path) for path in re.findall(r"(?:=> |^\s*)(/\S+) \(", listed, re.MULTILINE)}


def copy_into(root: Path, path: Path) -> None:
    target = root / path.relative_to("/")
    if not target.exists():
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(path.resolve(), target)


def make_root(root: Path, python: Path, wheel: Path) -> None:
    """A root folder with an interpreter, its library, NumPy and the wheel."""
    ask = "import sysconfig; print(sysconfig.get_path('stdlib'))"
    run = subprocess.run([python, "-c", ask], capture_output=True, text=True, check=True)
    stdlib = Path(run.stdout.strip())
    shutil.copytree(
        stdlib, root / stdlib.relative_to("/"), ignore=shutil.ignore_patterns("test", "__pycache__")
    )
    copy_into(root, python)
    binaries = [python, *stdlib.glob("lib-dynload/*.so")]
    for library in set().union(*(libraries_of(binary) for binary in binaries)):
        copy_into(root, library)
    for name in EVERYWHERE:
        copy_into(root, next(Path("/").glob(f"usr/lib/*/{name}")))
    install = [python, "-m", "pip", "install", "--quiet", "--disable-pip-version-check"]
    install += ["--root-user-action", "ignore"]
    began, before = time.monotonic(), resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run([*install, "--target", root / "site", "--no-deps", wheel], check=True)
    used, seconds = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic() - began
    busy = used.ru_utime + used.ru_stime - before.ru_utime - before.ru_stime
    print(f"pip install of {wheel.name}: {seconds:.1f} s, of a processor {busy:.1f} s", flush=True)
    subprocess.run([*install, "--no-compile", "--target", root / "site", "numpy"], check=True)
    for folder in ("tmp", "dev", "work", "proc"):
        (root / folder).mkdir(exist_ok=True)
    (root / "dev/null").write_text("")
    shutil.copy(SAMPLE, root / "work/sample.pcd")


def foreign(root: Path) -> list[Path]:
    """What should not be there outside the package."""
    return [
        path
        for path in root.rglob("*")
        if "site" not in path.relative_to(root).parts[:1]
        and path.suffix != ".py"
        and any(word in path.name for word in FORBIDDEN if not path.name.startswith("_"))
        and "python3" not in str(path.parent)
    ]


def main() -> int:
    python = Path(shutil.which(sys.argv[1]) or sys.argv[1]).resolve()
    tag = python.name.replace("python", "cp").replace(".", "")
    wheel = next(Path(sys.argv[2]).glob(f"*{tag}-*manylinux*.whl"))
    with tempfile.TemporaryDirectory() as folder:
        root = Path(folder)
        make_root(root, python, wheel)
        if there := [p for p in foreign(root) if "crypto" not in p.name]:
            print(f"wheel_check: {there[0]} is there, expected a root without PCL", file=sys.stderr)
            return 1
        run = ["unshare", "--mount", "sh", "-c", ENTER, root]
        program = PROGRAM.format(commands=COMMANDS)
        environment = {"PYTHONPATH": "/site", "PATH": "/usr/sbin:/usr/bin:/sbin:/bin"}
        subprocess.run([*run, python, "-c", program], env=environment, check=True)
        for file in sorted((root / "work/command").iterdir()):
            if (root / "work/module" / file.name).read_bytes() != file.read_bytes():
                print(
                    f"wheel_check: {file.name} differs between module and command", file=sys.stderr
                )
                return 1
    print("the wheel runs without PCL; module and command write the same files")
    return 0


if __name__ == "__main__":
    sys.exit(main())
