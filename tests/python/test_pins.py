"""What pip installs here is pinned, each file by its hash."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from conftest import ROOT

LISTS = ["tests/python/requirements", "scripts/wheels"]


def pins(text: str) -> dict[str, str]:
    """Package and version of each line that begins with them."""
    found = re.findall(r"^([A-Za-z0-9_.-]+)(?:\[\w+\])?==([^\s;]+)", text, re.MULTILINE)
    return {re.sub(r"[-_.]+", "-", name).lower(): version for name, version in found}


@pytest.mark.parametrize("name", LISTS)
def test_every_package_asked_for_is_locked_at_its_version(name: str) -> None:
    asked = (ROOT / f"{name}.txt").read_text()
    locked = pins((ROOT / f"{name}.lock").read_text())
    assert len(pins(asked)) == len(asked.splitlines())
    assert pins(asked).items() <= locked.items()


@pytest.mark.parametrize("name", LISTS)
def test_every_locked_package_has_hashes(name: str) -> None:
    entries = re.split(r"\n(?! )", (ROOT / f"{name}.lock").read_text().strip())
    assert all(re.search(r"--hash=sha256:[0-9a-f]{64}", entry) for entry in entries)


def test_pip_is_told_to_require_hashes() -> None:
    scripts = [path for path in (ROOT / "scripts").iterdir() if path.is_file()]
    for script in (p for p in scripts if p.suffix in ("", ".sh")):
        for line in installs(script):
            assert "--require-hashes" in line or "--no-deps" in line, f"{script.name}: {line}"


def installs(script: Path) -> list[str]:
    """Lines of a script in which pip installs something."""
    lines = script.read_text().replace("\\\n", " ").splitlines()
    return [
        line for line in lines if re.search(r'pip"? install', line) and not line.startswith("#")
    ]
