"""A scheduler that is not there: refused at once where it cannot be one, waited for else."""

from __future__ import annotations

import subprocess
import time
from pathlib import Path

import pytest

from farm_made import Farm, command_line, environment, farm_command, require_farm, scan

require_farm()

NOBODY = "127.0.0.1:9"  # the port of the discard service, which nobody runs


@pytest.fixture
def farm(tmp_path: Path) -> Farm:
    scan(tmp_path / "a.pcd", seed=1)
    farm = Farm(tmp_path)
    farm.tank("T", "radius = 4")
    farm.scan("a.pcd", "T", "2026-01-01")
    return farm


def test_what_is_neither_an_address_nor_a_file_is_refused(farm: Farm) -> None:
    said = farm_command("run", farm.write(), "--scheduler", "nosuch.json")
    assert said.returncode == 2
    assert "nosuch.json, expected HOST:PORT or a scheduler file that exists" in said.stderr


def test_waiting_for_one_ends_when_asked(farm: Farm) -> None:
    words = command_line("run", farm.write(), "--scheduler", NOBODY)
    with subprocess.Popen(words, env=environment(), stderr=subprocess.PIPE, text=True) as run:
        time.sleep(4.0)
        run.terminate()
        _, said = run.communicate(timeout=30)
    assert run.returncode == 130, said
