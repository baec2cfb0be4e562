"""Charts of the report: ways to a station, tolerances, what is not drawn, files taken along."""

from __future__ import annotations

import xml.etree.ElementTree as ElementTree
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from report_fixtures import JUDGED
from report_pages import SAMPLE, Opened, close_to, opened, pixels, plain, scale_of, with_data
from results import Run, read_datum, read_points, write_xyz

Runner = Callable[..., Run]
SVG = "{http://www.w3.org/2000/svg}"


@pytest.fixture(scope="module")
def bent(run: Runner, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A tank with a name, two of whose places fail."""
    folder = tmp_path_factory.mktemp("charts")
    (folder / "about.toml").write_text('tank = "T/12 <b>"\nsurvey_date = 2026-11-03\n')
    points = read_points(SAMPLE)
    points[:, 2] += 0.03 * np.cos(4 * np.arctan2(points[:, 1], points[:, 0]))
    scan = write_xyz(folder / "bent.pcd", points)
    about = ("--about", folder / "about.toml")
    assert run(scan, "-o", folder / "out", *JUDGED, *about).returncode == 0
    return folder / "out"


def chosen(page: Opened) -> int:
    return int(page.page.locator("#station-number").input_value())


def test_next_fail_leads_round_all_failing_places(browser: Any, bent: Path) -> None:
    wanted = {
        round(check["azimuth_deg"]) % 360
        for check in read_datum(bent)["checks"]
        if check["verdict"] in ("fail", "undecided") and check["azimuth_deg"] is not None
    }
    assert len(wanted) > 1
    with opened(browser, bent / "report.html") as page:
        button = page.page.get_by_role("button", name="next fail")
        met = []
        for _ in wanted:
            button.click()
            met.append(chosen(page))
        assert set(met) == wanted
        turns = np.mod(np.diff([*met, met[0]]), 360)
        assert turns.sum() == 360  # once round, none left out


def test_without_a_fail_there_is_no_such_button(still: Opened) -> None:
    assert still.page.get_by_role("button", name="next fail").count() == 0


def test_the_address_names_a_station(browser: Any, sample_report: Path) -> None:
    with opened(browser, sample_report / "report.html") as page:
        page.page.evaluate("window.location.hash = '#station=120'")
        page.page.wait_for_function("document.getElementById('station-number').value === '120'")


def test_values_stand_beside_the_chart_that_was_tapped(page: Opened) -> None:
    a, b = scale_of(page, "elevation-chart", 0)
    page.click("elevation-chart", (200 - a) / b, 120)
    assert "200 at 200.0" in page.text("figure:has(#elevation-chart) .picked")
    assert page.text("figure:has(#plan-chart) .picked") == ""


def test_tolerances_are_bands_where_they_fit(
    browser: Any, sample_report: Path, tmp_path: Path
) -> None:
    """Far out they wait in the legend; of a size with the figures they are drawn at once."""
    shell = read_datum(sample_report)["shell"]
    with opened(browser, sample_report / "report.html") as page:
        assert page.page.locator("#roundness-chart rect.beyond").count() == 0
        box = page.page.locator("figure:has(#roundness-chart)").get_by_role(
            "checkbox", name="tolerance"
        )
        box.check()
        _, b = scale_of(page, "roundness-chart", 1)
        ends = page.page.locator("#roundness-chart line.limit").all()
        y = [float(line.get_attribute("y1")) for line in ends]
        tolerance = min(r["tolerance"] for r in shell["roundness"] if r["tolerance"])
        assert abs(b * (y[1] - y[0])) == pytest.approx(2e3 * tolerance, rel=0.01)
        assert page.page.locator("#roundness-chart rect.beyond").count() == 2
    for r in shell["roundness"]:
        r["tolerance"] = 0.0002
    path = with_data(sample_report / "report.html", tmp_path / "tight.html", {"shell": shell})
    with opened(browser, path) as page:
        assert page.page.locator("#roundness-chart rect.beyond").count() == 2


@pytest.mark.parametrize(
    ("radius", "said"),
    [
        (5.0, "2 m; diameter 10.000 m"),
        (0.04, "0.02 m; diameter 0.080 m"),
        (45.0, "20 m; diameter 90"),
    ],
    ids=["tank", "mug", "large"],
)
def test_the_bar_of_the_plan_says_its_length(
    browser: Any, sample_report: Path, tmp_path: Path, radius: float, said: str
) -> None:
    tank = read_datum(sample_report)["tank"] | {"radius": radius}
    path = with_data(sample_report / "report.html", tmp_path / "r.html", {"tank": tank})
    with opened(browser, path) as page:
        assert said in plain(page.page.locator("#plan-chart").text_content())


def test_waves_that_cannot_be_told_apart_are_not_drawn(
    browser: Any, sample_report: Path, tmp_path: Path
) -> None:
    harmonics = read_datum(sample_report)["harmonics"]
    with opened(browser, sample_report / "report.html") as page:
        assert page.page.locator("#harmonics-chart rect.bar").count() >= 4
    for wave in harmonics:
        wave["sigma"] = 0.6 * max(h["amplitude"] for h in harmonics)
    path = with_data(sample_report / "report.html", tmp_path / "h.html", {"harmonics": harmonics})
    with opened(browser, path) as page:
        assert page.slips() == []
        assert page.page.locator("#harmonics-chart").count() == 0
        assert "cannot be told apart" in page.text("#out-of-plane .absent")


def test_a_chart_taken_along_is_light_and_says_what_it_is_of(browser: Any, bent: Path) -> None:
    with opened(browser, bent / "report.html", scheme="dark") as page:
        saved = {}
        for kind in ("SVG", "PNG"):
            button = page.page.get_by_role("button", name=f"elevation-chart as {kind}", exact=True)
            with page.page.expect_download() as waiting:
                button.click()
            assert waiting.value.suggested_filename == f"T_12_b__elevation-chart.{kind.lower()}"
            saved[kind] = Path(waiting.value.path()).read_bytes()
        assert page.page.evaluate("document.documentElement.className") == ""
        assert page.errors == []
    root = ElementTree.fromstring(saved["SVG"])
    said = [element.text for element in root.findall(f"{SVG}text")]
    assert said[0] == "Elevation of the datum against azimuth, with its uncertainty"
    assert "tank T/12 <b>; 2026-11-03" in said[1] and "bent.pcd" in said[1]
    assert said[2].startswith("datum") and "fitted tilt" in said and len(said) == 4
    image = pixels(saved["PNG"])
    assert image.shape[1] == 2 * float(root.get("width"))
    assert (image[2, 2] == 255).all() and (image[200, 4] == 255).all()
    assert close_to(image, (7, 87, 181)) > 1000  # the line's colour of a light page
