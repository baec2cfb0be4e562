"""report.html in a browser: drawn, linked, kept from markup, printed, taken along."""

from __future__ import annotations

import json
import re
import shutil
import xml.etree.ElementTree as ElementTree
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from conftest import ROOT
from report_pages import (
    DATUM_BLUE,
    PHONE,
    Opened,
    browser,  # noqa: F401
    close_to,
    opened,
    pixels,
    with_data,
)
from results import Run, read_datum, read_points, read_stations, write_xyz
from test_compare import compare, epoch

Runner = Callable[..., Run]
Synth = Callable[..., Path]

SAMPLE = ROOT / "tests" / "data" / "sample.pcd"
CHARTS = (
    "elevation-chart",
    "out-of-plane-chart",
    "plan-chart",
    "section-chart",
    "corner-chart",
    "residuals-chart",
)
LINKED = ("elevation-chart", "out-of-plane-chart", "plan-chart")


@pytest.fixture(scope="session")
def sample(run: Runner, tmp_path_factory: pytest.TempPathFactory) -> Path:
    out = tmp_path_factory.mktemp("report") / "sample"
    assert run(SAMPLE, "-o", out).returncode == 0
    return out


@pytest.fixture(scope="session")
def gaps(run: Runner, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The sample without the points of 100 to 130 and 200 to 206 degrees."""
    folder = tmp_path_factory.mktemp("report")
    points = read_points(SAMPLE)
    azimuth = np.degrees(np.arctan2(points[:, 1], points[:, 0])) % 360.0
    seen = ~((azimuth > 100) & (azimuth < 130)) & ~((azimuth > 200) & (azimuth < 206))
    scan = write_xyz(folder / "gaps.pcd", points[seen])
    assert run(scan, "-o", folder / "gaps").returncode == 0
    return folder / "gaps"


@pytest.fixture(scope="session")
def no_tank(run: Runner, tmp_path_factory: pytest.TempPathFactory) -> Path:
    out = tmp_path_factory.mktemp("report") / "no_tank"
    assert run(SAMPLE, "-o", out, "--min-radius", 20).returncode == 1
    return out


@pytest.fixture
def page(browser: Any, sample: Path) -> Iterator[Opened]:  # noqa: F811
    with opened(browser, sample / "report.html") as shown:
        yield shown


@pytest.fixture(scope="module")
def still(browser: Any, sample: Path) -> Iterator[Opened]:  # noqa: F811
    """The same for tests that only look."""
    with opened(browser, sample / "report.html") as shown:
        yield shown


# ---- drawn ----


def test_opens_offline_and_says_nothing_wrong(page: Opened, sample: Path) -> None:
    html = (sample / "report.html").read_text()
    assert len(html) < 3_000_000
    assert page.page.title() == f"Datum of a storage tank: {SAMPLE}"
    assert [u for u in page.requests if not u.startswith(("file:", "data:", "blob:"))] == []
    assert page.errors == []
    assert "Redistribution and use in source and binary forms" in html  # the library's licence


def test_loads_quickly(browser: Any, sample: Path) -> None:  # noqa: F811
    times = []
    for _ in range(3):
        with opened(browser, sample / "report.html") as shown:
            times.append(shown.page.evaluate("performance.now()"))
    assert min(times) < 2000, times


@pytest.mark.parametrize("chart", CHARTS)
def test_every_chart_has_pixels(still: Opened, chart: str) -> None:
    image = still.picture(f"#{chart} svg")
    background = image[0, 0]
    drawn = np.abs(image.astype(int) - background).max(axis=2) > 40
    assert drawn.mean() > 0.005
    columns = drawn.any(axis=0)
    assert columns[: len(columns) // 2].any() and columns[len(columns) // 2 :].any()
    if chart in ("elevation-chart", "out-of-plane-chart"):
        assert close_to(image, DATUM_BLUE) > image.shape[1]  # a line all the way


def scale_of(page: Opened, chart: str, axis: int) -> tuple[float, float]:
    """value = a + b * pixel, from two ticks of an axis: 0 across, 1 upwards."""
    ticks = page.page.locator(f"#{chart} g.axis").nth(axis).locator("g.tick")
    found = []
    for tick in (ticks.first, ticks.last):
        place = [float(v) for v in re.findall(r"[-\d.]+", tick.get_attribute("transform"))]
        value = float(tick.text_content().replace("\u2212", "-").replace(",", ""))
        found.append((place[axis] - 0.5, value))  # D3 moves ticks to the middle of a pixel
    (p1, v1), (p2, v2) = found
    b = (v2 - v1) / (p2 - p1)
    return v1 - b * p1, b


def test_elevations_are_drawn_where_their_figures_say(page: Opened, sample: Path) -> None:
    """The marked point of each chosen station, read off by the axes' ticks."""
    stations, datum = read_stations(sample), read_datum(sample)
    for i in (0, 90, 251):
        page.page.locator("#station-number").fill(str(i))
        page.page.locator("#station-number").press("Enter")
        dot = page.page.locator("#elevation-chart circle.chosen")
        for axis, name, wanted in (
            (0, "cx", stations["azimuth_deg"][i]),
            (1, "cy", 1e3 * (stations["z"][i] - datum["datum"]["mean"])),
        ):
            a, b = scale_of(page, "elevation-chart", axis)
            got = a + b * float(dot.get_attribute(name))
            assert got == pytest.approx(wanted, abs=0.05), (i, name)


def test_facts_are_those_of_the_json(still: Opened, sample: Path) -> None:
    datum, facts = read_datum(sample), still.text("#summary .facts")
    assert f"{datum['tank']['radius']:.4f}\u00a0m" in facts
    assert f"{datum['tilt']['angle_arcsec']:.1f}" in facts
    assert f"{1e3 * datum['antipodal']['max_h']:.1f}\u00a0mm" in facts
    assert "360 stations measured, 0 interpolated, 0 missing" in still.text(".verdict")


# ---- linked ----


def test_hover_shows_the_station_and_marks_it_everywhere(page: Opened, sample: Path) -> None:
    svg = page.page.locator("#elevation-chart svg")
    a, b = scale_of(page, "elevation-chart", 0)
    svg.scroll_into_view_if_needed()
    page.hover("elevation-chart", (90 - a) / b, 150)
    stations = read_stations(sample)
    tip = page.text("#tip")
    assert "Station 90 at 90.0\u00b0, measured" in tip
    assert f"{stations['z'][90]:.4f}\u00a0m" in tip.replace("\u2212", "-")
    assert f"{1e3 * stations['u'][90]:.2f}\u00a0mm" in tip.replace("\u2212", "-")
    for chart in LINKED:
        mark = page.page.locator(f"#{chart} circle.hovered")
        assert mark.get_attribute("visibility") is None, chart
    a, b = scale_of(page, "out-of-plane-chart", 0)
    across = page.page.locator("#out-of-plane-chart line.hovered").get_attribute("x1")
    assert a + b * float(across) == pytest.approx(90, abs=0.01)
    page.page.mouse.move(2, 2)
    assert page.page.locator("#tip").is_hidden()
    assert page.page.locator("#plan-chart circle.hovered").get_attribute("visibility") == "hidden"


def test_slider_exaggerates_the_plan(page: Opened) -> None:
    def spread() -> float:
        path = page.page.locator("#plan-chart path.datum").get_attribute("d")
        points = np.array([float(v) for v in re.findall(r"-?[\d.]+", path)]).reshape(-1, 2)
        radii = np.hypot(*(points - points.mean(axis=0)).T)
        return float(np.ptp(radii))

    slider, shown = page.page.locator("#exaggeration"), page.page.locator("output")
    slider.fill("40")
    flat, said = spread(), float(shown.inner_text().lstrip("\u00d7 "))
    slider.fill("90")
    assert spread() > 5 * flat
    assert float(shown.inner_text().lstrip("\u00d7 ")) == pytest.approx(10 * said, rel=0.1)


def test_a_station_is_chosen_by_click_number_button_and_key(page: Opened, sample: Path) -> None:
    stations = read_stations(sample)

    def chosen() -> str:
        return page.texts("#station-values dd")[0]

    first = page.page.locator("#section-chart svg").inner_html()
    box = page.page.locator("#plan-chart svg").bounding_box()
    middle = min(box["width"], box["height"]) / 2
    page.click("plan-chart", box["width"] / 2 - 0.33 * 2 * middle, middle)  # west of the centre
    assert chosen() == "180 at 180.0\u00b0, measured"
    assert page.page.locator("#section-chart svg").inner_html() != first
    assert f"{stations['z'][180]:.4f}" in page.text("#spoken").replace("\u2212", "-")
    page.page.get_by_label("next station").click()
    assert chosen().startswith("181 ")
    page.page.locator("#station-number").fill("359")
    page.page.locator("#station-number").press("Enter")
    page.page.locator("#elevation-chart svg").press("ArrowRight")
    assert chosen().startswith("0 ")
    page.page.locator("#elevation-chart svg").press("Shift+ArrowLeft")
    assert chosen().startswith("350 ")
    assert page.page.locator("#station-number").input_value() == "350"
    assert page.errors == []


def test_series_can_be_left_out(page: Opened) -> None:
    assert page.page.locator("#elevation-chart path.reference").count() == 1
    page.page.get_by_label("paper\u2019s curve").uncheck()
    assert page.page.locator("#elevation-chart path.reference").count() == 0


def test_the_section_shows_the_fit(page: Opened, sample: Path) -> None:
    """The drawn intersection is at the station's elevation; its points lie on the two lines."""
    html = (sample / "report.html").read_text()
    found = re.search(r'id="data-sections">(.*?)</script>', html, re.S)
    assert found
    sections = json.loads(found[1])
    stations = read_stations(sample)
    assert len(sections["stations"]) == 360
    foundation, shell = [], []
    for i, s in enumerate(sections["stations"]):
        assert 10 <= len(s["d"]) == len(s["z"]) <= 90
        assert s["base"] + s["foundation"] == pytest.approx(stations["z"][i], abs=1e-5)
        d, z = (sections["step"] * np.array(s[k]) for k in ("d", "z"))
        band = (z < d) & (d > sections["band"][0]) & (d < sections["band"][1])
        foundation.extend(z[band] - s["foundation"] - s["slope"] * d[band])
        wall = z > d + 0.06
        shell.extend(d[wall] - s["lean"] * (z[wall] - s["foundation"]))
    for residuals, most in ((foundation, 0.001), (shell, 0.0015)):
        assert len(residuals) > 3000
        assert abs(np.median(residuals)) < 0.0002
        assert np.percentile(np.abs(residuals), 68) < most


# ---- what is missing ----


def test_gaps_are_shaded_and_named(browser: Any, gaps: Path) -> None:  # noqa: F811
    stations = read_stations(gaps)
    missing = np.flatnonzero(stations.where("missing"))
    assert 25 <= len(missing) <= 35 and stations.where("interpolated").sum() >= 5
    with opened(browser, gaps / "report.html") as page:
        assert page.errors == []
        assert "Datum found in part" in page.text(".verdict")
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
        assert page.errors == []


def test_no_tank(browser: Any, no_tank: Path) -> None:  # noqa: F811
    datum = read_datum(no_tank)
    with opened(browser, no_tank / "report.html") as page:
        assert page.errors == []
        assert "No tank found" in page.text(".verdict")
        assert datum["message"] in page.text(".verdict")
        assert page.page.locator("main svg").count() == 0
        for section in ("elevation", "out-of-plane", "plan", "station", "shell", "movement"):
            assert datum["message"] in page.text(f"#{section} .absent"), section
        assert datum["input"]["files"][0]["sha256"] in page.text("#provenance")


def test_paper_method(run: Runner, browser: Any, tmp_path: Path) -> None:  # noqa: F811
    assert run(SAMPLE, "-o", tmp_path, "--method", "paper", "--clockwise").returncode == 0
    with opened(browser, tmp_path / "report.html") as page:
        assert page.errors == []
        assert "fits a curve and no surfaces" in page.text("#station .absent")
        assert page.page.locator("#section-chart").count() == 0
        # azimuth 90 run clockwise is south of the centre
        box = page.page.locator("#plan-chart svg").bounding_box()
        across, down = box["width"] / 2, min(box["width"], box["height"]) / 2
        page.click("plan-chart", across, down + 0.66 * down)
        assert page.texts("#station-values dd")[0].startswith("90 at 90.0")


def test_no_report(run: Runner, sample: Path, tmp_path: Path) -> None:
    """Everything else stays the same, byte for byte."""
    result = run(SAMPLE, "-o", tmp_path, "--no-report")
    assert result.returncode == 0
    assert result.stdout.splitlines()[-1].split() == ["results", f"{tmp_path}/datum.json"]
    others = sorted(p.name for p in sample.iterdir() if p.name != "report.html")
    assert sorted(p.name for p in tmp_path.iterdir()) == others
    for name in others:
        assert (tmp_path / name).read_bytes() == (sample / name).read_bytes()


# ---- kept from markup ----


def test_names_are_never_markup(run: Runner, browser: Any, tmp_path: Path) -> None:  # noqa: F811
    folder = tmp_path / '"><img src=x onerror=hacked=1><'
    folder.mkdir()
    scan = folder / "script>'`&amp;\u2028<script>hacked=2<!--.pcd"
    shutil.copy(SAMPLE, scan)
    assert run(scan, "-o", tmp_path / "out").returncode == 0
    with opened(browser, tmp_path / "out" / "report.html") as page:
        assert page.errors == []
        assert page.page.evaluate("typeof hacked") == "undefined"
        assert page.page.locator("img").count() == 0
        assert page.page.locator("#scans").text_content() == str(scan)
        assert page.page.locator("main svg").count() >= len(CHARTS)
        saved = page.downloaded(page.page.get_by_role("button", name="datum.json", exact=True))
        assert json.loads(saved) == read_datum(tmp_path / "out")


# ---- taken along ----


def test_downloads(page: Opened, sample: Path) -> None:
    def saved(name: str) -> bytes:
        return page.downloaded(page.page.get_by_role("button", name=name, exact=True))

    assert json.loads(saved("datum.json")) == read_datum(sample)
    assert saved("stations.csv") == (sample / "stations.csv").read_bytes()
    for chart in ("elevation-chart", "plan-chart"):
        svg = saved(f"{chart} as SVG")
        root = ElementTree.fromstring(svg)
        assert root.tag == "{http://www.w3.org/2000/svg}svg"
        assert b"var(--" not in svg and b"rgb(7, 87, 181)" in svg  # stands without the page
        image = pixels(saved(f"{chart} as PNG"))
        assert image.shape[1] == 2 * float(root.get("width"))
        assert (np.abs(image.astype(int) - image[0, 0]).max(axis=2) > 60).mean() > 0.005
        assert chart == "plan-chart" or close_to(image, DATUM_BLUE) > 1000
    assert page.errors == []


def test_prints_on_a4(page: Opened, tmp_path: Path) -> None:
    pdf = page.page.pdf(prefer_css_page_size=True, path=tmp_path / "report.pdf")
    assert pdf.startswith(b"%PDF")
    boxes = {
        tuple(round(float(v)) for v in m.split()) for m in re.findall(rb"/MediaBox \[(.*?)\]", pdf)
    }
    assert boxes <= {(0, 0, 595, 842), (0, 0, 596, 842)} and boxes
    assert 4 <= pdf.count(b"/Type /Page\n") + pdf.count(b"/Type /Page ") <= 10
    page.page.emulate_media(media="print", color_scheme="dark")
    assert page.page.locator("#exaggeration").is_hidden()
    assert page.page.locator("nav").is_hidden()
    assert (
        page.page.evaluate("getComputedStyle(document.body).backgroundColor")
        == "rgb(255, 255, 255)"
    )
    breaks = page.page.evaluate(
        "[...document.querySelectorAll('main > section')].map(s => getComputedStyle(s).breakBefore)"
    )
    assert breaks[1:4] == ["page"] * 3


# ---- read by anybody ----


def contrast(page: Opened, selector: str) -> float:
    """The ratio of luminances of an element's text and the page (WCAG 2)."""
    colours = page.page.evaluate(
        """s => [getComputedStyle(document.querySelector(s)).color,
                 getComputedStyle(document.body).backgroundColor]""",
        selector,
    )
    levels = []
    for colour in colours:
        c = np.array([float(v) / 255 for v in re.findall(r"[\d.]+", colour)[:3]])
        c = np.where(c <= 0.03928, c / 12.92, ((c + 0.055) / 1.055) ** 2.4)
        levels.append(float(c @ [0.2126, 0.7152, 0.0722]))
    return (max(levels) + 0.05) / (min(levels) + 0.05)


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_contrast(browser: Any, sample: Path, scheme: str) -> None:  # noqa: F811
    with opened(browser, sample / "report.html", scheme=scheme) as page:
        for selector in ("p", ".quiet", "nav a", ".absent"):
            assert contrast(page, selector) > 4.5, selector
        dark = pixels(page.page.screenshot())[5, 5].mean() < 64
        assert dark == (scheme == "dark")


def test_on_a_phone(browser: Any, sample: Path) -> None:  # noqa: F811
    with opened(browser, sample / "report.html", size=PHONE) as page:
        assert page.page.evaluate("document.documentElement.scrollWidth") <= PHONE[0]
        for chart in CHARTS:
            box = page.page.locator(f"#{chart} svg").bounding_box()
            assert 300 < box["width"] <= PHONE[0]
        sizes = page.page.evaluate(
            "[...document.querySelectorAll('svg text')].map(t => t.getBoundingClientRect().height)"
        )
        assert min(sizes) >= 11
        assert page.errors == []


def test_structure_for_listeners(still: Opened) -> None:
    page = still
    assert page.page.locator("h1").count() == 1
    for svg in page.page.locator("main svg").all():
        assert len(svg.get_attribute("aria-label")) > 20
    unnamed = page.page.evaluate(
        """[...document.querySelectorAll('button, input')].filter(e =>
             !e.textContent.trim() && !e.ariaLabel && !(e.labels && e.labels.length)).length"""
    )
    assert unnamed == 0
    assert page.page.locator("#spoken").get_attribute("aria-live") == "polite"


# ---- sections that other stages fill ----

CHECKS = [
    {"code": "GB 50473", "clause": "", "name": "planar tilt", "value": 0.02, "limit": 0.035}
    | {"unit": "m", "verdict": "pass", "source": "secondary", "note": "floating roof"},
    {"code": "API 653", "clause": "B.3", "name": "<b>out-of-plane</b>", "value": 0.031}
    | {"limit": 0.02, "unit": "m", "verdict": "fail", "source": "verified", "note": ""},
]
SHELL = {
    "roundness": [
        {"height": h, "radius": 5.0, "max_deviation": 0.004, "min_deviation": -0.003}
        | {"azimuth_deg": 40.0, "sigma": 0.0003, "n": 900, "tolerance": 0.013, "verdict": "pass"}
        for h in (0.3, 1.5)
    ],
    "plumbness": [
        {"azimuth_deg": 10.0 * i, "height": 3.0, "offset": 0.002 * (i % 5), "sigma": 0.0004}
        for i in range(36)
    ],
    "plumbness_max": 0.008,
    "plumbness_azimuth_deg": 40.0,
}
MOVEMENT = {
    "baseline": "2024 <survey>",
    "removed": "none",
    "registration_error": 0.0005,
    "azimuth_offset_deg": 0.0,
    "max": 0.004,
    "rms": 0.002,
    "stations": [
        {"azimuth_deg": float(i), "dz": 0.004 * (i % 90) / 90, "lod95": 0.002}
        | {"significant": i % 90 > 45}
        for i in range(360)
    ],
}
HARMONICS = [
    {"n": n, "amplitude": 0.005 / (n + 1), "phase_deg": 30.0, "sigma": 1e-4} for n in range(5)
]


def test_sections_of_a_whole_result(browser: Any, sample: Path, tmp_path: Path) -> None:  # noqa: F811
    more = {"checks": CHECKS, "shell": SHELL, "movement": MOVEMENT, "harmonics": HARMONICS}
    more["notes"] = ["A screening, not an <i>evaluation</i>."]
    path = with_data(sample / "report.html", tmp_path / "whole.html", more)
    with opened(browser, path) as page:
        assert page.errors == []
        verdict = page.text(".verdict")
        assert "1 of 2 judged checks pass; 1 fail: <b>out-of-plane</b> (API 653)" in verdict
        assert "fail" in page.page.locator(".verdict").get_attribute("class")
        assert "A screening, not an <i>evaluation</i>." in page.text("#summary li")
        assert page.page.locator("#shell .absent, #movement .absent").count() == 0
        assert page.text("#shell table").count("pass") == 2
        assert "2024 <survey>" in page.text("#movement")
        assert page.page.locator("#movement-chart circle.significant").count() == 4 * 44
        assert page.page.locator("#harmonics-chart rect.bar").count() == 4
        for chart in ("plumbness-chart", "movement-chart", "harmonics-chart"):
            image = page.picture(f"#{chart} svg")
            assert (np.abs(image.astype(int) - 255).max(axis=2) > 60).mean() > 0.005, chart
        page.hover("movement-chart", 300, 100)
        assert "detectable from 2.00\u00a0mm" in page.text("#tip")


def test_shell_of_a_scan(
    run: Runner,
    synth: Synth,
    browser: Any,  # noqa: F811
    tmp_path: Path,
) -> None:
    """Map, curves and tables of the shell at three heights, held to shell.csv and datum.json."""
    assert (
        run(
            synth(out_of_round="2:0.01:0", near_datum=4, step_deg=0.3), "-o", tmp_path / "out"
        ).returncode
        == 0
    )
    shell = read_datum(tmp_path / "out")["shell"]
    table = np.genfromtxt(tmp_path / "out" / "shell.csv", delimiter=",", names=True)
    heights = np.unique(table["height"])
    assert len(heights) == 3
    with opened(browser, tmp_path / "out" / "report.html") as page:
        assert page.errors == []
        assert page.page.locator("#shell-map image").count() == len(heights)
        assert page.page.locator("#roundness-chart path.height").count() == len(heights)
        assert page.page.locator("#shell tbody tr").count() == len(shell["roundness"])
        worst = max(shell["roundness"], key=lambda r: r["max_deviation"])
        assert f"{1e3 * worst['max_deviation']:.1f}\u00a0mm" in page.text("#shell tbody")
        (ax, bx), (ay, by) = (scale_of(page, "shell-map", axis) for axis in (0, 1))
        image = page.picture("#shell-map svg").astype(int)
        for azimuth in (0.0, 90.0):  # outwards red, inwards blue
            cell = table[(table["azimuth_deg"] == azimuth) & (table["height"] == heights[1])][0]
            assert abs(cell["deviation"]) > 0.005
            x, y = (azimuth + 3.0 - ax) / bx, (heights[1] - ay) / by
            red, _, blue = image[round(y), round(x)]
            assert (red > blue + 40) == (cell["deviation"] > 0) and abs(red - blue) > 40
            page.hover("shell-map", (azimuth - ax) / bx, y)
            tip = page.text("#tip").replace("\u2212", "-")
            assert f"Shell at {azimuth:.1f}\u00b0, {heights[1]:.2f}\u00a0m above the datum" in tip
            assert f"{1e3 * cell['deviation']:.1f}\u00a0mm" in tip
        page.hover("plumbness-chart", 300, 100)
        assert "Offset" in page.text("#tip") and "over 2.00\u00a0m" in page.text("#tip")


def test_movement_since_a_baseline(
    run: Runner,
    browser: Any,  # noqa: F811
    sample: Path,
    tmp_path: Path,
) -> None:
    """Two scans of one tank, the second sunk by 3 mm between 80 and 140 degrees."""
    points = read_points(SAMPLE)
    azimuth = np.degrees(np.arctan2(points[:, 1], points[:, 0])) % 360.0
    points[(azimuth > 80) & (azimuth < 140), 2] -= 0.003
    scan = write_xyz(tmp_path / "later.pcd", points)
    assert run(scan, "-o", tmp_path / "out", "--baseline", sample).returncode == 0
    movement = read_datum(tmp_path / "out")["movement"]
    with opened(browser, tmp_path / "out" / "report.html") as page:
        assert page.errors == []
        assert "3.0" in page.text("#movement p").replace("2.9", "3.0")
        a, b = scale_of(page, "movement-chart", 0)
        page.hover("movement-chart", (110 - a) / b, 120)
        dz = 1e3 * movement["stations"][110]["dz"]
        assert f"\u2212{-dz:.2f}\u00a0mm" in page.text("#tip")
        assert "significant" in page.text("#tip")
        significant = sum(s["significant"] for s in movement["stations"])
        assert page.page.locator("#movement-chart circle.significant").count() == significant > 40


def test_trend_over_surveys(browser: Any, tmp_path: Path) -> None:  # noqa: F811
    surveys = [epoch(tmp_path / f"{'<b>' * i}{i}.json", 0.002 * i) for i in range(4)]
    assert compare(*surveys, "-o", tmp_path / "m").returncode == 0
    with opened(browser, tmp_path / "m" / "report.html") as page:
        assert page.errors == []
        assert page.page.locator("main b").count() == 0
        assert page.page.locator("#trend tbody tr").count() == 3
        assert "\u22126.00\u00a0mm" in page.text("#trend tbody")
        assert page.page.locator("#trend-chart path.survey").count() == 3
        a, b = scale_of(page, "trend-chart", 0)
        page.click("trend-chart", (100 - a) / b, 120)
        assert "Movement at 100.0\u00b0" in page.page.locator("#course-chart").text_content()
        heights = [
            float(c.get_attribute("cy")) for c in page.page.locator("#course-chart circle").all()
        ]
        assert np.allclose(np.diff(heights), np.diff(heights)[0]) and np.diff(heights)[0] > 20
        saved = page.downloaded(page.page.get_by_role("button", name="movement.json", exact=True))
        assert json.loads(saved) == json.loads((tmp_path / "m" / "movement.json").read_text())


def test_without_them_each_says_why(
    browser: Any,  # noqa: F811
    sample: Path,
    tmp_path: Path,
) -> None:
    none = {"shell": None, "movement": None, "checks": None, "notes": None, "harmonics": None}
    path = with_data(sample / "report.html", tmp_path / "bare.html", none)
    with opened(browser, path) as page:
        assert page.errors == []
        assert "--baseline" in page.text("#movement .absent")
        assert "too little of the shell" in page.text("#shell .absent")
        assert "Checks" in page.text("#summary .absent")
