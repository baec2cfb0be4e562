"""scripts/setup.sh where it cannot install: it says what to install by hand, and ends."""

from __future__ import annotations

import os
import shutil
import subprocess
from pathlib import Path

import pytest

from conftest import ROOT


@pytest.mark.parametrize("call", ["update", "install"])
def test_packages_that_cannot_be_installed_are_named(tmp_path: Path, call: str) -> None:
    programs = {
        "apt-get": f'[ "$1" != {call} ]',
        "dpkg-query": "exit 1",
        "sudo": 'exec "$@"',
    }
    for name, text in programs.items():
        (tmp_path / name).write_text(f"#!/bin/sh\n{text}\n")
        (tmp_path / name).chmod(0o755)
    script = f'source "{ROOT}/scripts/setup.sh"; apt_install one two; echo went on'
    done = subprocess.run(
        ["bash", "-c", script, str(ROOT / "scripts/run")],
        env={**os.environ, "PATH": f"{tmp_path}:{os.environ['PATH']}"},
        capture_output=True,
        text=True,
    )
    assert done.returncode == 3
    assert done.stdout == ""
    said = done.stderr.splitlines()
    assert said[0] == "== installing packages: one two"
    assert said[-1].endswith("install these, then run this again: one two")


@pytest.mark.parametrize(
    "script",
    [
        pytest.param(path, id=path.name)
        for path in sorted((ROOT / "scripts").iterdir())
        if path.is_file() and os.access(path, os.X_OK) and "/setup.sh" in path.read_text()
    ],
)
def test_help_is_what_a_script_begins_with(tmp_path: Path, script: Path) -> None:
    """Without anything to install or build with: PATH holds bash, sed and dirname only."""
    for name in ("bash", "sed", "dirname"):
        (tmp_path / name).symlink_to(shutil.which(name) or name)
    done = subprocess.run(
        [str(tmp_path / "bash"), str(script), "--help"],
        env={"PATH": str(tmp_path)},
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stderr
    assert done.stderr == ""
    assert done.stdout.startswith(f"./scripts/{script.name}")
