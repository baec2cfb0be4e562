"""No program removes, replaces or moves what is not its own: a folder full of other people's things
is the same, byte for byte, after every kind of run of every program.
"""

from __future__ import annotations

import os
import shutil
import signal
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

import clouds
from conftest import ROOT, executable, run_program
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


@pytest.mark.parametrize("name", RUNS)
def test_every_kind_of_run(inputs: Path, place: Path, name: str) -> None:
    """Once in a folder of others, and once more over its own results."""
    program, words, status = RUNS[name]
    (place.parent / "link").symlink_to("work")
    before, given = things(place.parent), things(inputs)
    for _ in range(2):
        result = call(program, words, inputs, place)
        assert result.returncode == status, result.stderr
        after = things(place.parent)
        assert {n: after.get(n) for n in before} == before
        assert things(inputs) == given
        assert not any(".tank_datum-" in n for n in after if n not in before)
        if status > 1 or program == "tank_datum_curves":
            assert after == before


def test_runs_of_all_programs_in_one_folder(inputs: Path, place: Path) -> None:
    """One after the other, and the first again: nobody harms another's results."""
    before = things(place)
    for name in ("a datum", "compare", "plot", "synth", "no tank", "levelling"):
        program, words, status = RUNS[name]
        assert call(program, words, inputs, place).returncode == status
    after = things(place)
    assert {n: after.get(n) for n in before} == before
    assert {"datum.json", "movement.json", "made.pcd", "made.truth.json", "elevation.svg"} <= set(
        after
    )


def test_same_name_is_kept_and_said(inputs: Path, place: Path) -> None:
    """datum.json of somebody else, and report.html edited by hand, get another name."""
    (place / "datum.json").write_text('{"datum": "WGS 84"}')
    (place / "manifest.json").write_text('{"name": "a web page"}')
    assert (result := call(*RUNS["a datum"][:2], inputs, place)).returncode == 0
    assert "./datum.json is not of this program: kept as ./datum.kept.json" in result.stderr
    assert (place / "datum.kept.json").read_text() == '{"datum": "WGS 84"}'
    assert (place / "manifest.kept.json").read_text() == '{"name": "a web page"}'
    (place / "report.html").write_text("edited by hand")
    assert (result := call(*RUNS["a datum"][:2], inputs, place)).returncode == 0
    assert "./report.html was changed since it was written: kept as" in result.stderr
    assert (place / "report.kept.html").read_text() == "edited by hand"
    (place / "elevation.svg").write_text("my drawing")
    assert (result := call(*RUNS["plot"][:2], inputs, place)).returncode == 0
    assert (place / "elevation.kept.svg").read_text() == "my drawing"
    (place / "made.pcd").write_bytes((inputs / "tank.pcd").read_bytes())  # a real scan
    assert (result := call(*RUNS["synth"][:2], inputs, place)).returncode == 0
    assert (place / "made.kept.pcd").read_bytes() == (inputs / "tank.pcd").read_bytes()


def test_scan_in_the_output_folder_stays(inputs: Path, tmp_path: Path) -> None:
    """The scan, notes beside it, and other tanks' folders of results."""
    shutil.copy(inputs / "tank.pcd", tmp_path / "tank_7.pcd")
    (tmp_path / "tank_notes.txt").write_text("notes")
    for name in ("tank_1", "tank_2"):
        shutil.copytree(inputs / "t", tmp_path / name)
    before = things(tmp_path)
    assert run_program("tank_datum", ["tank_7.pcd", "-o", "."], cwd=tmp_path).returncode == 0
    after = things(tmp_path)
    assert {n: after.get(n) for n in before} == before


INPUTS_AS_OUTPUTS: list[tuple[str, list[str], str]] = [
    ("tank_datum", ["--stations-csv", "stations.csv", "--diameter", "42", "-o", "."], "levelling"),
    ("tank_datum", ["datum_points.pcd", "-o", "."], "scan"),
    ("tank_datum", ["linked.pcd", "-o", "."], "scan"),
    ("tank_datum", ["hard.pcd", "-o", "."], "scan"),
    ("tank_datum", ["tank.pcd", "-o", "tank.pcd"], "scan"),
    ("tank_datum", ["tank.pcd", "-o", ".", "--limits", "shell.csv"], "limits"),
    ("tank_datum", ["tank.pcd", "-o", ".", "--setup-origins", "shell.csv"], "origins"),
    ("tank_datum", ["tank.pcd", "-o", "out", "--timings", "tank.pcd"], "scan"),
    ("tank_datum", ["tank.pcd", "-o", "out", "--timings", "times.json"], "scan"),
    ("tank_datum", ["tank.pcd", "-o", "base", "--baseline", "base/datum.json"], "baseline"),
    ("tank_datum", ["tank.pcd", "-o", ".", "--baseline", "tank_1"], "baseline"),
    ("tank_datum", ["tank.pcd", "-o", "out", "--config", "opts", "--timings", "opts"], "config"),
    ("tank_datum", ["tank.pcd", "-o", "out", "--timings", "out/datum.json"], "result"),
    ("tank_datum_compare", ["base", "e2", "-o", "e2"], "survey"),
    ("tank_datum_compare", ["base/datum.json", "e2/datum.json", "-o", "e2"], "survey"),
    ("tank_datum_synth", ["--scene", "scene.json", "-o", "scene.json"], "scene"),
    (
        "tank_datum_synth",
        ["--scene", "scene.json", "-o", "s.pcd", "--truth", "scene.json"],
        "scene",
    ),
    ("tank_datum_synth", ["-o", "s.pcd", "--truth", "s.pcd"], "scan"),
    ("tank_datum_bench", ["tank.pcd", "--json", "times.json"], "scan"),
    ("plot.py", ["base", "--scan", "base/cloud.png", "--formats", "png"], "base/cloud.png"),
]


@pytest.mark.parametrize(
    ("program", "words", "said"), INPUTS_AS_OUTPUTS, ids=lambda v: " ".join(v)[:40] if v else ""
)
def test_an_input_is_no_output(
    inputs: Path, tmp_path: Path, program: str, words: list[str], said: str
) -> None:
    """Status 2 and one line that names both, before anything is read; nothing changes."""
    shutil.copy(inputs / "a.csv", tmp_path / "stations.csv")
    shutil.copy(inputs / "scene.json", tmp_path / "scene.json")
    for name in ("tank.pcd", "datum_points.pcd"):
        shutil.copy(inputs / "tank.pcd", tmp_path / name)
    (tmp_path / "linked.pcd").symlink_to("datum_points.pcd")
    (tmp_path / "hard.pcd").hardlink_to(tmp_path / "datum_points.pcd")
    (tmp_path / "times.json").symlink_to("tank.pcd")
    (tmp_path / "shell.csv").write_text("limits")
    (tmp_path / "opts").write_text("k=20\n")
    for name, source in (("base", "t"), ("tank_1", "t"), ("e2", "b")):
        shutil.copytree(inputs / source, tmp_path / name)
    shutil.copy(inputs / "tank.pcd", tmp_path / "base" / "cloud.png")
    before = things(tmp_path)
    result = call(program, words, inputs, tmp_path)
    assert things(tmp_path) == before
    assert result.returncode == 2, result.stderr
    assert result.stderr.count("\n") == 1 and said in result.stderr, result.stderr
    assert result.stdout == ""


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGKILL])
def test_stopped_in_the_middle(inputs: Path, place: Path, number: int) -> None:
    """The earlier result stays as it was, and of the staging folder nothing is left for good."""
    words = [str(executable("tank_datum")), str(inputs / "tank.pcd"), "-o", ".", "--quiet"]
    assert subprocess.run(words, cwd=place).returncode == 0
    before = things(place)
    with subprocess.Popen([*words, "--stations", "180"], cwd=place, stderr=subprocess.PIPE) as run:
        while not list(place.glob(".tank_datum-[0-9]*/lock")) and run.poll() is None:
            pass
        run.send_signal(number)
        run.wait(timeout=60)
    assert run.returncode == -number
    if number != signal.SIGKILL:
        assert things(place) == before
    assert call(*RUNS["no scan"][:2], inputs, place).returncode == 3
    assert things(place) == before


@pytest.fixture
def other_disk(tmp_path: Path) -> Iterator[Path]:
    """A file system of its own."""
    disk = tmp_path / "disk"
    disk.mkdir()
    made = subprocess.run(["mount", "-t", "tmpfs", "tmpfs", str(disk)], capture_output=True)
    if made.returncode != 0:
        yield Path("/dev/shm")
        return
    yield disk
    subprocess.run(["umount", str(disk)], check=True)


def test_folder_on_another_file_system(inputs: Path, other_disk: Path) -> None:
    out = other_disk / f"tank_datum_test_{os.getpid()}"
    out.mkdir()
    (out / "mine.txt").write_text("mine")
    for _ in range(2):
        assert call("tank_datum", ["{in}/tank.pcd", "-o", str(out)], inputs, out).returncode == 0
    assert (out / "mine.txt").read_text() == "mine"
    assert len(list(out.iterdir())) == 9
    shutil.rmtree(out)


@pytest.fixture
def as_nobody(tmp_path: Path) -> Callable[[list[object]], Run]:
    """Runs as a user whom permissions bind."""

    def call_as(words: list[object]) -> Run:
        options: dict[str, object] = {"user": 65534} if os.geteuid() == 0 else {}
        for folder in (tmp_path, *list(tmp_path.parents)[:-1]):
            if os.geteuid() == 0:
                folder.chmod(folder.stat().st_mode | 0o055)
        return subprocess.run(
            [str(w) for w in words], capture_output=True, text=True, timeout=60, **options
        )

    return call_as


@pytest.mark.parametrize("case", ["not listed", "read-only tank_1", "read-only folder"])
def test_folders_that_refuse(
    inputs: Path, tmp_path: Path, as_nobody: Callable[..., Run], case: str
) -> None:
    """One line, status 3, the old result whole."""
    out = tmp_path / "out"
    files = ["tank_1/datum.json=1"] if case == "read-only tank_1" else ["datum.json=1"]
    words = [executable("results_probe"), "tank_datum", out]
    tmp_path.chmod(0o777)
    assert as_nobody([*words, *files]).returncode == 0
    before = things(out)
    refusing = out / "tank_1" if case == "read-only tank_1" else out
    refusing.chmod(0o333 if case == "not listed" else 0o555)
    result = as_nobody([*words, *(f.replace("=1", "=2") for f in files), "stations.csv=2"])
    refusing.chmod(0o755)
    assert result.returncode == 3, result.stderr
    assert result.stderr.count("\n") == 1 and ", expected " in result.stderr
    assert things(out) == before
