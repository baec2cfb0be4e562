"""report.html can be read by anybody: contrast, dark, a phone, a listener."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from report_pages import CHARTS, PHONE, WIDE, Opened, opened, pixels

# Labels that leave their chart, or lie on another one.
LABEL_CLASHES = """() => [...document.querySelectorAll('main svg')].flatMap(svg => {
  const frame = svg.getBoundingClientRect(), name = svg.closest('.canvas').id;
  const all = [...svg.querySelectorAll('text')]
    .map(t => [t.textContent, t.getBoundingClientRect()]);
  const leaves = b => b.left < frame.left - 1 || b.right > frame.right + 1
    || b.top < frame.top - 1 || b.bottom > frame.bottom + 1;
  const found = all.filter(([, b]) => leaves(b)).map(([t]) => `${name}: ${t} outside`);
  all.forEach(([t, a], i) => all.slice(i + 1).forEach(([u, b]) => {
    const across = Math.min(a.right, b.right) - Math.max(a.left, b.left);
    const down = Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top);
    if (across > 1 && down > 3) found.push(`${name}: ${t} on ${u}`);
  }));
  return found; })"""


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
def test_contrast(browser: Any, sample_report: Path, scheme: str) -> None:
    with opened(browser, sample_report / "report.html", scheme=scheme) as page:
        for selector in ("p", ".quiet", "nav a", ".absent"):
            assert contrast(page, selector) > 4.5, selector
        dark = pixels(page.page.screenshot())[5, 5].mean() < 64
        assert dark == (scheme == "dark")


def test_on_a_phone(browser: Any, sample_report: Path) -> None:
    with opened(browser, sample_report / "report.html", size=PHONE) as page:
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


@pytest.mark.parametrize("size", [WIDE, PHONE, (340, 700)], ids=["wide", "phone", "small"])
def test_labels_lie_inside_and_apart(
    browser: Any, sample_report: Path, size: tuple[int, int]
) -> None:
    with opened(browser, sample_report / "report.html", size=size) as page:
        assert page.page.evaluate(LABEL_CLASHES) == []
