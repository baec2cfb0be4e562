"""What leaves report.html: downloads and print, and names that never become markup."""

from __future__ import annotations

import json
import re
import shutil
import xml.etree.ElementTree as ElementTree
from collections.abc import Callable
from pathlib import Path
from typing import Any

from report_pages import CHARTS, DATUM_BLUE, SAMPLE, Opened, close_to, inked, opened, pixels
from results import Run, read_datum

Runner = Callable[..., Run]


def test_names_are_never_markup(run: Runner, browser: Any, tmp_path: Path) -> None:
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


def test_downloads(page: Opened, sample_report: Path) -> None:
    def saved(name: str) -> bytes:
        return page.downloaded(page.page.get_by_role("button", name=name, exact=True))

    assert json.loads(saved("datum.json")) == read_datum(sample_report)
    assert saved("stations.csv") == (sample_report / "stations.csv").read_bytes()
    charts = page.page.locator("figure .canvas").all()
    assert len(charts) >= len(CHARTS) + 3
    for chart in [canvas.get_attribute("id") for canvas in charts]:
        svg = saved(f"{chart} as SVG")
        root = ElementTree.fromstring(svg)
        assert root.tag == "{http://www.w3.org/2000/svg}svg"
        assert b"var(--" not in svg  # stands without the page
        assert page.page.get_by_role("button", name=f"{chart} as PNG", exact=True).count() == 1
        if chart not in ("elevation-chart", "plan-chart", "shell-map"):
            continue
        image = pixels(saved(f"{chart} as PNG"))
        assert image.shape[1] == 2 * float(root.get("width"))
        assert inked(image) > 0.004, chart
        if chart == "elevation-chart":
            assert b"rgb(7, 87, 181)" in svg and close_to(image, DATUM_BLUE) > 1000
    assert page.errors == []


def test_prints_on_a4(page: Opened, tmp_path: Path) -> None:
    pdf = page.page.pdf(prefer_css_page_size=True, path=tmp_path / "report.pdf")
    assert pdf.startswith(b"%PDF")
    boxes = {
        tuple(round(float(v)) for v in m.split()) for m in re.findall(rb"/MediaBox \[(.*?)\]", pdf)
    }
    assert boxes <= {(0, 0, 595, 842), (0, 0, 596, 842)} and boxes
    assert 3 <= pdf.count(b"/Type /Page\n") + pdf.count(b"/Type /Page ") <= 5
    page.page.emulate_media(media="print", color_scheme="dark")
    assert page.page.locator("#exaggeration").is_hidden()
    assert page.page.locator("nav").is_hidden()
    assert (
        page.page.evaluate("getComputedStyle(document.body).backgroundColor")
        == "rgb(255, 255, 255)"
    )
    assert page.texts(".paper-only span") == ["Inspector", "Date", "Signature"]
    page.page.emulate_media(media="screen")
    assert page.page.locator(".paper-only").is_hidden()
