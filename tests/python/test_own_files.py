"""No program removes, replaces or moves what is not its own: a folder full of other people's things
is the same, byte for byte, after every kind of run of every program.
"""

from __future__ import annotations

import shutil
import signal
import subprocess
from pathlib import Path

import pytest

from conftest import executable, run_program
from foreign_folders import RUNS, call, things


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
    ("tank_datum_convert", ["tank.pcd", "linked.pcd", "hard.pcd"], "scan"),
    ("tank_datum_bench", ["tank.pcd", "--json", "times.json"], "scan"),
    ("plot.py", ["base", "--scan", "base/cloud.png", "--formats", "png"], "base/cloud.png"),
]


@pytest.mark.parametrize(("program", "words", "said"), INPUTS_AS_OUTPUTS)
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
    for _ in range(20):  # on a busy machine a run may be over before the signal reaches it
        with subprocess.Popen(
            [*words, "--stations", "180"], cwd=place, stderr=subprocess.PIPE
        ) as run:
            while not list(place.glob(".tank_datum-[0-9]*/lock")) and run.poll() is None:
                pass
            run.send_signal(number)
            run.wait(timeout=60)
        if number != signal.SIGKILL and signal.getsignal(number) == signal.SIG_IGN:
            assert run.returncode == 0  # who has it ignored, as nohup does, has the run go on
            return
        if run.returncode != 0:
            break
        assert subprocess.run(words, cwd=place).returncode == 0
        before = things(place)
    assert run.returncode == -number
    if number != signal.SIGKILL:
        assert things(place) == before
    assert call(*RUNS["no scan"][:2], inputs, place).returncode == 3
    assert things(place) == before
