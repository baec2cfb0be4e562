"""Results on another file system, and in folders that refuse to be read or written."""

from __future__ import annotations

import os
import shutil
import subprocess
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from conftest import executable
from foreign_folders import call, things
from results import Run


@pytest.fixture
def other_disk(tmp_path: Path) -> Iterator[Path]:
    """A file system of its own."""
    disk = tmp_path / "disk"
    disk.mkdir()
    made = subprocess.run(["mount", "-t", "tmpfs", "tmpfs", str(disk)], capture_output=True)
    if made.returncode != 0:
        yield Path("/dev/shm")
        return
    yield disk
    subprocess.run(["umount", str(disk)], check=True)


def test_folder_on_another_file_system(inputs: Path, other_disk: Path) -> None:
    out = other_disk / f"tank_datum_test_{os.getpid()}"
    out.mkdir()
    (out / "mine.txt").write_text("mine")
    for _ in range(2):
        assert call("tank_datum", ["{in}/tank.pcd", "-o", str(out)], inputs, out).returncode == 0
    assert (out / "mine.txt").read_text() == "mine"
    assert len(list(out.iterdir())) == 9
    shutil.rmtree(out)


@pytest.fixture
def as_nobody(tmp_path: Path) -> Callable[[list[object]], Run]:
    """Runs as a user whom permissions bind."""

    def call_as(words: list[object]) -> Run:
        options: dict[str, object] = {"user": 65534} if os.geteuid() == 0 else {}
        for folder in (tmp_path, *list(tmp_path.parents)[:-1]):
            if os.geteuid() == 0:
                folder.chmod(folder.stat().st_mode | 0o055)
        return subprocess.run(
            [str(w) for w in words], capture_output=True, text=True, timeout=60, **options
        )

    return call_as


@pytest.mark.parametrize("case", ["not listed", "read-only tank_1", "read-only folder"])
def test_folders_that_refuse(
    inputs: Path, tmp_path: Path, as_nobody: Callable[..., Run], case: str
) -> None:
    """One line, status 3, the old result whole."""
    out = tmp_path / "out"
    files = ["tank_1/datum.json=1"] if case == "read-only tank_1" else ["datum.json=1"]
    words = [executable("results_probe"), "tank_datum", out]
    tmp_path.chmod(0o777)
    assert as_nobody([*words, *files]).returncode == 0
    before = things(out)
    refusing = out / "tank_1" if case == "read-only tank_1" else out
    refusing.chmod(0o333 if case == "not listed" else 0o555)
    result = as_nobody([*words, *(f.replace("=1", "=2") for f in files), "stations.csv=2"])
    refusing.chmod(0o755)
    assert result.returncode == 3, result.stderr
    assert result.stderr.count("\n") == 1 and ", expected " in result.stderr
    assert things(out) == before
