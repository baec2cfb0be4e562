"""One browser for all tests, and the pages that many of them look at."""

from __future__ import annotations

import shutil
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from report_pages import SAMPLE, Opened, opened
from results import Run, read_points, write_xyz

Runner = Callable[..., Run]

STEEL = ("--height", 12, "--yield-mpa", 235, "--modulus-mpa", 206_000)
JUDGED = (*STEEL, "--roof", "open", "--foundation", "ringwall")


@pytest.fixture(scope="session")
def browser() -> Iterator[Any]:
    sync_api = pytest.importorskip("playwright.sync_api")
    chromium = shutil.which("chromium")
    assert chromium, "chromium is not installed: ./scripts/test does so"
    with sync_api.sync_playwright() as tool:
        started = tool.chromium.launch(executable_path=chromium, args=["--no-sandbox"])
        yield started
        started.close()


@pytest.fixture(scope="session")
def sample_report(run: Runner, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The result of the sample, with all that its checks ask for."""
    out = tmp_path_factory.mktemp("report") / "sample"
    assert run(SAMPLE, "-o", out, *JUDGED).returncode == 0
    return out


@pytest.fixture(scope="session")
def gaps_report(run: Runner, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The sample without the points of 100 to 130 and 200 to 206 degrees."""
    folder = tmp_path_factory.mktemp("report")
    points = read_points(SAMPLE)
    azimuth = np.degrees(np.arctan2(points[:, 1], points[:, 0])) % 360.0
    seen = ~((azimuth > 100) & (azimuth < 130)) & ~((azimuth > 200) & (azimuth < 206))
    scan = write_xyz(folder / "gaps.pcd", points[seen])
    assert run(scan, "-o", folder / "gaps").returncode == 0
    return folder / "gaps"


@pytest.fixture(scope="session")
def no_tank_report(run: Runner, tmp_path_factory: pytest.TempPathFactory) -> Path:
    out = tmp_path_factory.mktemp("report") / "no_tank"
    assert run(SAMPLE, "-o", out, "--min-radius", 20).returncode == 1
    return out


@pytest.fixture
def page(browser: Any, sample_report: Path) -> Iterator[Opened]:
    with opened(browser, sample_report / "report.html") as shown:
        yield shown


@pytest.fixture(scope="session")
def still(browser: Any, sample_report: Path) -> Iterator[Opened]:
    """The same for tests that only look."""
    with opened(browser, sample_report / "report.html") as shown:
        yield shown
