"""What the user says of the tank: the file of option about, marks, north and survey points."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from report_pages import SAMPLE, opened, with_data
from results import Run, read_datum, read_stations
from test_compare import compare

Runner = Callable[..., Run]

ABOUT = """tank = "T-12 <b>"
client = "Example & Co"
survey_date = 2026-11-03
revision = 2
logo = "logo.svg"
"""
GIVEN = ("--mark", "stairs=75,manhole=-10", "--north-deg", 60, "--survey-points", 8)


@pytest.fixture(scope="module")
def told(run: Runner, tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("identity")
    (folder / "about.toml").write_text(ABOUT)
    (folder / "logo.svg").write_text("<svg xmlns='http://www.w3.org/2000/svg'></svg>")
    done = run(SAMPLE, "-o", folder / "out", "--about", folder / "about.toml", *GIVEN)
    assert done.returncode == 0, done.stderr
    return folder / "out"


def test_words_marks_and_north_are_in_the_result(told: Path) -> None:
    datum = read_datum(told)
    assert datum["about"] == {
        "tank": "T-12 <b>",
        "client": "Example & Co",
        "survey_date": "2026-11-03",
        "revision": "2",
    }
    assert [(m["name"], m["azimuth_deg"]) for m in datum["marks"]] == [
        ("stairs", pytest.approx(75.0)),
        ("manhole", pytest.approx(350.0)),
    ]
    assert datum["north_azimuth_deg"] == pytest.approx(60.0)


@pytest.mark.parametrize("language", ["en", "de", "es", "zh", "ru"])
def test_survey_points_take_a_line_each_on_a_phone(
    browser: Any, told: Path, tmp_path: Path, language: str
) -> None:
    path = with_data(told / "report.html", tmp_path / "page.html", {"language": language})
    with opened(browser, path, size=(360, 800)) as page:
        table = page.page.locator(".survey-points .scroll")
        assert table.evaluate("e => e.scrollWidth <= e.clientWidth")
        rows = [row.bounding_box()["height"] for row in table.locator("tbody tr").all()]
        assert len(rows) == 8 and max(rows) < 45


def test_survey_points_run_clockwise_from_north(told: Path) -> None:
    stations, points = read_stations(told), read_datum(told)["survey_points"]
    assert [p["number"] for p in points] == list(range(1, 9))
    azimuths = [p["azimuth_deg"] for p in points]
    assert azimuths == pytest.approx([60, 15, 330, 285, 240, 195, 150, 105])
    expected = np.interp(azimuths, stations["azimuth_deg"], stations["z"], period=360)
    assert [p["z"] for p in points] == pytest.approx(expected.tolist(), abs=1e-9)


def test_stations_that_run_clockwise_from_north_have_the_points_numbers(
    run: Runner, tmp_path: Path
) -> None:
    options = ("--zero-azimuth-deg", 60, "--clockwise", "--north-deg", 60, "--survey-points", 36)
    assert run(SAMPLE, "-o", tmp_path / "out", *options, "--stations", 36).returncode == 0
    stations, points = (
        read_stations(tmp_path / "out"),
        read_datum(tmp_path / "out")["survey_points"],
    )
    assert [p["azimuth_deg"] for p in points] == pytest.approx(stations["azimuth_deg"].tolist())
    assert [p["z"] for p in points] == pytest.approx(stations["z"].tolist(), abs=1e-12)


def test_the_page_shows_them(browser: Any, told: Path) -> None:
    with opened(browser, told / "report.html") as page:
        assert page.text("#title") == "Datum of tank T-12 <b>"
        assert "Example & Co" in page.text(".about")
        assert page.page.locator(".identity img").get_attribute("src").startswith("data:image/svg")
        assert "stairs" in page.page.locator("#plan-chart svg text").all_text_contents()
        assert page.page.locator("#elevation-chart .reference-mark").count() == 2
        assert page.page.locator("#elevation table tbody tr").count() == 8
        assert page.errors == []


@pytest.mark.parametrize(
    ("content", "words"),
    [
        pytest.param('tnak = "x"', ["about.toml:1", "key tnak", "one of tank,"], id="other key"),
        pytest.param(
            'tank = "x"\nsurvey_date = "2023-02-29"',
            ["about.toml:2", "survey_date: 2023-02-29", "a day that there is"],
            id="no such day",
        ),
        pytest.param("tank = \n", ["about.toml:1", "TOML"], id="no TOML"),
        pytest.param('tank = "a\u202eb"', ["about.toml:1", "direction"], id="bidi override"),
        pytest.param('tank = "a\\u2066b"', ["about.toml:1", "direction"], id="bidi isolate"),
        pytest.param("tank = [1]", ["about.toml:1", "tank", "a text"], id="a list"),
        pytest.param('logo = "none.png"', ["none.png"], id="no such logo"),
        pytest.param('logo = "about.toml"', ["about.toml", "no image", "PNG"], id="no image"),
        pytest.param("x" * (1 << 20) + "x", ["1048577 bytes", "1 MB"], id="too large"),
    ],
)
def test_a_bad_file_is_refused_in_a_line(
    run: Runner, tmp_path: Path, content: str, words: list[str]
) -> None:
    (tmp_path / "about.toml").write_text(content)
    done = run(SAMPLE, "-o", tmp_path / "out", "--about", tmp_path / "about.toml")
    assert done.returncode == 3
    assert len(done.stderr.strip().splitlines()) == 1
    for word in words:
        assert word in done.stderr
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize(
    "mark", ["stairs", "=75", "stairs=x", "stairs=75x", "stairs=400", "a\u202e=7"]
)
def test_a_bad_mark_is_refused(run: Runner, tmp_path: Path, mark: str) -> None:
    done = run(SAMPLE, "-o", tmp_path / "out", "--mark", mark)
    assert done.returncode == 2
    assert "mark" in done.stderr
    assert "stairs=75" in done.stderr


def test_a_mark_given_twice_is_refused(run: Runner, tmp_path: Path) -> None:
    done = run(SAMPLE, "-o", tmp_path / "out", "--mark", "stairs=75,stairs=80")
    assert done.returncode == 2
    assert '"stairs=80", expected each name once' in done.stderr


def test_the_page_of_several_surveys_says_the_same(
    browser: Any, told: Path, tmp_path: Path
) -> None:
    """Heading, logo and marks, as in the report of one survey."""
    about = told.parent / "about.toml"
    done = compare(told, told, "-o", tmp_path / "m", "--about", about, *GIVEN[:2])
    assert done.returncode == 0, done.stderr
    with opened(browser, tmp_path / "m/report.html") as page:
        assert page.text("h1") == "Movement of the datum of tank T-12 <b>"
        assert "Example & Co" in page.text(".identity")
        assert page.page.locator(".identity img").get_attribute("src").startswith("data:image/svg")
        for chart in ("trend-chart", "trend-plan", "rate-chart"):
            assert "stairs" in page.page.locator(f"#{chart}").text_content(), chart


def test_surveys_with_dates_have_those_and_no_other(
    browser: Any, told: Path, tmp_path: Path
) -> None:
    """The file's date is of one survey; the page is of several."""
    (tmp_path / "about.toml").write_text('tank = "T-12"\nsurvey_date = 2019-01-02\n')
    dated = ("--about", tmp_path / "about.toml", "--dates", "2020-03-04,2024-05-06")
    for name, options, shown in (("bare", dated[:2], True), ("dated", dated, False)):
        done = compare(told, told, "-o", tmp_path / name, *options)
        assert done.returncode == 0, done.stderr
        with opened(browser, tmp_path / name / "report.html") as page:
            assert ("2019-01-02" in page.text(".about")) == shown
            style = " ".join(page.page.locator("head style").all_text_contents())
            assert ("2024-05-06" in style) != shown and ("2019-01-02" in style) == shown


# texts of a chart that stand outside it, or that lie over each other's lines
CUT = """chart => { const frame = chart.getBoundingClientRect(), out = [];
  const names = [...chart.querySelectorAll('text')].filter(t => t.textContent.startsWith('the '));
  const boxes = names.map(t => t.getBoundingClientRect());
  boxes.forEach((a, i) => {
    if (a.left < frame.left - 1 || a.right > frame.right + 1) out.push(names[i].textContent);
    boxes.slice(i + 1).forEach((b, j) => {
      const over = Math.min(a.right, b.right) - Math.max(a.left, b.left);
      if (over > 1 && Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top) > 6)
        out.push([names[i].textContent, names[i + 1 + j].textContent]);
    });
  });
  return out; }"""


@pytest.mark.parametrize("width", [360, 1200])
def test_marks_that_are_long_or_many_stay_readable(
    browser: Any, told: Path, tmp_path: Path, width: int
) -> None:
    """Names are cut or left out where there is no room for them; the heading has them all."""
    name = "the stairs beside the manhole on the side of the harbour"
    many = [{"name": f"the nozzle {i}", "azimuth_deg": 11.0 * i} for i in range(32)]
    for marks in ([{"name": name, "azimuth_deg": 75.5}], many):
        path = with_data(told / "report.html", tmp_path / "page.html", {"marks": marks})
        with opened(browser, path, size=(width, 900)) as page:
            assert page.slips() == []
            for chart in ("elevation", "out-of-plane", "plan"):
                svg = page.page.locator(f"#{chart}-chart svg").first
                assert svg.evaluate(CUT) == [], chart
                assert svg.locator("line.reference-mark").count() == len(marks)
            said = page.text(".about")
            for mark in marks:
                assert f"{mark['name']}: {mark['azimuth_deg']:g}\u00b0" in said


def test_a_bad_file_about_the_tank_is_refused_of_surveys_too(told: Path, tmp_path: Path) -> None:
    (tmp_path / "about.toml").write_text("owner = 'x'\n")
    done = compare(told, told, "-o", tmp_path / "m", "--about", tmp_path / "about.toml")
    assert done.returncode == 3
    assert "about.toml:1, key owner" in done.stderr
    assert not (tmp_path / "m").exists()
