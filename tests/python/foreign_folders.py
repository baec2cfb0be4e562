"""Folders that hold other people's things, inputs of every kind, and runs of every program."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

import clouds
from programs import ROOT, run_program
from results import Run, write_xyz

TABLE = ROOT / "tests" / "data" / "levelling" / "fourteen_stations.csv"
SCENE = '{"tanks": [{"radius": 2}], "scanner": {"count": 1, "step_deg": 5}}'
Things = dict[str, object]


def things(folder: Path) -> Things:
    """Everything in a folder: bytes of files, targets of links, folders."""
    found: Things = {}
    for path in sorted(folder.rglob("*")):
        name = str(path.relative_to(folder))
        if path.is_symlink():
            found[name] = ("link", os.readlink(path))
        else:
            found[name] = path.read_bytes() if path.is_file() else "folder"
    return found


@pytest.fixture(scope="module")
def inputs(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A scan, one without a tank, and the results of two surveys."""
    folder = tmp_path_factory.mktemp("inputs")
    write_xyz(folder / "tank.pcd", clouds.tank())
    write_xyz(folder / "floor.pcd", clouds.floor())
    (folder / "scene.json").write_text(SCENE)
    for name, rise in (("a", 0.0), ("b", 0.01)):
        rows = "".join(f"{10 * i},{(i % 5) * rise},0.001\n" for i in range(36))
        (folder / f"{name}.csv").write_text("azimuth_deg,elevation,sigma\n" + rows)
        words = ["--stations-csv", folder / f"{name}.csv", "--diameter", 40, "-o", folder / name]
        assert run_program("tank_datum", words).returncode == 0
    assert run_program("tank_datum", [folder / "tank.pcd", "-o", folder / "t"]).returncode == 0
    return folder


@pytest.fixture
def place(tmp_path: Path) -> Path:
    """A folder of somebody else, with names that look like ours."""
    here = tmp_path / "work"
    here.mkdir()
    for name in (
        "tank_7.pcd", "tank_notes.txt", "tank_", ".hidden", ".tank_datum-notes", "report.htm",
        "datum.json.bak", "previous/datum.json", "tank_1/photo.jpg", "tank_2/report.html.old",
        "tank_x/datum.json", "tank_07/datum.json", "results.datum/datum.json", "movement.txt",
        "cloud.svg.txt", "bench_1000000.pcd", "sub/stations.csv", "new/report.html", "lock",
    ):  # fmt: skip
        (here / name).parent.mkdir(exist_ok=True)
        (here / name).write_text(f"mine: {name}")
    archive = tmp_path / "archive"
    archive.mkdir()
    for name in ("datum.json", "stations.csv", "report.html", "manifest.json", "movement.json"):
        (archive / name).write_text(f"archived: {name}")
    (here / "tank_archive").symlink_to("../archive")
    (here / "tank_8").symlink_to("../archive")
    (here / "dangling").symlink_to("nowhere")
    (here / "empty").mkdir()
    return here


def plot(*args: object) -> Run:
    command = [sys.executable, str(ROOT / "scripts" / "plot.py"), *map(str, args)]
    return subprocess.run(command, capture_output=True, text=True, timeout=120)


RUNS: dict[str, tuple[str, list[str], int]] = {
    "a datum": ("tank_datum", ["{in}/tank.pcd", "-o", "."], 0),
    "all tanks": ("tank_datum", ["{in}/tank.pcd", "-o", ".", "--all"], 0),
    "no tank": ("tank_datum", ["{in}/floor.pcd", "-o", "."], 1),
    "refused option": ("tank_datum", ["{in}/tank.pcd", "-o", ".", "--k", "2"], 2),
    "a typing error": ("tank_datum", ["{in}/tank.pcd", "-o", ".", "--kk", "2"], 2),
    "no scan": ("tank_datum", ["{in}/none.pcd", "-o", "."], 3),
    "levelling": ("tank_datum", ["--stations-csv", str(TABLE), "--diameter", "42", "-o", "."], 0),
    "timings": ("tank_datum", ["{in}/tank.pcd", "-o", ".", "--timings", "times.json"], 0),
    "folder through a link": ("tank_datum", ["{in}/tank.pcd", "-o", "../link"], 0),
    "baseline": ("tank_datum", ["{in}/tank.pcd", "-o", ".", "--baseline", "{in}/t"], 0),
    "compare": ("tank_datum_compare", ["{in}/a", "{in}/b", "-o", "."], 0),
    "compare refused": ("tank_datum_compare", ["{in}/a", "{in}/t", "-o", "."], 2),
    "compare nothing": ("tank_datum_compare", ["{in}/a", "{in}/none", "-o", "."], 3),
    "synth": ("tank_datum_synth", ["--scene", "{in}/scene.json", "-o", "made.pcd"], 0),
    "synth split": (
        "tank_datum_synth",
        ["--scene", "{in}/scene.json", "--stations-split", "-o", "made.pcd"],
        0,
    ),
    "synth refused": ("tank_datum_synth", ["-o", "made.pcd", "--radius", "-1"], 2),
    "convert": ("tank_datum_convert", ["{in}/tank.pcd", "made.pcd"], 0),
    "convert refused": ("tank_datum_convert", ["{in}/none.pcd", "made.pcd"], 3),
    "curves": ("tank_datum_curves", ["{in}/t/stations.csv"], 0),
    "plot": ("plot.py", ["{in}/t", "-o", ".", "--formats", "svg"], 0),
    "plot nothing": ("plot.py", ["{in}/none", "-o", "."], 3),
}


def call(program: str, words: list[str], inputs: Path, folder: Path) -> Run:
    args = [word.format(**{"in": inputs}) for word in words]
    if program != "plot.py":
        return run_program(program, args, cwd=folder)
    command = [sys.executable, str(ROOT / "scripts" / "plot.py"), *args]
    return subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=120)
