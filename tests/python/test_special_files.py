"""What is no regular file, as every file argument of every program: one line, a status, no wait.

The viewer reads by the same functions, behind a display.
"""

from __future__ import annotations

import os
import socket
from collections.abc import Iterator
from pathlib import Path

import pytest

from conftest import ROOT, run_program
from farm_made import farm_command, require_farm
from qa_command import qa
from report_pages import SAMPLE
from results import Run

WRONG_USE, FILE_FAILED = 2, 3
QUICK = 20.0  # s
LEVELLING = ROOT / "tests" / "data" / "levelling" / "sixteen_stations_inches.csv"

# What stands where a file is expected; {it} is the special one, {out} a place for results.
ARGUMENTS: dict[str, list[str]] = {
    "tank_datum scan": ["{it}", "-o", "{out}"],
    "tank_datum --config": ["{sample}", "-o", "{out}", "--config", "{it}"],
    "tank_datum --config wrong use": ["{sample}", "-o", "{out}", "--k", "x", "--config", "{it}"],
    "tank_datum --baseline": ["{sample}", "-o", "{out}", "--baseline", "{it}"],
    "tank_datum --limits": ["{sample}", "-o", "{out}", "--limits", "{it}"],
    "tank_datum --about": ["{sample}", "-o", "{out}", "--about", "{it}"],
    "tank_datum --about logo": ["{sample}", "-o", "{out}", "--about", "{about}"],
    "tank_datum --setup-origins": ["{sample}", "-o", "{out}", "--setup-origins", "{it}"],
    "tank_datum --stations-csv": ["--stations-csv", "{it}", "--diameter", "15", "-o", "{out}"],
    "tank_datum_compare first": ["{it}", "{result}", "-o", "{out}"],
    "tank_datum_compare second": ["{result}", "{it}", "-o", "{out}"],
    "tank_datum_convert scan": ["{it}", "{out}.pcd"],
    "tank_datum_curves stations": ["{it}"],
    "tank_datum_report folder": ["{it}", "--pdf", "{out}.pdf"],
    "tank_datum_report page": ["{page}", "--pdf", "{out}.pdf"],
    "tank_datum_synth --scene": ["--scene", "{it}", "-o", "{out}.pcd"],
    "tank_datum_bench scan": ["{it}"],
}
KINDS = ["fifo", "/dev/zero", "/dev/full", "/dev/null", "socket", "folder", "loop"]


@pytest.fixture(scope="module")
def made(command: Path, tmp_path_factory: pytest.TempPathFactory) -> Iterator[dict[str, Path]]:
    """One of each kind, by its name; `result` is a folder of results."""
    folder = tmp_path_factory.mktemp("special")
    paths = {kind: Path(kind) if kind[0] == "/" else folder / kind for kind in KINDS}
    os.mkfifo(paths["fifo"])
    paths["folder"].mkdir()
    paths["loop"].symlink_to("loop")
    with socket.socket(socket.AF_UNIX) as bound:
        bound.bind(str(paths["socket"]))
        yield {**paths, "result": command}


def run_with(name: str, made: dict[str, Path], kind: str, tmp_path: Path) -> Run:
    about, page = tmp_path / "about.toml", tmp_path / "page"
    about.write_text(f'logo = "{made[kind]}"\n')
    page.mkdir()
    (page / "report.html").symlink_to(made[kind])
    places = {"it": made[kind], "about": about, "page": page, "out": tmp_path / "out"}
    words = {**places, "sample": SAMPLE, "result": made["result"]}
    return run_program(
        name.split()[0], [w.format(**words) for w in ARGUMENTS[name]], tmp_path, timeout=QUICK
    )


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("name", ARGUMENTS)
def test_one_line_and_a_status(made: dict[str, Path], tmp_path: Path, name: str, kind: str) -> None:
    result = run_with(name, made, kind, tmp_path)
    assert result.returncode == FILE_FAILED, (result.returncode, result.stderr)
    lines = result.stderr.splitlines()
    assert len(lines) == 1, result.stderr
    assert lines[0].startswith(f"{name.split()[0]}: "), lines
    assert ", expected " in lines[0]
    assert not any(tmp_path.glob("out*/*.json"))
    assert not any(path.is_file() for path in tmp_path.glob("out.*"))


@pytest.mark.parametrize("kind", KINDS)
def test_the_farm_refuses_it_as_its_campaign(made: dict[str, Path], kind: str) -> None:
    require_farm()
    result = farm_command("check", made[kind], timeout=QUICK)
    assert result.returncode == WRONG_USE, result.stderr
    assert len(result.stderr.splitlines()) == 1, result.stderr
    assert "expected" in result.stderr


@pytest.mark.parametrize("kind", KINDS)
def test_qa_refuses_it_as_its_cases(made: dict[str, Path], kind: str) -> None:
    result = qa(made[kind], timeout=QUICK)
    assert result.returncode == WRONG_USE, result.stderr
    assert len(result.stderr.splitlines()) == 1, result.stderr
    assert ", expected " in result.stderr


@pytest.mark.parametrize("kind", KINDS)
def test_the_module_refuses_it(made: dict[str, Path], kind: str) -> None:
    tank_datum = pytest.importorskip("tank_datum", reason="the module is not installed")
    for read in (tank_datum.load, tank_datum.simulate, tank_datum.extract_datum, tank_datum.limits):
        with pytest.raises(tank_datum.FileError, match="expected") as refused:
            read(str(made[kind]))
        assert "\n" not in str(refused.value)
