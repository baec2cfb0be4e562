"""The map of a farm: every tank with a known centre, to scale."""

from __future__ import annotations

from typing import Any

from tank_datum.farm.index_rows import COLUMNS, Row
from tank_datum.farm.markup import Markup, element
from tank_datum.farm.view import Plain

WIDE, HIGH = 1000, 420  # of the map [pixels]


def farm_map(views: list[Plain], rows: list[Row]) -> Markup:
    """Every tank with a known centre, to scale; a link each."""
    placed = [
        (view, row)
        for view, row in zip(views, rows, strict=True)
        if view["facts"]["centre"] and view["facts"]["radius"]
    ]
    heading = element("h2", "Map")
    if not placed:
        none = element("p", "No tank has a known centre.", class_="absent")
        return element("section", heading, none, id="map", aria_label="Map")
    chooser = choice(
        "colour-by",
        "Colour by ",
        [words for _, words in COLUMNS[1:]],
        [key for key, _ in COLUMNS[1:]],
    )
    controls = element(
        "div", chooser, element("span", id="legend", class_="legend"), class_="controls"
    )
    drawn = element("div", _drawn(placed), class_="canvas")
    return element("section", heading, controls, drawn, id="map", aria_label="Map")


def _drawn(placed: list[tuple[Plain, Any]]) -> Markup:
    circles = [
        (*view["facts"]["centre"], view["facts"]["radius"]) for view, _ in placed
    ]
    west, east = min(x - r for x, _, r in circles), max(x + r for x, _, r in circles)
    south, north = min(y - r for _, y, r in circles), max(y + r for _, y, r in circles)
    scale = min((WIDE - 40) / (east - west), (HIGH - 40) / (north - south))
    width, height = 40 + scale * (east - west), 40 + scale * (north - south)
    marks = [
        _mark(view, row, 20 + scale * (x - west), 20 + scale * (north - y), scale * r)
        for (x, y, r), (view, row) in zip(circles, placed, strict=True)
    ]
    return element(
        "svg",
        marks,
        viewBox=f"0 0 {width:.0f} {height:.0f}",
        width=round(width),
        height=round(height),
        role="group",
        aria_label="Plan of the tanks",
    )


def _mark(view: Plain, row: Row, x: float, y: float, radius: float) -> Markup:
    """A tank, with its name where that has room."""
    ring = element(
        "circle",
        element("title", view["name"]),
        cx=round(x, 2),
        cy=round(y, 2),
        r=round(max(radius, 3.0), 2),
        class_="ring",
    )
    name = element(
        "text", view["name"], x=round(x, 2), y=round(y + 4, 2), text_anchor="middle"
    )
    return element(
        "a",
        ring,
        name if 2.0 * radius > 7.0 * len(view["name"]) else None,
        href=f"tanks/{view['slug']}.html",
        data_tank=row["tank"][0],
        aria_label=view["name"],
    )


def choice(
    name: str, label: str, words: list[str], values: list[str] | None = None
) -> Markup:
    options = [
        element("option", word, value=value)
        for word, value in zip(words, values or words, strict=True)
    ]
    return element("label", label, element("select", options, id=name))
