"""The first screen of the report has its figures from datum.json; axe finds nothing wrong."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from report_fixtures import JUDGED
from report_pages import PHONE, SAMPLE, WIDE, Opened, opened, plain, with_data
from results import Run, read_datum, read_points, read_stations, write_xyz
from test_compare import compare
from test_report_paper import ABOUT, TOLD
from test_report_picture import written

Runner = Callable[..., Run]
FIGURE = re.compile(r"\d+(?:\.\d+)?")


@pytest.fixture(scope="module")
def failing_report(run: Runner, sample_report: Path, tmp_path_factory: Any) -> Path:
    """A bent foundation, with movement since the sample's and all that is told of the tank."""
    folder = tmp_path_factory.mktemp("verdict")
    (folder / "about.toml").write_text(ABOUT)
    points = read_points(SAMPLE)
    points[:, 2] += 0.03 * np.cos(4 * np.arctan2(points[:, 1], points[:, 0]))
    scan = write_xyz(folder / "bent.pcd", points)
    told = ("--about", folder / "about.toml", *TOLD, "--baseline", sample_report)
    assert run(scan, "-o", folder / "out", *JUDGED, *told).returncode == 0
    return folder / "out"


@pytest.fixture(scope="module", params=["good", "failing", "gaps"])
def judged(request: pytest.FixtureRequest) -> Path:
    name = {"good": "sample_report", "failing": "failing_report", "gaps": "gaps_report"}
    folder: Path = request.getfixturevalue(name[request.param])
    return folder


def traced(folder: Path) -> set[str]:
    """Every figure of datum.json that the first screen may show, as it shows it."""
    datum, stations = read_datum(folder), read_stations(folder)
    level, verdict = datum["datum"], datum["verdict"]
    listed = [c["verdict"] for c in datum["checks"]]
    judged = [v for v in listed if v in ("pass", "fail", "undecided")]
    found = [str(listed.count(v)) for v in set(listed)] + [str(len(judged)), "0"]
    found += [str(level[key]) for key in ("measured", "interpolated", "missing")]
    found += [str(len(stations["z"]))]
    if verdict["utilisation"] is not None:
        found.append(f"{100 * verdict['utilisation']:.0f}")
    sigmas = stations["sigma_z"][stations.where("measured")]
    found.append(f"{1e3 * np.median(sigmas):.2f}")
    movement = datum.get("movement")
    if movement:
        found += [str(movement["matched"]), str(movement["significant"])]
        found.append(f"{movement['errors']['used']:.1f}")
        for part in ("mean", "out_of_plane"):
            value, sigma = movement[part]["value"], movement[part]["sigma"]
            found += [f"{1e3 * abs(value):.2f}", f"{2e3 * sigma:.2f}"]
        tilt = movement["tilt_change"]
        found += [f"{tilt['angle_arcsec']:.1f}"]
        found += [f"{np.degrees(np.arctan(2 * tilt['sigma'])) * 3600:.1f}"]
        places = (tilt["azimuth_deg"], movement["out_of_plane"]["azimuth_deg"])
        found += [str(int(np.floor(place + 0.5)) % 360) for place in places]
    words = [datum["message"], verdict["sentence"], verdict["governing"]]
    words += [c["code"] + c["name"] for c in datum["checks"]]
    for said in words:
        found += FIGURE.findall(said)
    return {*found, "2"}  # of 2 sigma


def test_every_figure_of_the_verdict_is_in_datum_json(browser: Any, judged: Path) -> None:
    with opened(browser, judged / "report.html") as page:
        said = page.texts("#summary .verdict, #summary .quality")
        assert len(said) >= 2
        known = traced(judged)
        figures = [f for text in said for f in FIGURE.findall(text)]
        assert len(figures) >= 5
        assert [f for f in figures if f not in known] == [], said


def test_the_word_is_the_json_word(browser: Any, judged: Path) -> None:
    verdict = read_datum(judged)["verdict"]
    with opened(browser, judged / "report.html") as page:
        assert page.text(".verdict .word").split()[-1] == verdict["word"]
        first = page.texts(".verdict p")[1]
        assert plain(first) == verdict["sentence"]


def test_every_bar_is_the_share_of_a_limit(browser: Any, judged: Path) -> None:
    shares, figures = {}, {}
    for check in read_datum(judged)["checks"]:
        if check["verdict"] in ("pass", "fail", "undecided") and check["limit"]:
            name = check["name"][0].upper() + check["name"][1:]
            share = abs(check["value"]) / check["limit"]
            shares[f"{name}, {check['code']}"] = int(np.floor(100 * share + 0.5))
            figures[f"{name}, {check['code']}"] = [check["value"], check["limit"]]
    with opened(browser, judged / "report.html") as page:
        bars = page.page.locator(".bars li").all()
        shown = [[span.inner_text() for span in bar.locator("> span").all()] for bar in bars]
    named = [(*said.split(": "), share) for said, _, share in shown]
    assert {name: int(share.split()[0]) for name, _, share in named} == shares
    for name, said, _ in named:
        value, limit, unit = re.fullmatch(r"(\S+) of (\S+)\u00a0(.+)", said).groups()
        assert [float(value), float(limit)] == pytest.approx(
            [SHOWN_IN[unit] * figure for figure in figures[name]], abs=0.06
        ), said


SHOWN_IN = {"m": 1.0, "mm": 1e3, "mm/m": 1e3, "\u00d7 10\u207b\u2076 1/m": 1e6}


@pytest.mark.parametrize("size", [WIDE, PHONE], ids=["desktop", "phone"])
def test_bars_are_as_long_as_their_shares(
    browser: Any, sample_report: Path, size: tuple[int, int]
) -> None:
    with opened(browser, sample_report / "report.html", size=size) as page:
        for bar in page.page.locator(".bars li").all():
            share = float(bar.locator(".number").inner_text().split()[0])
            track, fill = (bar.locator(part).bounding_box() for part in (".track", "i"))
            assert track["width"] > 100
            assert fill["width"] / track["width"] == pytest.approx(share / 100, abs=0.03)


@pytest.fixture(scope="module")
def index_page(run: Runner, tmp_path_factory: Any) -> Path:
    """The index of two tanks."""
    folder = tmp_path_factory.mktemp("index")
    points = read_points(SAMPLE)
    scan = write_xyz(folder / "two.pcd", np.vstack([points, points + (20.0, 0.0, 1.0)]))
    assert run(scan, "-o", folder / "out", "--all", *JUDGED).returncode == 0
    return folder / "out" / "index.html"


@pytest.fixture(scope="module")
def trend_page(sample_report: Path, failing_report: Path, tmp_path_factory: Any) -> Path:
    out: Path = tmp_path_factory.mktemp("trend") / "out"
    dated = ("--dates", "2020-01-01,2024-01-01", *TOLD[:2])
    dated += ("--about", failing_report.parent / "about.toml")
    assert compare(sample_report, failing_report, "-o", out, *dated).returncode == 0
    return out / "report.html"


@pytest.fixture(scope="module")
def pictured_page(failing_report: Path, tmp_path_factory: Any) -> Path:
    """In German, with a picture of the tank."""
    from matplotlib.image import imsave

    folder: Path = tmp_path_factory.mktemp("pictured")
    imsave(folder / "view.png", np.zeros((80, 128, 3)))
    german = {"language": "de"}
    with_data(failing_report / "report.html", folder / "report.html", german)
    done = written(folder, folder / "pictured.html", "--picture", folder / "view.png")
    assert done.returncode == 0
    return folder / "pictured.html"


def checked(page: Opened) -> Any:
    axe = pytest.importorskip("axe_playwright_python.sync_playwright").Axe()
    return axe.run(page.page)


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("size", [WIDE, PHONE], ids=["desktop", "phone"])
@pytest.mark.parametrize(
    "name",
    [
        "sample_report",
        "failing_report",
        "pictured_page",
        "no_tank_report",
        "index_page",
        "trend_page",
    ],
)
def test_axe_finds_nothing(
    browser: Any, request: pytest.FixtureRequest, name: str, size: tuple[int, int], scheme: str
) -> None:
    page = request.getfixturevalue(name)
    page = page if page.suffix == ".html" else page / "report.html"
    with opened(browser, page, size=size, scheme=scheme) as shown:
        for folded in shown.page.locator("details.checks summary").all():
            folded.click()
        found = checked(shown)
        assert found.violations_count == 0, found.generate_report()
