"""report.html answers to the pointer and the keys, and its charts are linked."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest

from report_pages import LINKED, Opened, scale_of
from results import read_datum, read_stations


def test_hover_shows_the_station_and_marks_it_everywhere(page: Opened, sample_report: Path) -> None:
    svg = page.page.locator("#elevation-chart svg")
    a, b = scale_of(page, "elevation-chart", 0)
    svg.scroll_into_view_if_needed()
    page.hover("elevation-chart", (90 - a) / b, 150)
    stations = read_stations(sample_report)
    tip = page.text("#tip")
    assert "Station 90 at 90.0\u00b0, measured" in tip
    assert f"{stations['z'][90]:.4f}\u00a0m" in tip.replace("\u2212", "-")
    assert f"{1e3 * stations['u'][90]:.2f}\u00a0mm" in tip.replace("\u2212", "-")
    for chart in LINKED:
        mark = page.page.locator(f"#{chart} circle.hovered")
        assert mark.get_attribute("visibility") is None, chart
    for chart in ("shell-map", "roundness-chart"):
        assert page.page.locator(f"#{chart} line.hovered").get_attribute("visibility") is None
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


def test_a_station_is_chosen_by_click_number_button_and_key(
    page: Opened, sample_report: Path
) -> None:
    stations = read_stations(sample_report)

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
    """The paper's curve is off at first."""
    assert page.page.locator("#elevation-chart path.reference").count() == 0
    page.page.get_by_label("paper\u2019s curve").check()
    assert page.page.locator("#elevation-chart path.reference").count() == 1
    page.page.get_by_label("paper\u2019s curve").uncheck()
    assert page.page.locator("#elevation-chart path.reference").count() == 0


def chosen_station(page: Opened) -> int:
    return int(page.texts("#station-values dd")[0].split(" at ")[0])


def test_the_worst_station_is_chosen_first_or_the_one_that_the_address_names(
    page: Opened, sample_report: Path
) -> None:
    stations = read_stations(sample_report)
    worst = int(np.nanargmax(np.abs(stations["u"])))
    datum = read_datum(sample_report)
    governing = next(
        c for c in datum["checks"] if f"{c['code']} {c['name']}" == datum["verdict"]["governing"]
    )
    assert governing["verdict"] != "not_evaluated"
    assert chosen_station(page) == round(governing["azimuth_deg"]) != worst
    assert page.page.locator("#station-number").input_value() == str(chosen_station(page))
    page.page.goto((sample_report / "report.html").resolve().as_uri() + "#station=17")
    assert chosen_station(page) == 17
    for name, wanted in {
        "worst out of plane": worst,
        "highest": int(np.nanargmax(stations["z"])),
        "lowest": int(np.nanargmin(stations["z"])),
    }.items():
        page.page.get_by_role("button", name=name, exact=True).click()
        assert chosen_station(page) == wanted, name
