"""report.html of what is not whole: gaps, no tank, another method, a levelling table."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from report_fixtures import JUDGED
from report_pages import SAMPLE, inked, opened, scale_of, with_data
from results import Run, read_datum, read_stations, write_xyz

Runner = Callable[..., Run]


def test_gaps_are_shaded_and_named(browser: Any, gaps_report: Path) -> None:
    stations = read_stations(gaps_report)
    missing = np.flatnonzero(stations.where("missing"))
    assert 25 <= len(missing) <= 35 and stations.where("interpolated").sum() >= 5
    with opened(browser, gaps_report / "report.html") as page:
        assert page.slips() == []
        assert "Datum found in part" in page.text(".quality")
        named = f"{missing[0] - 0.5:.1f}\u00b0 to {missing[-1] + 0.5:.1f}\u00b0"
        assert named in page.text("#summary")
        for chart in ("elevation-chart", "out-of-plane-chart"):
            gap = page.page.locator(f"#{chart} rect.gap")
            assert gap.count() == 1
            a, b = scale_of(page, chart, 0)
            left, width = (float(gap.get_attribute(n)) for n in ("x", "width"))
            assert a + b * left == pytest.approx(missing[0] - 0.5, abs=0.1)
            assert b * width == pytest.approx(len(missing), abs=0.1)
            line = page.page.locator(f"#{chart} path.datum").first.get_attribute("d")
            assert line.count("M") == 2  # broken, not bridged
        rings = page.page.locator("#elevation-chart circle.interpolated").count()
        assert rings == stations.where("interpolated").sum()
        page.page.locator("#station-number").fill(str(missing[10]))
        page.page.locator("#station-number").press("Enter")
        assert page.texts("#station-values dd") == [
            f"{missing[10]} at {missing[10]:.1f}\u00b0, missing"
        ]
        assert "no foundation line was accepted here" in page.text("#section-chart")
        assert page.slips() == []


def test_no_tank(browser: Any, no_tank_report: Path) -> None:
    """The reason once, the points that were looked at, three things to try; no empty sections."""
    datum = read_datum(no_tank_report)
    assert len(datum["advice"]) == 3 and "20 m" in datum["advice"][0]
    with opened(browser, no_tank_report / "report.html") as page:
        assert page.slips() == []
        assert "No tank found" in page.text(".verdict")
        said = datum["message"][1:]  # after its capital
        assert page.text("main").count(said) == 1
        assert page.texts("main > section h2") == ["No datum", "How it was made"]
        assert page.texts(".advice li") == datum["advice"]
        for chart in ("sighting-plan", "sighting-section"):
            assert inked(page.picture(f"#{chart} svg")) > 0.02, chart
        assert page.page.locator("#sighting-plan circle").count() == 0
        assert datum["input"]["files"][0]["hash"]["value"] in page.text("#provenance")


def test_a_rejected_circle_is_drawn(run: Runner, browser: Any, tmp_path: Path) -> None:
    """A square room: the circle tried stands among its walls, in plan and section."""
    side, z = np.meshgrid(np.arange(-5, 5, 0.05), np.arange(0, 4, 0.1))
    s, z, wall = side.ravel(), z.ravel(), np.full(side.size, 5.0)
    walls = [(s, wall), (s, -wall), (wall, s), (-wall, s)]
    points = np.concatenate([np.column_stack([x, y, z]) for x, y in walls])
    done = run(write_xyz(tmp_path / "room.pcd", points), "-o", tmp_path / "out")
    assert done.returncode == 1
    datum = read_datum(tmp_path / "out")
    assert done.stdout.count("\ntry ") == len(datum["advice"]) == 3
    assert "--tank" in done.stdout and "option" not in done.stdout
    with opened(browser, tmp_path / "out" / "report.html") as page:
        assert page.slips() == []
        circle = page.page.locator("#sighting-plan circle.limit")
        a, b = scale_of(page, "sighting-plan", 0)
        _, up = scale_of(page, "sighting-plan", 1)
        assert a + b * float(circle.get_attribute("cx")) == pytest.approx(0, abs=0.01)
        assert b == pytest.approx(-up, rel=1e-3)  # one scale for both ways
        radius = b * float(circle.get_attribute("r"))
        assert f"radius {radius:.2f}" in page.text("#summary .legend")
        assert page.page.locator("#sighting-section line.limit").count() == 1


def test_paper_method(run: Runner, browser: Any, tmp_path: Path) -> None:
    assert run(SAMPLE, "-o", tmp_path, "--method", "paper", "--clockwise").returncode == 0
    with opened(browser, tmp_path / "report.html") as page:
        assert page.slips() == []
        assert "fits a curve and no surfaces" in page.text("#station .absent")
        assert page.page.locator("#section-chart").count() == 0
        # azimuth 90 run clockwise is south of the centre
        box = page.page.locator("#plan-chart svg").bounding_box()
        across, down = box["width"] / 2, min(box["width"], box["height"]) / 2
        page.click("plan-chart", across, down + 0.66 * down)
        assert page.texts("#station-values dd")[0].startswith("90 at 90.0")


def test_no_report(run: Runner, sample_report: Path, tmp_path: Path) -> None:
    """Everything else stays the same, byte for byte."""
    result = run(SAMPLE, "-o", tmp_path, "--no-report", *JUDGED)
    assert result.returncode == 0
    assert result.stdout.splitlines()[-1].split() == ["results", f"{tmp_path}/datum.json"]
    others = sorted(p.name for p in sample_report.iterdir() if p.name != "report.html")
    assert sorted(p.name for p in tmp_path.iterdir()) == others
    for name in set(others) - {"manifest.json"}:  # it names the report
        assert (tmp_path / name).read_bytes() == (sample_report / name).read_bytes()


def test_without_them_each_says_why(
    browser: Any,
    sample_report: Path,
    tmp_path: Path,
) -> None:
    none = {"shell": None, "movement": None, "checks": None, "notes": None, "harmonics": None}
    path = with_data(sample_report / "report.html", tmp_path / "bare.html", none)
    with opened(browser, path) as page:
        assert page.slips() == []
        assert "option baseline" in page.text("#movement .absent")
        assert "too little of the shell" in page.text("#shell .absent")
        assert "Checks" in page.text("#summary .absent")
