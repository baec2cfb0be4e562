"""Report pages opened in headless Chromium, and what is read off them."""

from __future__ import annotations

import io
import json
import re
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

SAMPLE = Path(__file__).resolve().parents[1] / "data" / "sample.pcd"
CHARTS = (
    "elevation-chart",
    "out-of-plane-chart",
    "plan-chart",
    "section-chart",
    "corner-chart",
    "residuals-chart",
)
LINKED = ("elevation-chart", "out-of-plane-chart", "plan-chart")
WIDE = (1200, 900)
PHONE = (390, 844)
DATUM_BLUE = (7, 87, 181)


@dataclass
class Opened:
    """A page and what went wrong on it."""

    page: Any
    errors: list[str] = field(default_factory=list)
    requests: list[str] = field(default_factory=list)

    def texts(self, selector: str) -> list[str]:
        return [t.strip() for t in self.page.locator(selector).all_inner_texts()]

    def text(self, selector: str) -> str:
        return " ".join(self.texts(selector))

    def hover(self, chart: str, x: float, y: float) -> None:
        """Moves the pointer to a place of a chart, in its own pixels."""
        svg = self.page.locator(f"#{chart} svg")
        svg.scroll_into_view_if_needed()
        box = svg.bounding_box()
        self.page.mouse.move(box["x"] + x, box["y"] + y)

    def choose(self, station: int) -> None:
        self.page.locator("#station-number").fill(str(station))
        self.page.locator("#station-number").press("Enter")

    def slips(self) -> list[str]:
        """What no reader should meet: console lines, words of a program, empty sections."""
        said = self.page.evaluate(
            """() => { const copy = document.body.cloneNode(true);
                 copy.querySelectorAll('script, template, style, pre, .paper-text')
                   .forEach(e => e.remove());
                 return copy.textContent; }"""
        )
        empty = self.page.evaluate(
            """[...document.querySelectorAll('main > section')]
                 .filter(s => s.childElementCount < 2).map(s => s.id)"""
        )
        found = re.findall(r"\w* ?\b(?:null|NaN|undefined|Infinity|\[object)\b ?\w*", said)
        return [*self.errors, *found, *empty]

    def click(self, chart: str, x: float, y: float) -> None:
        self.page.locator(f"#{chart} svg").click(position={"x": x, "y": y})

    def picture(self, selector: str) -> NDArray[np.uint8]:
        png = self.page.locator(selector).first.screenshot()
        return pixels(png)

    def downloaded(self, button: Any) -> bytes:
        with self.page.expect_download() as waiting:
            button.click()
        return Path(waiting.value.path()).read_bytes()


def plain(text: str) -> str:
    """The page's words as a terminal has them."""
    signs = {"\u00a0": " ", "\u2212": "-", "\u00b1": "+-", "\u03c3": " sigma", "\u00b0": " deg"}
    signs |= {"\u00d7": "x", "\u207b": "^-", "\u2076": "6"}
    for sign, word in signs.items():
        text = text.replace(sign, word)
    return text


def pixels(png: bytes) -> NDArray[np.uint8]:
    from matplotlib.image import imread

    image = imread(io.BytesIO(png), format="png")
    return (255 * image[..., :3] + 0.5).astype(np.uint8)


def inked(image: NDArray[np.uint8]) -> float:
    """The share of pixels that are not of the background."""
    apart = np.abs(image.astype(int) - image[0, 0]).max(axis=2)
    return float((apart > 60).mean())


def close_to(image: NDArray[np.uint8], colour: tuple[int, int, int], within: int = 24) -> int:
    """How many pixels have a colour."""
    apart = np.abs(image.astype(int) - np.array(colour)).max(axis=2)
    return int((apart <= within).sum())


@contextmanager
def opened(
    browser: Any, path: Path, size: tuple[int, int] = WIDE, scheme: str = "light"
) -> Iterator[Opened]:
    context = browser.new_context(
        viewport={"width": size[0], "height": size[1]}, color_scheme=scheme, offline=True
    )
    page = context.new_page()
    page.set_default_timeout(10_000)
    result = Opened(page)
    page.on("pageerror", lambda error: result.errors.append(str(error)))
    page.on(
        "console",
        lambda line: result.errors.append(line.text) if line.type in ("error", "warning") else None,
    )
    page.on("request", lambda request: result.requests.append(request.url))
    page.goto(path.resolve().as_uri())
    yield result
    context.close()


def with_data(report: Path, target: Path, changes: dict[str, Any]) -> Path:
    """The report with further keys in its datum, as later stages write them."""
    html = report.read_text()
    found = re.search(r'<script type="application/json" id="data-datum">(.*?)</script>', html, re.S)
    assert found
    datum = json.loads(found[1]) | changes
    text = json.dumps(datum).replace("<", "\\u003c")
    target.write_text(html[: found.start(1)] + text + html[found.end(1) :])
    return target


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
