"""report.html of levelling tables: no scan, and the curvature of its shape against the limit."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from conftest import ROOT
from report_fixtures import STEEL
from report_pages import inked, opened, scale_of, with_data
from results import Run, read_datum, read_stations

Runner = Callable[..., Run]
FOURTEEN = ROOT / "tests" / "data" / "levelling" / "fourteen_stations.csv"


@pytest.fixture(scope="module")
def waves(run: Runner, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Of 60 m: tilt and two waves, levelled at 72 stations; as much curvature as its limit."""
    folder = tmp_path_factory.mktemp("waves")
    azimuth = np.arange(0.0, 360.0, 5.0)
    a = np.radians(azimuth)
    z = 0.03 * np.cos(a) + 0.2 * np.cos(2 * a) + 0.05 * np.cos(3 * a - 1)
    z += np.random.default_rng(7).normal(0.0, 0.002, 72)
    lines = [f"{d},{h:.5f},0.002" for d, h in zip(azimuth, z, strict=True)]
    table = folder / "waves.csv"
    table.write_text("\n".join(["azimuth_deg,elevation,sigma", *lines]) + "\n")
    for out, options in (("judged", STEEL), ("bare", ())):
        done = run("--stations-csv", table, "--diameter", 60, "-o", folder / out, *options)
        assert done.returncode == 0, done.stderr
    return folder


def test_a_table_is_not_called_a_scan(run: Runner, browser: Any, tmp_path: Path) -> None:
    done = run("--stations-csv", FOURTEEN, "--diameter", 42.0624, "-o", tmp_path)
    assert done.returncode == 0, done.stderr
    datum = read_datum(tmp_path)
    with opened(browser, tmp_path / "report.html") as page:
        assert page.slips() == []
        assert "Levelling survey: 14 stations measured" in page.text(".quality")
        facts = page.text("#summary .facts")
        assert "21.0312 m as given" in " ".join(facts.split())
        assert "Shell seen" not in facts and "unknown" not in facts
        for chart, values in (("elevation", "z"), ("out-of-plane", "u")):
            dots = page.page.locator(f"#{chart}-chart circle.station")
            assert dots.count() == 14
            a, b = scale_of(page, f"{chart}-chart", 1)
            drawn = [a + b * float(dot.get_attribute("cy")) for dot in dots.all()]
            wanted = 1e3 * read_stations(tmp_path)[values]
            wanted -= 1e3 * datum["datum"]["mean"] if values == "z" else 0.0
            assert np.allclose(drawn, wanted, atol=0.1)
            assert inked(page.picture(f"#{chart}-chart svg")) > 0.005
        assert "band" not in page.text("#elevation .legend")  # the table has no errors
        assert "paper" not in page.text("#elevation .legend")
        assert "typed in" in page.text("#station .absent")
        assert "holds elevations only" in page.text("#shell .absent")
        assert "regression is for more than 64" in page.text("#out-of-plane .absent")
        second = datum["out_of_plane"]["second_differences"]["worst"]["value"]
        assert f"{1e3 * second:.1f}\u00a0mm" in page.text("#out-of-plane .facts")
        assert page.texts("#provenance th")[0] == "Levelling"
        page.choose(4)
        assert page.texts("#station-values dd")[0].startswith("4 at 102.9\u00b0, measured")


def test_curvature_is_drawn_against_its_limit(browser: Any, waves: Path) -> None:
    found, stations = read_datum(waves / "judged")["out_of_plane"], read_stations(waves / "judged")
    limit = 1e6 * found["curvature_limit"]
    with opened(browser, waves / "judged" / "report.html") as page:
        assert page.slips() == []
        a, b = scale_of(page, "curvature-chart", 1)
        ends = page.page.locator("#curvature-chart line.limit").all()
        drawn = sorted(a + b * float(line.get_attribute("y1")) for line in ends)
        assert drawn == pytest.approx([-limit, limit], abs=1.0)
        for i in (0, 17, 40):
            page.choose(i)
            dot = page.page.locator("#curvature-chart circle.chosen")
            curvature = a + b * float(dot.get_attribute("cy"))
            assert curvature == pytest.approx(1e6 * stations["curvature"][i], abs=1.0)
        facts = page.text("#out-of-plane .facts").replace("\u2212", "-")
        assert f"{1e6 * found['max_curvature']:.1f}" in facts
        low, high = (1e6 * end for end in found["max_curvature_95"])
        assert f"95 %: {low:.1f} to {high:.1f}" in facts
        assert f"limit {limit:.1f}" in facts
        assert inked(page.picture("#curvature-chart svg")) > 0.01
        page.page.get_by_role("checkbox", name="limit").uncheck()
        assert page.page.locator("#curvature-chart line.limit").count() == 0


def test_without_a_limit_it_says_what_is_missing(browser: Any, waves: Path) -> None:
    with opened(browser, waves / "bare" / "report.html") as page:
        assert page.slips() == []
        assert "No limit is drawn: it needs" in page.text("#out-of-plane")
        assert page.page.locator("#curvature-chart line.limit").count() == 0
        assert page.page.locator("#curvature-chart path.fit").count() == 1


def test_harmonics_are_as_tall_as_their_amplitudes(
    browser: Any, waves: Path, tmp_path: Path
) -> None:
    harmonics = read_datum(waves / "judged")["harmonics"]
    with opened(browser, waves / "judged" / "report.html") as page:
        _, b = scale_of(page, "harmonics-chart", 1)
        bars = page.page.locator("#harmonics-chart rect.bar").all()
        tall = [-b * float(bar.get_attribute("height")) for bar in bars]
        assert tall == pytest.approx([1e3 * h["amplitude"] for h in harmonics[1:]], abs=0.1)
    for h in harmonics:
        h["sigma"] = 5.0
    path = with_data(
        waves / "judged" / "report.html", tmp_path / "page.html", {"harmonics": harmonics}
    )
    with opened(browser, path) as page:
        assert page.page.locator("#harmonics-chart").count() == 0
        assert "two standard errors reach 10.0\u00a0m" in page.text("#out-of-plane .absent")
