"""Words of the page can be read: on narrow pages, between neighbours, without scripts."""

from __future__ import annotations

import itertools
from pathlib import Path
from typing import Any

import pytest

from report_fixtures import Runner
from report_pages import SAMPLE, opened

MARKS = ("stairs=75", "manhole A=76", "nozzle N1=77.5", "earthing=80", "drain=250")
COUNTED = ("--clockwise", "--zero-azimuth-deg", "90", "--mark", ",".join(MARKS))

BEYOND = """() => [...document.querySelectorAll('.canvas svg text')].filter(t => {
  const box = t.getBoundingClientRect(), chart = t.ownerSVGElement.getBoundingClientRect();
  return box.left < chart.left - 1 || box.right > chart.right + 1;
}).map(t => t.textContent)"""

MARKED = """(chart) => [...document.querySelectorAll(`#${chart} svg text`)]
  .filter(t => %s.includes(t.textContent))
  .map(t => { const b = t.getBBox(); return [b.x, b.y, b.width, b.height]; })"""


@pytest.fixture(scope="module", params=["en", "de", "es", "ru", "zh"])
def counted_report(request: Any, run: Runner, tmp_path_factory: pytest.TempPathFactory) -> Path:
    out = tmp_path_factory.mktemp("fits") / "out"
    assert run(SAMPLE, "-o", out, *COUNTED, "--language", request.param).returncode == 0
    return out / "report.html"


@pytest.mark.parametrize("width", [360, 700, 1200])
def test_no_text_of_a_chart_is_cut(browser: Any, counted_report: Path, width: int) -> None:
    with opened(browser, counted_report, (width, 800)) as shown:
        assert shown.page.evaluate(BEYOND) == []


@pytest.mark.parametrize("chart", ["elevation-chart", "plan-chart"])
def test_names_of_close_marks_do_not_cover_each_other(
    browser: Any, counted_report: Path, chart: str
) -> None:
    names = [mark.split("=")[0] for mark in MARKS]
    with opened(browser, counted_report) as shown:
        boxes = shown.page.evaluate(MARKED % names, chart)
    assert len(boxes) == len(names)
    for (x, y, wide, tall), (u, v, broad, high) in itertools.combinations(boxes, 2):
        apart = x + wide <= u or u + broad <= x or y + 0.8 * tall <= v or v + 0.8 * high <= y
        assert apart, (names, boxes)


def test_without_scripts_the_summary_is_read(browser: Any, run: Runner, tmp_path: Path) -> None:
    done = run(SAMPLE, "-o", tmp_path / "out")
    context = browser.new_context(java_script_enabled=False)
    page = context.new_page()
    page.goto((tmp_path / "out" / "report.html").as_uri())
    seen = page.locator("noscript pre").inner_text().splitlines()
    context.close()
    said = [line for line in done.stdout.splitlines() if "option" not in line]
    assert any(line.startswith("verdict ") for line in seen)
    assert {line.split()[0] for line in seen} >= {"status", "tank", "datum", "tilt"}
    assert [line for line in seen if "option" not in line] == [
        line for line in said if line in seen
    ]


def test_notes_have_the_unit_shown(browser: Any, run: Runner, tmp_path: Path) -> None:
    assert run(SAMPLE, "-o", tmp_path / "out", "--display-units", "ft").returncode == 0
    with opened(browser, tmp_path / "out" / "report.html") as shown:
        for closed in shown.page.locator("details.checks summary").all():
            closed.click()
        cells = shown.texts("details.checks td, .notes li, #summary li")
        turned = shown.page.evaluate(
            "inShownUnits('a gap of 30.5 m, 9.75 m (32 ft), 5 mm and m/m')"
        )
    assert turned == "a gap of 100.1 ft, 9.75 m (32 ft), 0.016 ft and m/m"
    assert any(" ft apart" in cell for cell in cells)
    assert not any(" m apart" in cell for cell in cells)


def test_bars_say_value_and_limit(browser: Any, sample_report: Path) -> None:
    """They are what paper has of the checks that pass: their table is folded there."""
    with opened(browser, sample_report / "report.html") as shown:
        bars = shown.texts(".bars li span:first-child")
    assert bars
    assert all(" of " in bar.split(": ")[-1] for bar in bars), bars
