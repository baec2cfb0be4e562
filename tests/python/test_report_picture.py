"""The viewer's picture: drawn without a display, and in the report."""

from __future__ import annotations

import shutil
import subprocess
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from matplotlib.image import imread

from programs import executable
from report_pages import SAMPLE, opened
from results import Run, read_points, write_xyz
from test_report_paper import sheets, to_pdf
from test_view import VIEWER, count, view

Runner = Callable[..., Run]

needs_viewer = pytest.mark.skipif(not VIEWER.exists(), reason="tank_datum_view is not built")


@pytest.fixture(scope="module")
def scanned(run: Runner, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The result of a scan that a test may move."""
    folder = tmp_path_factory.mktemp("scanned")
    scan = write_xyz(folder / "scan.pcd", read_points(SAMPLE))
    assert run(scan, "-o", folder / "out").returncode == 0
    return folder / "out"


@pytest.fixture(scope="module")
def picture(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """An image as the viewer writes one."""
    import matplotlib.image

    path = tmp_path_factory.mktemp("picture") / "view.png"
    matplotlib.image.imsave(path, np.random.default_rng(1).random((80, 128, 3)))
    return path


def written(folder: Path, html: Path, *options: object) -> Run:
    words = [executable("tank_datum_report"), folder, "--html", html, *options]
    return subprocess.run([str(w) for w in words], capture_output=True, text=True, timeout=120)


def test_a_picture_of_the_viewer_goes_into_the_report(
    browser: Any, sample_report: Path, picture: Path, tmp_path: Path
) -> None:
    """On screen and on paper, in one sheet at most more; the result's own page stays as it is."""
    before = (sample_report / "report.html").read_bytes()
    for _ in range(2):  # the second replaces the first's file
        done = written(sample_report, tmp_path / "sent.html", "--picture", picture)
        assert (done.returncode, done.stderr) == (0, "")
    with opened(browser, tmp_path / "sent.html") as page:
        assert page.slips() == []
        shown = page.page.locator("#view img")
        assert shown.evaluate("e => [e.naturalWidth, e.naturalHeight]") == [128, 80]
        assert shown.get_attribute("alt") and "View" in page.texts("main h2")
    with opened(browser, sample_report / "report.html") as page:
        assert page.page.locator("#view").count() == 0
    assert (sample_report / "report.html").read_bytes() == before
    done = to_pdf(sample_report, tmp_path / "report.pdf", "--picture", picture)
    assert done.returncode == 0 and sheets(tmp_path / "report.pdf") <= 5
    assert b"/Width 128" in (tmp_path / "report.pdf").read_bytes()


def test_a_picture_in_a_page_is_replaced(
    sample_report: Path, picture: Path, tmp_path: Path
) -> None:
    (tmp_path / "once").mkdir()
    once = tmp_path / "once" / "report.html"
    written(sample_report, once, "--picture", picture)
    written(once.parent, tmp_path / "twice.html", "--picture", picture)
    assert (tmp_path / "twice.html").read_bytes() == once.read_bytes()


@needs_viewer
def test_the_picture_is_drawn_without_being_asked_for(
    browser: Any, scanned: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """On screen and on paper; not of the word none, and not of what has no datum to draw."""
    monkeypatch.delenv("DISPLAY", raising=False)
    done = written(scanned, tmp_path / "drawn.html")
    assert (done.returncode, done.stderr) == (0, "")
    with opened(browser, tmp_path / "drawn.html") as page:
        size = page.page.locator("#view img").evaluate("e => [e.naturalWidth, e.naturalHeight]")
        assert size == [1280, 800] and page.slips() == []
    assert to_pdf(scanned, tmp_path / "report.pdf").stderr == ""
    assert b"/Width 1280" in (tmp_path / "report.pdf").read_bytes()
    written(scanned, tmp_path / "without.html", "--picture", "none")
    assert (tmp_path / "without.html").read_bytes() == (scanned / "report.html").read_bytes()


@needs_viewer
def test_a_scan_that_has_gone_leaves_the_report_without_a_picture(
    scanned: Path, tmp_path: Path
) -> None:
    """Or another that stands in its place: a line says so, and the report is written."""
    shutil.copytree(scanned, tmp_path / "at" / "out")
    datum = (tmp_path / "at" / "out" / "datum.json").read_text()
    moved = datum.replace(str(scanned.parent / "scan.pcd"), "/gone/scan.pcd")
    (tmp_path / "at" / "out" / "datum.json").write_text(moved)
    points = read_points(scanned.parent / "scan.pcd")
    for there, line in ((None, True), (points[1:], True), (points, False)):
        if there is not None:
            write_xyz(tmp_path / "at" / "scan.pcd", there)
        done = written(tmp_path / "at" / "out", tmp_path / "sent.html")
        assert done.returncode == 0 and ("no picture of the tank" in done.stderr) == line
        assert ('id="data-view"' in (tmp_path / "sent.html").read_text()) != line


def test_without_a_viewer_the_report_is_as_it_is(
    sample_report: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Neither beside the program nor in PATH, as the Python package has none."""
    alone = shutil.copy(executable("tank_datum_report"), tmp_path)
    monkeypatch.setenv("PATH", str(tmp_path))
    words = [alone, sample_report, "--html", tmp_path / "sent.html"]
    done = subprocess.run([str(w) for w in words], capture_output=True, text=True, timeout=120)
    assert (done.returncode, done.stderr) == (0, "")
    assert (tmp_path / "sent.html").read_bytes() == (sample_report / "report.html").read_bytes()


def test_a_refusal_has_no_picture(no_tank_report: Path, tmp_path: Path) -> None:
    done = written(no_tank_report, tmp_path / "sent.html")
    assert (done.returncode, done.stderr) == (0, "")
    assert (tmp_path / "sent.html").read_bytes() == (no_tank_report / "report.html").read_bytes()


@pytest.mark.parametrize(
    ("content", "words"),
    [
        pytest.param(b"text", "no image", id="a text"),
        pytest.param(b"\x89PNG" + bytes(8 << 20), "at most 8 MB", id="too large"),
        pytest.param(None, "not_there.png", id="none"),
    ],
)
def test_other_pictures_are_refused(
    sample_report: Path, tmp_path: Path, content: bytes | None, words: str
) -> None:
    path = tmp_path / ("not_there.png" if content is None else "a.png")
    if content is not None:
        path.write_bytes(content)
    done = written(sample_report, tmp_path / "sent.html", "--picture", path)
    assert done.returncode == 3 and words in done.stderr
    assert not (tmp_path / "sent.html").exists()


def test_a_picture_of_5_mb_is_taken(sample_report: Path, tmp_path: Path) -> None:
    (tmp_path / "a.png").write_bytes(b"\x89PNG" + bytes(5 << 20))
    done = written(sample_report, tmp_path / "sent.html", "--picture", tmp_path / "a.png")
    assert done.returncode == 0


@needs_viewer
@pytest.mark.parametrize("name", [None, ":987"], ids=["none", "dead"])
def test_a_picture_needs_no_display(sample_report: Path, tmp_path: Path, name: str | None) -> None:
    """Xvfb is started for it, and ends with it."""
    result = view(name, sample_report, "--screenshot", tmp_path / "a.png")
    assert (result.returncode, result.stderr) == (0, "")
    drawn = np.asarray(imread(tmp_path / "a.png"), dtype=np.float64)[:, :, :3]
    assert drawn.shape == (800, 1280, 3) and count(drawn, "curve") > 300


@needs_viewer
def test_without_xvfb_a_line_says_so(
    sample_report: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("PATH", str(tmp_path))
    result = view(None, sample_report, "--screenshot", tmp_path / "a.png")
    assert (result.returncode, result.stderr.count("\n")) == (2, 1)
    assert "Xvfb in PATH" in result.stderr and list(tmp_path.iterdir()) == []
