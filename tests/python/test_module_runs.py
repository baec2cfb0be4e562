"""The Python module as a process: a run watched and given up, the launcher, an older NumPy."""

from __future__ import annotations

import inspect
import json
import os
import shutil
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from conftest import ROOT
from module_fixtures import same
from results import Array, Run, write_pcd

tank_datum = pytest.importorskip("tank_datum", reason="the module is not installed")

Runner = Callable[..., Run]
SAMPLE = ROOT / "tests" / "data" / "sample.pcd"


# ---- a run watched and given up ----


def test_progress_names_the_stages() -> None:
    stages: list[str] = []
    tank_datum.extract_datum(SAMPLE, progress=stages.append)
    assert stages[:4] == ["locate", "crop", "setups", "normals"] and stages[-1] == "checks"


def test_what_progress_raises_ends_the_run(datum: Any) -> None:
    def stop(stage: str) -> None:
        raise LookupError(stage)

    with pytest.raises(LookupError, match="locate"):
        tank_datum.extract_datum(SAMPLE, progress=stop)
    same(tank_datum.extract_datum(SAMPLE).stations["z"], datum.stations["z"])


INTERRUPTED = """
import os, signal, sys, threading, time
import numpy as np, tank_datum
signal.signal(signal.SIGINT, signal.default_int_handler)  # ignored in background jobs
random = np.random.default_rng(1)
points = 60 * random.random((30_000_000, 3), dtype=np.float32) - 30

def interrupt():  # after a few turns of its own, which it has where the lock is free
    for _ in range(10):
        time.sleep(0.02)
    os.kill(os.getpid(), signal.SIGINT)

try:
    threading.Thread(target=interrupt, daemon=True).start()
    tank_datum.extract_datum(points)
except KeyboardInterrupt:
    sys.exit(3)
"""


def test_ctrl_c_is_heard_while_it_runs_and_the_lock_is_free() -> None:
    done = subprocess.run([sys.executable, "-c", INTERRUPTED], capture_output=True, text=True)
    assert done.returncode == 3, done.stderr


# ---- the launcher ----


def launcher() -> Path:
    return Path(sys.executable).parent / "tank_datum"


@pytest.mark.parametrize(
    "arguments", [["--version"], ["--help"], ["none.pcd"], ["--k", "1", str(SAMPLE)], ["--wrong"]]
)
def test_launcher_is_the_command(run: Runner, tmp_path: Path, arguments: list[str]) -> None:
    wanted = run(*arguments, cwd=tmp_path)
    got = subprocess.run([launcher(), *arguments], cwd=tmp_path, capture_output=True, text=True)
    assert (got.returncode, got.stdout, got.stderr) == (
        wanted.returncode,
        wanted.stdout,
        wanted.stderr,
    )


def test_launcher_writes_the_same_bytes(command: Path, tmp_path: Path) -> None:
    out = tmp_path / "out"
    assert subprocess.run([launcher(), SAMPLE, "-o", out, "--quiet"]).returncode == 0
    for file in sorted(command.iterdir()):
        assert (out / file.name).read_bytes() == file.read_bytes(), file.name


# ---- NumPy ----

OLD_NUMPY = """
import json, sys
import numpy as np, tank_datum
points = np.load(sys.argv[1])
print(np.__version__)
print(json.dumps(tank_datum.extract_datum(points).stations["z"].tolist()))
"""


def test_numpy_1(datum: Any, points: Array, tmp_path: Path) -> None:
    """NumPy 1.24, installed beside, sees the same values."""
    pip = [sys.executable, "-m", "pip", "install", "-q", "--no-deps", "--only-binary", ":all:"]
    subprocess.run([*pip, "--target", tmp_path / "old", "numpy==1.24.4"], check=True)
    shutil.copytree(Path(inspect.getfile(tank_datum)).parent, tmp_path / "old" / "tank_datum")
    np.save(tmp_path / "points.npy", points)
    result = subprocess.run(
        [sys.executable, "-c", OLD_NUMPY, tmp_path / "points.npy"],
        env={**os.environ, "PYTHONPATH": str(tmp_path / "old")},
        capture_output=True,
        text=True,
    )
    assert result.returncode == 0, result.stderr
    version, values = result.stdout.splitlines()
    assert version == "1.24.4" and np.__version__.startswith("2.")
    same(np.array(json.loads(values)), datum.stations["z"])


def test_floats_far_from_zero_are_warned_of_as_in_a_file(points: Array, tmp_path: Path) -> None:
    """The same words from an array of 4-byte floats, a file of them, and none from doubles."""
    far = points + [300_000.0, 5_000_000.0, 0.0]
    columns = dict(zip("xyz", far.T.astype("<f4"), strict=True))
    of_file = tank_datum.extract_datum(write_pcd(tmp_path / "far.pcd", columns))
    of_array = tank_datum.extract_datum(far.astype(np.float32))
    assert "coordinates have steps of 500 mm here" in of_array.message
    assert of_array.message == of_file.message
    assert "steps" not in tank_datum.extract_datum(far).message
