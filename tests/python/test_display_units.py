"""Lengths for readers in mm, in or ft: on the page and in the summary; files hold metres."""

from __future__ import annotations

import json
import math
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from programs import run_program
from report_fixtures import JUDGED
from report_pages import SAMPLE, opened, scale_of
from results import Run, read_datum, read_stations
from test_compare import epoch

Runner = Callable[..., Run]

FOOT = 0.3048
SHORT = {"in": FOOT / 12, "ft": FOOT}
# a length in metres or millimetres: "0.30 m", "6.0 mm", "[mm]", "mm/m"; rules say "18.6 m (61 ft)"
METRIC = re.compile(r"\d[\u00a0 ]mm?\b(?! \()|\[mm?\]|mm/m")


@pytest.fixture(scope="module", params=["in", "ft"])
def shown(
    request: pytest.FixtureRequest, run: Runner, tmp_path_factory: pytest.TempPathFactory
) -> tuple[str, Path, str]:
    unit = request.param
    out = tmp_path_factory.mktemp("units") / unit
    told = ("--survey-points", 8, "--display-units", unit)
    done = run(SAMPLE, "-o", out, *JUDGED, *told)
    assert done.returncode == 0, done.stderr
    return unit, out, done.stdout


def test_files_hold_metres(shown: tuple[str, Path, str], sample_report: Path) -> None:
    unit, out, _ = shown
    datum, metric = read_datum(out), read_datum(sample_report)
    assert datum.pop("display_units") == unit
    datum.pop("survey_points")
    assert datum == metric
    for name in ("stations.csv", "shell.csv"):
        assert (out / name).read_bytes() == (sample_report / name).read_bytes()


def test_no_metric_length_is_left_on_the_page(browser: Any, shown: tuple[str, Path, str]) -> None:
    unit, out, _ = shown
    datum = read_datum(out)
    with opened(browser, out / "report.html") as page:
        assert page.slips() == []
        page.page.locator("details.checks summary").first.click()
        said = page.page.evaluate(
            """() => { const copy = document.querySelector('main').cloneNode(true);
                 copy.querySelectorAll('pre, .paper-text, td[data-head="Note"],'
                   + ' td[data-head="Check"], td[data-head^="Rule"], .bars')
                   .forEach(e => e.remove());
                 return copy.textContent; }"""
        )
        assert METRIC.findall(said) == []
        facts = page.text("#summary .facts")
        assert f"{datum['tank']['radius'] / FOOT:.4f}\u00a0ft" in facts
        digits = {"in": 3, "ft": 4}[unit]
        assert f"{datum['datum']['range'] / SHORT[unit]:.{digits}f}\u00a0{unit}" in facts


def test_charts_have_the_unit_on_their_axes(browser: Any, shown: tuple[str, Path, str]) -> None:
    unit, out, _ = shown
    stations, datum = read_stations(out), read_datum(out)
    with opened(browser, out / "report.html") as page:
        page.choose(90)
        dot = float(page.page.locator("#elevation-chart circle.chosen").get_attribute("cy"))
        a, b = scale_of(page, "elevation-chart", 1)
        wanted = (stations["z"][90] - datum["datum"]["mean"]) / SHORT[unit]
        assert a + b * dot == pytest.approx(wanted, abs=5e-5 / SHORT[unit])
        for chart in ("elevation", "out-of-plane", "harmonics", "section"):
            assert f"[{unit}]" in page.page.locator(f"#{chart}-chart").text_content(), chart


def test_the_summary_has_them_too(shown: tuple[str, Path, str]) -> None:
    unit, out, said = shown
    assert METRIC.findall(said) == []
    radius = read_datum(out)["tank"]["radius"]
    assert f"radius {radius / FOOT:.3f} ft" in said


def test_movement_has_them(browser: Any, tmp_path: Path) -> None:
    surveys = [epoch(tmp_path / f"{i}.json", 0.002 * i) for i in range(3)]
    args = (*surveys, "-o", tmp_path / "m", "--display-units", "in")
    done = run_program("tank_datum_compare", args)
    assert done.returncode == 0
    assert "lod95_in" in done.stdout and "in/survey" in done.stdout and "mm" not in done.stdout
    result = json.loads((tmp_path / "m" / "movement.json").read_text())
    assert result["display_units"] == "in"
    largest = result["movements"][-1]["max"]
    assert largest == pytest.approx(-0.004, abs=1e-4)  # metres
    with opened(browser, tmp_path / "m" / "report.html") as page:
        assert page.slips() == []
        assert METRIC.findall(page.text("main > section:not(#provenance)")) == []
        assert f"{-largest / SHORT['in']:.4f}\u00a0in" in page.text("#trend")


def levelled(run: Runner, out: Path, count: int, diameter: float, *options: object) -> Path:
    """So many points of a plane."""
    lines = [f"{360 * i / count},{10 + 0.001 * (i % 3)},0.001" for i in range(count)]
    out.mkdir()
    (out / "table.csv").write_text("\n".join(["azimuth_deg,elevation,sigma", *lines]) + "\n")
    given = ("--stations-csv", out / "table.csv", "--diameter", diameter, *JUDGED, *options)
    done = run("-o", out / "out", *given)
    assert done.returncode == 0, done.stderr
    return out / "out" / "report.html"


def test_a_spacing_is_one_figure_in_note_and_card(
    run: Runner, browser: Any, tmp_path: Path
) -> None:
    """5.892 m: 5.89 m in the note, which is 19.32 ft; 19.33 ft stood beside it."""
    path = levelled(run, tmp_path / "s", 16, 16 * 5.892 / math.pi, "--display-units", "ft")
    with opened(browser, path) as page:
        page.page.locator("details.checks summary").first.click()
        (note,) = re.findall(r"16 points ([\d.]+) ft apart", page.text("#summary td"))
        (card,) = re.findall(r"16 points ([\d.]+)\u00a0ft apart", page.text("#out-of-plane .facts"))
        assert note == card == "19.32"


@pytest.mark.parametrize("language", ["en", "de", "es", "zh", "ru"])
def test_notes_of_every_language_are_in_the_unit(
    run: Runner, browser: Any, tmp_path: Path, language: str
) -> None:
    """Russian has letters of its own for m, and Chinese its own brackets."""
    options = ("--display-units", "ft", "--language", language)
    with opened(browser, levelled(run, tmp_path / "s", 10, 60, *options)) as page:
        said = page.text("#summary li")
        assert re.search(r"\b61\.\d ft", said), said
        assert re.search(r"9\.75 [m\u043c] ?[(\uff08]32 ft", said), said
    with opened(browser, levelled(run, tmp_path / "t", 16, 30, *options)) as page:
        page.page.locator("details.checks summary").first.click()
        notes = page.text("#summary td")
        assert "19.32 ft" in notes and ("1 start angle" in notes) == (language == "en"), notes


def test_another_unit_is_refused(run: Runner, tmp_path: Path) -> None:
    done = run(SAMPLE, "-o", tmp_path / "out", "--display-units", "cm")
    assert done.returncode == 2 and "display-units" in done.stderr
    assert not (tmp_path / "out").exists()
