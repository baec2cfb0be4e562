"""tank_datum_report: a result on paper, at most five sheets of A4."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from programs import executable
from report_fixtures import JUDGED
from report_pages import SAMPLE, opened, with_data
from results import Run, read_datum, read_points, write_xyz
from test_view import VIEWER

Runner = Callable[..., Run]

ABOUT = """tank = "T-12"
site = "Terminal North"
client = "Example Storage"
inspector = "A. Example"
report_number = "R-118"
survey_date = 2026-11-03
"""
TOLD = ("--mark", "stairs=75,manhole=190", "--north-deg", 60, "--survey-points", 24)


def to_pdf(
    folder: Path,
    pdf: Path,
    *options: object,
    path: str | None = None,
    temporary: Path | None = None,
) -> Run:
    words = [str(executable("tank_datum_report")), str(folder), "--pdf", str(pdf)]
    environment = {**os.environ} | ({} if path is None else {"PATH": path})
    environment |= {} if temporary is None else {"TMPDIR": str(temporary)}
    return subprocess.run(
        [*words, *map(str, options)], capture_output=True, text=True, env=environment, timeout=120
    )


def sheets(pdf: Path) -> int:
    content = pdf.read_bytes()
    assert content.startswith(b"%PDF")
    boxes = {
        tuple(round(float(v)) for v in m.split())
        for m in re.findall(rb"/MediaBox \[(.*?)\]", content)
    }
    assert boxes <= {(0, 0, 595, 842), (0, 0, 596, 842)} and boxes
    return len(re.findall(rb"/Type /Page\b", content))


@pytest.fixture(scope="module")
def failing(run: Runner, sample_report: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """All that a report can hold: identity, survey points, a failing shape, movement."""
    folder = tmp_path_factory.mktemp("paper")
    (folder / "about.toml").write_text(ABOUT)
    points = read_points(SAMPLE)
    azimuth = np.arctan2(points[:, 1], points[:, 0])
    points[:, 2] += 0.03 * np.cos(4 * azimuth)
    scan = write_xyz(folder / "bent.pcd", points)
    told = ("--about", folder / "about.toml", *TOLD)
    done = run(scan, "-o", folder / "out", *JUDGED, *told, "--baseline", sample_report)
    assert done.returncode == 0, done.stderr
    assert read_datum(folder / "out")["verdict"]["word"] == "FAIL"
    return folder / "out"


def test_a_good_tank_takes_five_sheets_or_fewer(sample_report: Path, tmp_path: Path) -> None:
    done = to_pdf(sample_report, tmp_path / "report.pdf")
    assert (done.returncode, done.stderr) == (0, "")
    assert 3 <= sheets(tmp_path / "report.pdf") <= 5


def test_a_failing_tank_with_all_there_is_takes_five(failing: Path, tmp_path: Path) -> None:
    assert to_pdf(failing, tmp_path / "report.pdf").returncode == 0
    assert sheets(tmp_path / "report.pdf") <= 5


@pytest.mark.parametrize(("notes", "most"), [(60, 5), (2000, 99)], ids=["shrunk", "long"])
def test_a_long_report_is_printed_smaller(
    sample_report: Path, tmp_path: Path, notes: int, most: int
) -> None:
    """What would take six sheets fits on five; what is longer by far is printed all the same."""
    result = tmp_path / "result"
    result.mkdir()
    told = {"notes": [f"Note {i} of this tank, a line of its own." for i in range(notes)]}
    with_data(sample_report / "report.html", result / "report.html", told)
    assert to_pdf(result, tmp_path / "report.pdf").returncode == 0
    assert 4 < sheets(tmp_path / "report.pdf") <= most
    assert most == 5 or sheets(tmp_path / "report.pdf") > 5


def test_no_heading_is_left_at_the_foot_of_a_sheet(browser: Any, failing: Path) -> None:
    """Neither is the line under it, as what the movement is since."""
    after = "e => getComputedStyle(e).breakAfter"
    with opened(browser, failing / "report.html") as page:
        page.page.emulate_media(media="print")
        for place in ("#movement h2", "#movement h2 + p", "#shell h3"):
            assert page.page.locator(place).first.evaluate(after) == "avoid", place


def test_a_refusal_takes_one(no_tank_report: Path, tmp_path: Path) -> None:
    assert to_pdf(no_tank_report, tmp_path / "report.pdf").returncode == 0
    assert sheets(tmp_path / "report.pdf") == 1


def test_its_own_file_is_replaced_and_anothers_kept(no_tank_report: Path, tmp_path: Path) -> None:
    pdf = tmp_path / "report.pdf"
    pdf.write_bytes(b"%PDF-1.4 of somebody else")
    assert "kept" in to_pdf(no_tank_report, pdf).stderr
    assert (tmp_path / "report.kept.pdf").read_bytes() == b"%PDF-1.4 of somebody else"
    assert to_pdf(no_tank_report, pdf).stderr == ""
    assert sorted(p.name for p in tmp_path.iterdir()) == ["report.kept.pdf", "report.pdf"]


@pytest.mark.parametrize(
    ("options", "path", "words"),
    [
        pytest.param((), "", ["browser", "not found", "print report.html"], id="none in PATH"),
        pytest.param(("--browser", "no_such"), None, ["no_such", "not found"], id="none named so"),
        pytest.param(("--browser", shutil.which("false")), None, ["did not write"], id="one fails"),
    ],
)
def test_without_a_browser_a_line_says_so(
    sample_report: Path,
    tmp_path: Path,
    options: tuple[str, ...],
    path: str | None,
    words: list[str],
) -> None:
    done = to_pdf(sample_report, tmp_path / "report.pdf", *options, path=path)
    assert done.returncode == 3
    assert len(done.stderr.splitlines()) == 1
    assert all(word in done.stderr for word in words), done.stderr
    assert list(tmp_path.iterdir()) == []


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


needs_viewer = pytest.mark.skipif(not VIEWER.exists(), reason="tank_datum_view is not built")


@needs_viewer
def test_the_picture_is_drawn_without_being_asked_for(
    browser: Any, failing: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """On screen and on paper; not of the word none, and not of what has no datum to draw."""
    monkeypatch.delenv("DISPLAY", raising=False)
    done = written(failing, tmp_path / "drawn.html")
    assert (done.returncode, done.stderr) == (0, "")
    with opened(browser, tmp_path / "drawn.html") as page:
        size = page.page.locator("#view img").evaluate("e => [e.naturalWidth, e.naturalHeight]")
        assert size == [1280, 800] and page.slips() == []
    assert to_pdf(failing, tmp_path / "report.pdf").stderr == ""
    assert b"/Width 1280" in (tmp_path / "report.pdf").read_bytes()
    written(failing, tmp_path / "without.html", "--picture", "none")
    assert (tmp_path / "without.html").read_bytes() == (failing / "report.html").read_bytes()


@needs_viewer
def test_a_scan_that_has_gone_leaves_the_report_without_a_picture(
    failing: Path, tmp_path: Path
) -> None:
    """Or another that stands in its place: a line says so, and the report is written."""
    shutil.copytree(failing, tmp_path / "at" / "out")
    datum = (tmp_path / "at" / "out" / "datum.json").read_text()
    moved = datum.replace(str(failing.parent / "bent.pcd"), "/gone/bent.pcd")
    (tmp_path / "at" / "out" / "datum.json").write_text(moved)
    points = read_points(failing.parent / "bent.pcd")
    for there, line in ((None, True), (points[1:], True), (points, False)):
        if there is not None:
            write_xyz(tmp_path / "at" / "bent.pcd", there)
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


def test_no_file_asked_for_is_refused(sample_report: Path) -> None:
    command = [str(executable("tank_datum_report")), str(sample_report)]
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode == 2 and "--pdf or --html" in done.stderr


def test_a_folder_without_a_report_is_refused(tmp_path: Path) -> None:
    done = to_pdf(tmp_path, tmp_path / "report.pdf")
    assert done.returncode == 3 and "report.html, not there" in done.stderr
