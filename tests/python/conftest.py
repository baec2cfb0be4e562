"""What every test needs: the programs, small scans, and the results read back."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from pathlib import Path

import pytest

from foreign_folders import inputs, place  # noqa: F401
from module_fixtures import command, datum, points  # noqa: F401
from programs import ROOT, TIMEOUT, executable, run_program  # noqa: F401
from readable_ids import readable_id
from report_fixtures import (  # noqa: F401
    browser,
    gaps_report,
    no_tank_report,
    page,
    sample_report,
    still,
)
from results import Run

# A tank seen in a second or two: 4 m, 84 000 points, noise of a small scanner.
SMALL_TANK = (
    ("--radius", 4),
    ("--height", 3),
    ("--scanners", 4),
    ("--distance", 5),
    ("--step-deg", 0.2),
    ("--max-range", 15),
    ("--near-datum", 1),
    ("--tilt-slope", 0.002),
    ("--tilt-direction-deg", 30),
    ("--harmonics", "2:0.004:40"),
    ("--noise", 0.001),
)


def pytest_make_parametrize_id(config: pytest.Config, val: object, argname: str) -> str | None:
    """What pytest calls the tests of one parameter's values."""
    return readable_id(val)


@pytest.fixture(scope="session")
def run() -> Callable[..., Run]:
    """run(*arguments, cwd=None): tank_datum with these arguments."""

    def call(*args: object, cwd: Path | None = None, timeout: float = TIMEOUT) -> Run:
        return run_program("tank_datum", args, cwd, timeout)

    return call


@pytest.fixture(scope="session")
def synth(tmp_path_factory: pytest.TempPathFactory) -> Callable[..., Path]:
    """synth(*extra, base=SMALL_TANK, **options): a simulated scan, made once a session.

    The keywords are tank_datum_synth's options with underscores, and override those of the base.
    """
    folder = tmp_path_factory.mktemp("scans")
    made: dict[tuple[str, ...], Path] = {}

    def call(
        *extra: object, base: Sequence[tuple[str, object]] = SMALL_TANK, **options: object
    ) -> Path:
        merged = dict(base) | {f"--{k.replace('_', '-')}": v for k, v in options.items()}
        args = [str(word) for pair in merged.items() for word in pair] + [str(e) for e in extra]
        key = tuple(args)
        if key not in made:
            path = folder / f"scan{len(made)}.pcd"
            result = run_program("tank_datum_synth", ["-o", path, "--quiet", *args])
            assert result.returncode == 0, result.stderr
            made[key] = path
        return made[key]

    return call


@pytest.fixture(scope="session")
def data() -> Path:
    """The folder of real scans, TANK_DATUM_DATA."""
    folder = os.environ.get("TANK_DATUM_DATA")
    if not folder:
        pytest.skip("TANK_DATUM_DATA does not name the folder of real scans")
    return Path(folder)
