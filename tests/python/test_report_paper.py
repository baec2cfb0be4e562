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


def test_points_of_every_degree_are_printed_on_five_sheets(
    browser: Any, failing: Path, tmp_path: Path
) -> None:
    result = tmp_path / "result"
    result.mkdir()
    point = {"z": 109.98765, "sigma_z": 0.00123, "u": -0.0123}
    points = [{"number": i + 1, "azimuth_deg": (89.5 - i) % 360} | point for i in range(360)]
    with_data(failing / "report.html", result / "report.html", {"survey_points": points})
    assert to_pdf(result, tmp_path / "report.pdf").returncode == 0
    assert sheets(tmp_path / "report.pdf") <= 5
    with opened(browser, result / "report.html", size=(695, 1000)) as page:  # 184 mm
        page.page.emulate_media(media="print")
        wide = page.page.locator(".survey-points table").evaluate(
            "e => e.getClientRects()[0].width / e.closest('.survey-points').clientWidth"
        )
        assert 0.2 < wide <= 0.25


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


def test_no_file_asked_for_is_refused(sample_report: Path) -> None:
    command = [str(executable("tank_datum_report")), str(sample_report)]
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode == 2 and "--pdf or --html" in done.stderr


def test_a_folder_without_a_report_is_refused(tmp_path: Path) -> None:
    done = to_pdf(tmp_path, tmp_path / "report.pdf")
    assert done.returncode == 3 and "report.html, not there" in done.stderr


def test_page_and_print_are_two_files(sample_report: Path, tmp_path: Path) -> None:
    both = tmp_path / "both.pdf"
    words = [executable("tank_datum_report"), sample_report, "--pdf", both, "--html", both]
    done = subprocess.run(words, capture_output=True, text=True)
    assert (done.returncode, done.stderr.count("\n")) == (2, 1), done.stderr
    assert not both.exists()
