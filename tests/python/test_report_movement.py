"""Movement in report.html: since a baseline, and the page of several surveys with its trends."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from report_pages import SAMPLE, inked, opened, plain, scale_of, with_data
from results import Run, read_datum, read_points, write_xyz
from test_compare import compare, epoch

Runner = Callable[..., Run]


def test_movement_since_a_baseline(
    run: Runner,
    browser: Any,
    sample_report: Path,
    tmp_path: Path,
) -> None:
    """Two scans of one tank, the second sunk by 3 mm between 80 and 140 degrees."""
    points = read_points(SAMPLE)
    azimuth = np.degrees(np.arctan2(points[:, 1], points[:, 0])) % 360.0
    points[(azimuth > 80) & (azimuth < 140), 2] -= 0.003
    scan = write_xyz(tmp_path / "later.pcd", points)
    done = run(scan, "-o", tmp_path / "out", "--baseline", sample_report)
    assert done.returncode == 0
    movement = read_datum(tmp_path / "out")["movement"]
    rest = movement["out_of_plane"]
    assert rest["value"] == pytest.approx(-0.003, abs=4e-4) and rest["significant"]
    assert 80 <= rest["azimuth_deg"] <= 140
    with opened(browser, tmp_path / "out" / "report.html") as page:
        assert page.slips() == []
        told = next(line for line in done.stdout.splitlines() if line.startswith("movement "))
        for place in ("#movement p", "#summary p.quality"):
            assert told.split(maxsplit=1)[1] in plain(page.text(place)), place
        assert "MOVED" in told and "only if both surveys share one height" in told
        assert page.page.locator("#movement-chart path.fit").count() == 1
        assert inked(page.picture("#movement-plan svg")) > 0.005
        a, b = scale_of(page, "movement-chart", 0)
        page.hover("movement-chart", (110 - a) / b, 120)
        dz = 1e3 * movement["stations"][110]["dz"]
        assert f"\u2212{-dz:.2f}\u00a0mm" in page.text("#tip")
        assert "significant" in page.text("#tip")
        significant = sum(s["significant"] for s in movement["stations"])
        assert page.page.locator("#movement-chart circle.significant").count() == significant > 40


def test_a_tank_that_sank_as_a_whole(browser: Any, tmp_path: Path) -> None:
    """The rigid part alone: 5 mm down, nothing out of plane; the terminal and the page say so."""
    before, after = epoch(tmp_path / "a.json"), epoch(tmp_path / "b.json")
    survey = json.loads(after.read_text())
    for station in survey["stations"]:
        station["z"] -= 0.005
    after.write_text(json.dumps(survey))
    options = ("--registration-error", 0.001, "--registration-tilt-arcsec", 2)
    done = compare(before, after, "-o", tmp_path / "m", *options)
    movement = json.loads((tmp_path / "m" / "movement.json").read_text())["movements"][0]
    assert movement["mean"]["value"] == pytest.approx(-0.005, abs=1e-6)
    assert abs(movement["out_of_plane"]["value"]) < 1e-6
    assert not movement["out_of_plane"]["significant"]
    assert movement["moved"] and movement["not_given"] == []
    assert "change of mean -5.00 mm" in done.stdout and "only if both" not in done.stdout
    assert not movement["tilt_change"]["significant"] and "risen towards" not in done.stdout
    with opened(browser, tmp_path / "m" / "report.html") as page:
        assert page.slips() == []
        said = next(line.strip() for line in done.stdout.splitlines() if "MOVED" in line)
        assert said.removeprefix("MOVED: ") in plain(page.text("#trend .verdict"))
        assert "known to 1.00\u00a0mm and 2.0 arc-seconds" in page.text("#trend .verdict")


def test_one_height_is_not_asked_for_where_it_is_taken_out(browser: Any, tmp_path: Path) -> None:
    surveys = [epoch(tmp_path / f"{i}.json", 0.002 * i) for i in range(2)]
    said = {}
    for removed in ("none", "mean", "tilt"):
        done = compare(*surveys, "-o", tmp_path / removed, "--remove", removed)
        said[removed] = [words in done.stdout for words in ("share one height", "share one level")]
        word = {
            "none": "NO MOVEMENT SHOWN: ",
            "mean": "BESIDE THE MEAN: ",
            "tilt": "OUT OF PLANE: ",
        }
        assert ("MOVED: " in done.stdout) != (word[removed] in done.stdout)
        with opened(browser, tmp_path / removed / "report.html") as page:
            assert page.text("#trend .word").split(maxsplit=1)[1] in done.stdout
    assert said == {"none": [True, True], "mean": [False, True], "tilt": [False, False]}


def test_trend_over_surveys(browser: Any, tmp_path: Path) -> None:
    surveys = [epoch(tmp_path / f"{'<b>' * i}{i}.json", 0.002 * i) for i in range(4)]
    assert compare(*surveys, "-o", tmp_path / "m").returncode == 0
    with opened(browser, tmp_path / "m" / "report.html") as page:
        assert page.slips() == []
        assert page.page.locator("main b").count() == 0
        assert page.page.locator("#trend tbody tr").count() == 3
        assert "\u22126.00\u00a0mm" in page.text("#trend tbody")
        assert page.page.locator("#trend-chart path.survey").count() == 3
        a, b = scale_of(page, "trend-chart", 0)
        page.click("trend-chart", (100 - a) / b, 120)
        assert "Movement at 100.0\u00b0" in page.page.locator("#course-chart").text_content()
        points = page.page.locator("#course-chart circle.survey-point").all()
        heights = [float(point.get_attribute("cy")) for point in points]
        assert np.allclose(np.diff(heights), np.diff(heights)[0]) and np.diff(heights)[0] > 20
        assert "mm/survey" in page.text("#trend .verdict")
        labels = page.page.locator("#course-chart text.survey-label").all_text_contents()
        assert labels == ["0", "1", "2", "3"]
        for name, read in (("movement.json", json.loads), ("movement.csv", bytes)):
            saved = page.downloaded(page.page.get_by_role("button", name=name, exact=True))
            assert read(saved) == read((tmp_path / "m" / name).read_bytes())


# pairs of texts of a drawing that lie over each other
OVER = """svg => { const texts = [...svg.querySelectorAll('text')], out = [];
  const boxes = texts.map(t => t.getBoundingClientRect());
  boxes.forEach((a, i) => boxes.slice(i + 1).forEach((b, j) => {
    const wide = Math.min(a.right, b.right) - Math.max(a.left, b.left);
    const tall = Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top);
    if (wide > 1 && tall > 4) out.push([texts[i].textContent, texts[i + 1 + j].textContent]);
  }));
  return out; }"""


@pytest.mark.parametrize("language", ["en", "es"])
def test_texts_of_the_course_lie_apart_on_a_phone(
    browser: Any, tmp_path: Path, language: str
) -> None:
    """In Spanish and feet the rate was drawn over the chart's title."""
    surveys = [epoch(tmp_path / f"{i}.json", 0.002 * i) for i in range(3)]
    options = ("--display-units", "ft", "--language", language)
    assert compare(*surveys, "-o", tmp_path / "m", *options).returncode == 0
    with opened(browser, tmp_path / "m" / "report.html", size=(360, 800)) as page:
        svg = page.page.locator("#course-chart svg")
        assert f"ft/{'survey' if language == 'en' else 'levantamiento'}" in svg.text_content()
        assert svg.evaluate(OVER) == []


def test_ticks_of_the_residuals_lie_apart_on_a_phone(
    browser: Any, sample_report: Path, tmp_path: Path
) -> None:
    told = {"display_units": "in"}
    path = with_data(sample_report / "report.html", tmp_path / "page.html", told)
    with opened(browser, path, size=(360, 800)) as page:
        assert page.page.locator("#residuals-chart svg").evaluate(OVER) == []


def test_the_fastest_station_is_chosen_first_or_the_one_that_the_address_names(
    browser: Any, sample_report: Path, tmp_path: Path
) -> None:
    later = tmp_path / "later.json"
    survey = json.loads(epoch(later).read_text())
    for station in survey["stations"]:
        station["z"] -= 0.004 * np.exp(-(((station["azimuth_deg"] - 200) / 20) ** 2))
    later.write_text(json.dumps(survey))
    assert compare(epoch(tmp_path / "first.json"), later, "-o", tmp_path / "m").returncode == 0
    result = json.loads((tmp_path / "m" / "movement.json").read_text())
    rates = result["trend"]["stations"]
    fastest = max(rates, key=lambda s: abs(s["rate"] or 0.0))["azimuth_deg"]
    assert fastest == pytest.approx(200, abs=10)
    page_file = tmp_path / "m" / "report.html"
    with opened(browser, page_file) as page:
        course = page.page.locator("#course-chart")
        assert f"Movement at {fastest:.1f}\u00b0" in course.text_content()
        page.page.goto(page_file.resolve().as_uri() + "#station=17")
        named = f"Movement at {rates[17]['azimuth_deg']:.1f}\u00b0"
        assert named in course.text_content()
        assert page.page.locator(".signature").is_hidden()
        page.page.emulate_media(media="print")
        assert page.texts(".signature span") == ["Inspector", "Date", "Signature"]


def test_trend_over_dates(browser: Any, tmp_path: Path) -> None:
    """Dates along the axis at their times, each station's rate per year, and what was compared."""
    surveys = [epoch(tmp_path / f"{i}.json", d) for i, d in enumerate((0.0, 0.001, 0.004))]
    dates, times = (
        ("2024-05-31", "2025.5", "2026-11-02"),
        (2024 + 151 / 366, 2025.5, 2026 + 305 / 365),
    )
    options = ("--dates", ",".join(dates), "--registration-error", 0.0001)
    assert compare(*surveys, "-o", tmp_path / "m", *options).returncode == 0
    result = json.loads((tmp_path / "m" / "movement.json").read_text())
    rate = result["trend"]["stations"][100]
    with opened(browser, tmp_path / "m" / "report.html") as page:
        assert page.slips() == []
        assert all(date in page.text("#scans") for date in dates)
        assert all(date in page.text("#trend tbody") for date in dates[1:])
        said = f"\u2212{-1e3 * rate['rate']:.2f} \u00b1 {2e3 * rate['sigma']:.2f}\u00a0mm/year"
        a, b = scale_of(page, "rate-chart", 0)
        page.hover("rate-chart", (100 - a) / b, 120)
        assert f"Trend {said}" in page.text("#tip")
        assert page.page.locator("#trend-chart line.hovered").get_attribute("visibility") is None
        page.click("rate-chart", (100 - a) / b, 120)
        assert said in page.text("#spoken")
        assert said in page.page.locator("#course-chart").text_content()
        a, b = scale_of(page, "rate-chart", 1)
        dot = page.page.locator("#rate-chart circle.chosen").get_attribute("cy")
        assert a + b * float(dot) == pytest.approx(1e3 * rate["rate"], abs=0.02)
        labels = page.page.locator("#course-chart text.survey-label")
        assert tuple(labels.all_text_contents()) == dates
        x = [float(label.get_attribute("x")) for label in labels.all()]
        shares = [(t - times[0]) / (times[2] - times[0]) for t in times]
        assert [(p - x[0]) / (x[2] - x[0]) for p in x] == pytest.approx(shares, abs=1e-3)
        _, b = scale_of(page, "course-chart", 1)
        line = page.page.locator("#course-chart line.fit")
        y1, y2 = (float(line.get_attribute(name)) for name in ("y1", "y2"))
        assert b * (y2 - y1) / (times[2] - times[0]) == pytest.approx(1e3 * rate["rate"], rel=0.01)
        made = page.text("#provenance")
        assert "registration_error" in made and result["version"] in made
        for path, survey in zip(surveys, result["surveys"], strict=True):
            assert survey["sha256"] == hashlib.sha256(path.read_bytes()).hexdigest()
            assert survey["sha256"] in made
        for chart in ("trend-chart", "rate-chart", "course-chart"):
            assert inked(page.picture(f"#{chart} svg")) > 0.005


def test_few_stations_are_each_seen(browser: Any, tmp_path: Path) -> None:
    """Of a coarse baseline 24 stations are compared: dots with lines between, and no others."""
    coarse, later = epoch(tmp_path / "a.json"), epoch(tmp_path / "b.json", 0.005)
    survey = json.loads(coarse.read_text())
    survey["stations"] = survey["stations"][10::15]
    coarse.write_text(json.dumps(survey))
    assert compare(coarse, later, "-o", tmp_path / "m").returncode == 0
    movement = json.loads((tmp_path / "m" / "movement.json").read_text())["movements"][0]
    assert movement["matched"] == 24 and 0 < movement["significant"] < 24
    with opened(browser, tmp_path / "m" / "report.html") as page:
        assert page.slips() == []
        assert f"{movement['significant']} of 24 stations moved" in page.text("#trend .verdict")
        count = page.page.locator
        assert count("#trend-chart circle.significant").count() == movement["significant"]
        assert count("#trend-chart circle.unmoved").count() == 24 - movement["significant"]
        assert count("#rate-chart circle.station").count() == 24
        assert count("#trend-chart path.survey").get_attribute("d").count("L") == 24
        a, b = scale_of(page, "trend-chart", 0)
        page.hover("trend-chart", (15 - a) / b, 120)
        assert "not compared here" in page.text("#tip")
        page.click("trend-chart", (15 - a) / b, 120)
        assert "no later survey was compared here" in count("#course-chart").text_content()
        page.hover("trend-chart", (100 - a) / b, 120)
        assert "\u22125.00\u00a0mm" in page.text("#tip")
