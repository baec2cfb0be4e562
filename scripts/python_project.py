"""Lays out the Python project for an sdist: the repository with pyproject.toml at its root.

Usage: python scripts/python_project.py FOLDER     (which must not be there yet)
"""

from __future__ import annotations

import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
PARTS = (
    "CMakeLists.txt",
    "LICENSE",
    "README.md",
    "apps",
    "include",
    "src",
    "scripts/pyproject.toml",
    "scripts/wheels_image.sh",
)
# what scripts/pyproject.toml says of the folder above it, and what holds at the root
MOVED = {
    'source-dir = ".."': 'source-dir = "."',
    'build-dir = "../build-python-': 'build-dir = "build-python-',
    'input = "../CMakeLists.txt"': 'input = "CMakeLists.txt"',
    'license = { text = "BSD-3-Clause" }': 'license = "BSD-3-Clause"\nlicense-files = ["LICENSE"]\n'
    'readme = "README.md"',
}


def at_the_root(text: str) -> str:
    """pyproject.toml for the root of the sources."""
    for old, new in MOVED.items():
        if text.count(old) != 1:
            raise SystemExit(f"python_project: {old!r} {text.count(old)} times, expected once")
        text = text.replace(old, new)
    return text


def lay_out(folder: Path) -> None:
    listed = ["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard", "--", *PARTS]
    run = subprocess.run(listed, cwd=ROOT, capture_output=True, text=True, check=True)
    folder.mkdir(parents=True)
    for name in filter(None, run.stdout.split("\0")):
        if name != "scripts/pyproject.toml" and (ROOT / name).exists():
            target = folder / name
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(ROOT / name, target)
    text = (ROOT / "scripts/pyproject.toml").read_text()
    (folder / "pyproject.toml").write_text(at_the_root(text))


if __name__ == "__main__":
    lay_out(Path(sys.argv[1]))
