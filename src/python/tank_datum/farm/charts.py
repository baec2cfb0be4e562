"""Charts as SVG: values with 95 % bars against dates or levels, in the report's colours."""

from __future__ import annotations

import math
from dataclasses import dataclass

from tank_datum.farm.dates import date_ticks
from tank_datum.farm.markup import MINUS, Markup, element

WIDTH, HEIGHT = 520, 260
LEFT, RIGHT, TOP, BOTTOM = 62, 14, 12, 44


@dataclass(frozen=True)
class Point:
    """half: of the 95 % interval, 0 for none; label: what a pointer and a listener are told."""

    x: float
    y: float
    half: float = 0.0
    label: str = ""


@dataclass(frozen=True)
class Drawn:
    """What a chart shows. line: of a trend, from (x, y) to (x, y); limit: at +limit and -limit;
    joined: the points are joined in their order, with an arrow at each step."""

    title: str
    x_title: str
    y_title: str
    points: list[Point]
    line: tuple[float, float, float, float] | None = None
    limit: float | None = None
    joined: bool = False
    dates: bool = False


class _Scale:
    """Value to pixel, with ticks at round values."""

    def __init__(self, low: float, high: float, first: float, last: float) -> None:
        if high - low <= 0.0:
            low, high = low - 0.5, high + 0.5
        room = 0.06 * (high - low)
        self.low, self.high, self.first, self.last = (
            low - room,
            high + room,
            first,
            last,
        )

    def __call__(self, value: float) -> float:
        share = (value - self.low) / (self.high - self.low)
        return round(self.first + share * (self.last - self.first), 2)

    def ticks(self, most: int = 6) -> list[float]:
        step = 10.0 ** math.floor(math.log10((self.high - self.low) / most))
        for factor in (1, 2, 5, 10, 20, 50):
            if (self.high - self.low) / (step * factor) <= most:
                step *= factor
                break
        first = math.ceil(self.low / step)
        return [step * k for k in range(first, math.floor(self.high / step) + 1)]


def chart(drawn: Drawn) -> Markup:
    """The chart as an image with a name; its figures stand in the page's tables too."""
    x = _Scale(*_reach([p.x for p in drawn.points]), LEFT, WIDTH - RIGHT)
    heights = [v for p in drawn.points for v in (p.y - p.half, p.y + p.half)] + [0.0]
    if drawn.limit is not None and max(map(abs, heights)) > 0.4 * drawn.limit:
        heights += [math.copysign(drawn.limit, max(heights, key=abs))]
    y = _Scale(*_reach(heights), HEIGHT - BOTTOM, TOP)
    parts = [_axes(drawn, x, y), _limits(drawn, x, y), *_trend(drawn, x, y)]
    if drawn.joined:
        parts += _steps(drawn, x, y)
    parts += [_point(point, x, y) for point in drawn.points]
    svg = element(
        "svg",
        parts,
        viewBox=f"0 0 {WIDTH} {HEIGHT}",
        width=WIDTH,
        height=HEIGHT,
        role="img",
        aria_label=drawn.title,
    )
    caption = element("figcaption", element("span", drawn.title))
    return element("figure", element("div", svg, class_="canvas"), caption)


def _reach(values: list[float]) -> tuple[float, float]:
    return min(values), max(values)


def _axes(drawn: Drawn, x: _Scale, y: _Scale) -> list[Markup]:
    parts = []
    for value in y.ticks():
        at = y(value)
        parts.append(
            element("line", x1=LEFT, x2=WIDTH - RIGHT, y1=at, y2=at, class_="rule")
        )
        parts.append(_text(LEFT - 7, at + 4, _shown(value, y), "end"))
    dates = date_ticks(x.low, x.high) if drawn.dates else None
    for value, shown in dates or [(v, _shown(v, x)) for v in x.ticks()]:
        at = x(value)
        parts.append(
            element("line", x1=at, x2=at, y1=TOP, y2=HEIGHT - BOTTOM, class_="rule")
        )
        parts.append(_text(at, HEIGHT - BOTTOM + 17, shown, "middle"))
    zero = y(0.0)
    parts.append(
        element("line", x1=LEFT, x2=WIDTH - RIGHT, y1=zero, y2=zero, class_="zero")
    )
    parts.append(_text((LEFT + WIDTH - RIGHT) / 2, HEIGHT - 8, drawn.x_title, "middle"))
    middle = (TOP + HEIGHT - BOTTOM) / 2
    turned = element(
        "text",
        drawn.y_title,
        x=-middle,
        y=14,
        transform="rotate(-90)",
        text_anchor="middle",
    )
    return [*parts, turned]


def _text(x: float, y: float, text: str, anchor: str) -> Markup:
    return element("text", text, x=x, y=y, text_anchor=anchor)


def _shown(value: float, scale: _Scale) -> str:
    digits = max(0, 1 - math.floor(math.log10(scale.high - scale.low)))
    text = f"{value:.{digits}f}"
    return text.replace("-", MINUS) if float(text) else text.lstrip("-")


def _limits(drawn: Drawn, x: _Scale, y: _Scale) -> list[Markup]:
    if drawn.limit is None:
        return []
    seen = [v for v in (drawn.limit, -drawn.limit) if y.low < v < y.high]
    return [
        element("line", x1=LEFT, x2=WIDTH - RIGHT, y1=y(v), y2=y(v), class_="limit")
        for v in seen
    ]


def _trend(drawn: Drawn, x: _Scale, y: _Scale) -> list[Markup]:
    if drawn.line is None:
        return []
    x1, y1, x2, y2 = drawn.line
    return [element("line", x1=x(x1), y1=y(y1), x2=x(x2), y2=y(y2), class_="line fit")]


def _steps(drawn: Drawn, x: _Scale, y: _Scale) -> list[Markup]:
    """Lines from point to point with an arrow in the middle of each."""
    parts = []
    for a, b in zip(drawn.points, drawn.points[1:], strict=False):
        x1, y1, x2, y2 = x(a.x), y(a.y), x(b.x), y(b.y)
        parts.append(element("line", x1=x1, y1=y1, x2=x2, y2=y2, class_="line datum"))
        if math.hypot(x2 - x1, y2 - y1) > 24:
            turn = math.degrees(math.atan2(y2 - y1, x2 - x1))
            place = (
                f"translate({(x1 + x2) / 2:.1f} {(y1 + y2) / 2:.1f}) rotate({turn:.1f})"
            )
            parts.append(
                element("path", d="M-5-4L5 0L-5 4Z", transform=place, class_="station")
            )
    return parts


def _point(point: Point, x: _Scale, y: _Scale) -> Markup:
    at = x(point.x)
    bar = element(
        "line",
        x1=at,
        x2=at,
        y1=y(point.y - point.half),
        y2=y(point.y + point.half),
        class_="whisker",
    )
    dot = element(
        "circle",
        element("title", point.label),
        cx=at,
        cy=y(point.y),
        r=4,
        class_="station",
    )
    return element("g", bar if point.half else None, dot)
