"""Report pages opened in headless Chromium, and what is read off them."""

from __future__ import annotations

import io
import json
import re
import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from matplotlib.image import imread
from numpy.typing import NDArray

sync_api = pytest.importorskip("playwright.sync_api")

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

    def click(self, chart: str, x: float, y: float) -> None:
        self.page.locator(f"#{chart} svg").click(position={"x": x, "y": y})

    def picture(self, selector: str) -> NDArray[np.uint8]:
        png = self.page.locator(selector).first.screenshot()
        return pixels(png)

    def downloaded(self, button: Any) -> bytes:
        with self.page.expect_download() as waiting:
            button.click()
        return Path(waiting.value.path()).read_bytes()


def pixels(png: bytes) -> NDArray[np.uint8]:
    image = imread(io.BytesIO(png), format="png")
    return (255 * image[..., :3] + 0.5).astype(np.uint8)


def close_to(image: NDArray[np.uint8], colour: tuple[int, int, int], within: int = 24) -> int:
    """How many pixels have a colour."""
    apart = np.abs(image.astype(int) - np.array(colour)).max(axis=2)
    return int((apart <= within).sum())


@pytest.fixture(scope="session")
def browser() -> Iterator[Any]:
    chromium = shutil.which("chromium")
    assert chromium, "chromium is not installed: ./scripts/test does so"
    with sync_api.sync_playwright() as tool:
        started = tool.chromium.launch(executable_path=chromium, args=["--no-sandbox"])
        yield started
        started.close()


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
