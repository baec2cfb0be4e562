"""Trends, levels and hydrotests on the page of a tank."""

from __future__ import annotations

from typing import Any

from tank_datum.farm.charts import Drawn, Point, chart
from tank_datum.farm.dates import year_of
from tank_datum.farm.markup import DASH, Markup, element, figure, table
from tank_datum.farm.view import Plain

NAMES = {
    "settlement": ("Settlement of the mean", "mm"),
    "tilt": ("Change of tilt", "mm/m"),
    "station": ("Movement of the worst station", "mm"),
    "out_of_plane": ("The same out of the plane", "mm"),
}
FEW = "Fewer than two surveys count over the years; of a hydrotest only the first does."
TRENDS = ["Quantity", "Rate", "95 %", "Moves", "At azimuth", "Limit", "Limit reached"]
STEPS = ["Step", "Date", "Liquid level", "Settlement"]
STEPS += ["Change of tilt", "Worst station", "Out of plane"]


def section(name: str, heading: str, *content: Any) -> Markup:
    return element(
        "section", element("h2", heading), content, id=name, aria_label=heading
    )


def with_half(change: Plain, name: str, scale: float, unit: str) -> str:
    value, sigma = change.get(name), change.get(f"sigma_{name}")
    if value is None:
        return DASH
    return (
        f"{figure(value, 1, scale)} ± {figure(1.96 * (sigma or 0.0), 1, scale, unit)}"
    )


def trends_section(view: Plain) -> Markup:
    if not view["trends"]:
        return section(
            "trends",
            "Over time",
            element("p", FEW, class_="absent"),
        )
    rows = [
        _trend_row(name, trend, view["limits"][name])
        for name, trend in view["trends"].items()
    ]
    made = table(
        TRENDS, rows, "Rates with their 95 % intervals; when a limit will be reached"
    )
    charts = [_against_date(view, name) for name in NAMES]
    return section("trends", "Over time", made, element("div", charts, class_="pair"))


def _trend_row(name: str, trend: Plain, limit: float | None) -> list[Any]:
    words, unit = NAMES[name]
    azimuth = trend["azimuth_deg"]
    digits = 3 if unit == "mm/m" else 2
    return [
        words,
        figure(trend["rate"], digits, 1e3, f"{unit} a year"),
        f"{figure(trend['low'], digits, 1e3)} to {figure(trend['high'], digits, 1e3)}",
        "yes" if trend["moves"] else "no",
        DASH if azimuth is None else figure(azimuth, 0) + "°",
        figure(limit, 1, 1e3, unit),
        trend["reaching_words"] or DASH,
    ]


def _against_date(view: Plain, name: str) -> Markup | None:
    words, unit = NAMES[name]
    shown = [c for c in view["changes"] if c[name] is not None]
    if not shown:
        return None
    points = [
        Point(
            year_of(view["changes"][0]["date"]), 0.0, 0.0, view["changes"][0]["epoch"]
        )
    ]
    for change in shown:
        half = 1.96e3 * (change.get(f"sigma_{name}") or 0.0)
        label = f"{change['epoch']}: {figure(change[name], 2, 1e3, unit)}"
        points.append(Point(year_of(change["date"]), 1e3 * change[name], half, label))
    limit = view["limits"][name]
    trend = view["trends"].get(name)
    line = None
    if trend and name == "settlement":
        first, last = points[0].x, points[-1].x
        middle_x = sum(p.x for p in points) / len(points)
        middle_y = sum(p.y for p in points) / len(points)
        rate = 1e3 * trend["rate"]
        line = (
            first,
            middle_y + rate * (first - middle_x),
            last,
            middle_y + rate * (last - middle_x),
        )
    return chart(
        Drawn(
            f"{words} against date",
            "Year",
            f"{words} [{unit}]",
            points,
            line,
            None if limit is None else 1e3 * limit,
            dates=True,
        )
    )


def levels_section(view: Plain) -> Markup | None:
    """Settlement against the level of the liquid, where it is known."""
    shown = [c for c in view["changes"] if c["fill_level"] is not None]
    levels = {c["fill_level"] for c in shown}
    if len(levels) < 2 or all(c["settlement"] is None for c in shown):
        return None
    points = [_level_point(change) for change in shown]
    drawn = Drawn(
        "Settlement against level", "Level of the liquid [m]", "Settlement [mm]", points
    )
    return section("levels", "Against the level", chart(drawn))


def _level_point(change: Plain) -> Point:
    value, sigma = change["settlement"] or 0.0, change["sigma_settlement"] or 0.0
    label = f"{change['epoch']}, {change['date']}: {figure(value, 2, 1e3, 'mm')}"
    return Point(change["fill_level"], 1e3 * value, 1.96e3 * sigma, label)


def hydrotest_section(test: Plain, view: Plain) -> Markup:
    rows = [
        [
            step["epoch"],
            step["date"],
            figure(step["fill_level"], 2, 1.0, "m"),
            with_half(step, "settlement", 1e3, "mm"),
            figure(step["tilt"], 3, 1e3, "mm/m"),
            figure(step["station"], 1, 1e3, "mm"),
            figure(step["out_of_plane"], 1, 1e3, "mm"),
        ]
        for step in test["steps"]
    ]
    figures = [
        ("Settlement a metre of liquid", test["per_metre"], "mm/m"),
        ("Left when empty again", test["lasting"], "mm"),
        ("Hysteresis at most", test["hysteresis"], "mm"),
    ]
    boxes = [
        element("div", element("dt", words), element("dd", _figure(given, unit)))
        for words, given, unit in figures
    ]
    name = f"Hydrotest {test['name']}"
    content: list[Any] = [element("dl", boxes, class_="facts")]
    if test["steps"] and any(step["settlement"] is not None for step in test["steps"]):
        drawn = Drawn(
            f"{name}: settlement against level",
            "Level of the liquid [m]",
            "Settlement [mm]",
            [_level_point(step) for step in test["steps"]],
            joined=True,
        )
        content.append(chart(drawn))
    content.append(table(STEPS, rows, f"{name}: the steps, since its first"))
    content += [element("p", note, class_="absent") for note in test["notes"]]
    return section(f"hydrotest-{view['hydrotests'].index(test) + 1}", name, *content)


def _figure(given: Plain | None, unit: str) -> str:
    if given is None:
        return DASH
    return f"{figure(given['value'], 2, 1e3)} ± {figure(1.96 * given['sigma'], 2, 1e3, unit)}"
