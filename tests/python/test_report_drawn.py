"""report.html in a browser: opened from disk, every chart drawn, its figures those of the files."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from report_pages import CHARTS, DATUM_BLUE, SAMPLE, Opened, close_to, opened, scale_of
from results import read_datum, read_stations


def test_opens_offline_and_says_nothing_wrong(page: Opened, sample_report: Path) -> None:
    html = (sample_report / "report.html").read_text()
    assert len(html) < 3_000_000
    assert page.page.title() == f"Datum of a storage tank: {SAMPLE}"
    assert [u for u in page.requests if not u.startswith(("file:", "data:", "blob:"))] == []
    assert page.slips() == []
    assert "Redistribution and use in source and binary forms" in html  # the library's licence


def test_loads_quickly(browser: Any, sample_report: Path) -> None:
    times = []
    for _ in range(3):
        with opened(browser, sample_report / "report.html") as shown:
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


def test_elevations_are_drawn_where_their_figures_say(page: Opened, sample_report: Path) -> None:
    """The marked point of each chosen station, read off by the axes' ticks."""
    stations, datum = read_stations(sample_report), read_datum(sample_report)
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


def test_facts_are_those_of_the_json(still: Opened, sample_report: Path) -> None:
    datum, facts = read_datum(sample_report), still.text("#summary .facts")
    assert f"{datum['tank']['radius']:.4f}\u00a0m" in facts
    assert f"{datum['tilt']['angle_arcsec']:.1f}" in facts
    assert f"{1e3 * datum['antipodal']['max_h']:.1f}\u00a0mm" in facts
    assert "360 stations measured, 0 interpolated, 0 missing" in still.text(".quality")
    tilt = datum["tilt"]["direction_deg"]
    assert f"high side {tilt:.0f}\u00b0, low side {(tilt + 180) % 360:.0f}\u00b0" in facts


def test_the_section_shows_the_fit(page: Opened, sample_report: Path) -> None:
    """The drawn intersection is at the station's elevation; its points lie on the two lines."""
    html = (sample_report / "report.html").read_text()
    found = re.search(r'id="data-sections">(.*?)</script>', html, re.S)
    assert found
    sections = json.loads(found[1])
    stations = read_stations(sample_report)
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
