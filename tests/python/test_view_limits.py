"""A picture of the viewer without the memory or the open files for it: one line and status 3."""

from __future__ import annotations

import os
import resource
import subprocess
from pathlib import Path

import pytest

from test_view import VIEWER

pytestmark = pytest.mark.skipif(not VIEWER.exists(), reason="tank_datum_view is not built")


@pytest.mark.parametrize("megabytes", [130, 200, 300, 400, 700])
def test_a_picture_without_the_memory_for_it(command: Path, tmp_path: Path, megabytes: int) -> None:
    """The libraries that draw end their process by a signal."""
    most = (megabytes << 20, megabytes << 20)
    refused_room(command, tmp_path, resource.RLIMIT_AS, most)


@pytest.mark.parametrize("files", [8, 12])
def test_a_picture_without_the_open_files_for_it(command: Path, tmp_path: Path, files: int) -> None:
    refused_room(command, tmp_path, resource.RLIMIT_NOFILE, (files, files))


def refused_room(folder: Path, place: Path, kind: int, most: tuple[int, int]) -> None:
    done = subprocess.run(
        [str(VIEWER), str(folder), "--screenshot", str(place / "view.png")],
        capture_output=True,
        text=True,
        env={k: v for k, v in os.environ.items() if k != "DISPLAY"},
        timeout=120,
        preexec_fn=lambda: resource.setrlimit(kind, most),
    )
    assert done.returncode == 3, done.stderr
    assert done.stderr.count("\n") == 1, done.stderr
    assert "(ulimit -v, ulimit -n)" in done.stderr
    assert not list(place.iterdir())
