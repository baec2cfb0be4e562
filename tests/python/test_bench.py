"""tank_datum_bench: what it measures is there, and means what it says. How fast is no test."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from conftest import ROOT, run_program
from results import Run, write_xyz

SAMPLE = ROOT / "tests" / "data" / "sample.pcd"


def bench(*args: object) -> Run:
    return run_program("tank_datum_bench", ["--repeats", 1, *args])


def figures(folder: Path, *args: object) -> dict[str, Any]:
    done = bench(SAMPLE, "--json", folder / "figures.json", *args)
    assert done.returncode == 0, done.stderr
    found: dict[str, Any] = json.loads((folder / "figures.json").read_text())
    return found


def test_chains_beside_each_other(tmp_path: Path) -> None:
    found = figures(tmp_path)
    assert [run["chain"] for run in found["ring"]] == ["stock PCL", "own, flann", "own, buckets"]
    assert [run["chain"] for run in found["whole"]] == ["stock PCL", "tank_datum"]
    assert list(found["ring"][0]["stages"]) == ["kd-tree", "normals", "angles"]
    assert "crop" in found["whole"][1]["stages"]
    assert found["same_candidates"] is True
    for runs in (found["ring"], found["whole"]):
        assert runs[0]["ratio"] == 1.0
        assert len({run["points"] for run in runs}) == 1
        for run in runs:
            total, stages = run["total"], run["stages"].values()
            assert total["seconds"] == pytest.approx(sum(s["seconds"] for s in stages))
            assert total["peak_memory_bytes"] == max(s["peak_memory_bytes"] for s in stages) > 1e6
            assert run["points_per_second"] == pytest.approx(run["points"] / total["seconds"])


def test_stages_beside_what_memory_gives(tmp_path: Path) -> None:
    found = figures(tmp_path)
    stages = {stage["stage"]: stage for stage in found["stages"]}
    assert list(stages)[:-1] == list(found["whole"][1]["stages"])
    assert list(stages)[-1] == "report"
    assert stages["locate"]["points"] == stages["crop"]["points"] == found["whole"][1]["points"]
    assert stages["normals"]["points"] == found["ring"][0]["points"]
    assert stages["centre_filter"]["points"] == found["ring"][1]["candidates"]
    assert stages["checks"]["points"] == stages["report"]["points"] == 360
    row = SAMPLE.stat().st_size / stages["locate"]["points"]
    assert stages["locate"]["bytes_per_point"] == pytest.approx(row + 24)
    assert stages["normals"]["bytes_per_point"] == 24 + 20 * 4 + 12
    assert stages["report"]["bytes_per_point"] * 360 > 100_000
    memory = found["memory_bytes_per_second"]
    for name, stage in stages.items():
        for threads in ("one_thread", "two_threads"):
            speed = stage[threads]
            if name in ("open", "hash"):
                assert stage["points"] == 0
                assert speed["ns_per_point"] is speed["bandwidth_share"] is None
                continue
            best = max(memory[work][threads] for work in ("read", "copy"))
            assert best > 1e8
            moved = stage["points"] * stage["bytes_per_point"]
            assert speed["ns_per_point"] == pytest.approx(1e9 * speed["seconds"] / stage["points"])
            assert speed["bandwidth_share"] == pytest.approx(moved / speed["seconds"] / best)
        seconds = stage["one_thread"]["seconds"] / stage["two_threads"]["seconds"]
        assert stage["ratio"] == pytest.approx(seconds)
    wider = figures(tmp_path, "--k", 40)["stages"]
    assert wider[4]["bytes_per_point"] == 24 + 40 * 4 + 12


def test_both_chains_take_k_and_theta(tmp_path: Path) -> None:
    def marked(*options: object) -> set[int]:
        ring = figures(tmp_path, *options)["ring"]
        assert max(run["candidates_not_both"] for run in ring) <= 0.001 * ring[0]["candidates"]
        return {run["candidates"] for run in ring}

    usual, wide, coarse = marked(), marked("--k", 40), marked("--angle-deg", 60)
    assert min(wide) > max(usual) > max(coarse)


def test_larger_scans_are_made_run_and_removed(tmp_path: Path) -> None:
    folder = tmp_path / "scans"
    folder.mkdir()
    (folder / "bench_10000.pcd").write_text("mine")
    sizes = ("--scale", "--smallest", 0.01, "--largest", 0.1, "--folder", folder)
    growth = figures(tmp_path, *sizes)["growth"]
    assert [run["points"] for run in growth] == [10_000, 100_000]
    assert all(run["bytes"] == pytest.approx(12 * run["points"], rel=0.05) for run in growth)
    assert all(run["measured"] > 100 and run["read_seconds"] > 0 for run in growth)
    assert growth[-1]["largest_difference_in_sigmas"] == 0.0
    assert 0.0 < growth[0]["largest_difference_in_sigmas"] < 6.0
    assert [(p.name, p.read_text()) for p in folder.iterdir()] == [("bench_10000.pcd", "mine")]


def test_the_stock_chain_is_left_out_on_request(tmp_path: Path) -> None:
    assert [run["chain"] for run in figures(tmp_path, "--stock-points", 1000)["whole"]] == [
        "tank_datum"
    ]


def test_tables() -> None:
    done = bench(SAMPLE)
    for words in (
        "stage",
        "peak MB",
        "stock PCL over own, buckets:",
        ": the same",
        "the whole scan",
        "memory, one and two threads: read",
        "ns each",
        "1 over 2",
        "\nreport ",
    ):
        assert words in done.stdout


@pytest.mark.parametrize(
    ("args", "status", "words"),
    [
        (["none.pcd"], 3, "none.pcd"),
        ([SAMPLE, "--k=2"], 2, "--k"),
        ([SAMPLE, "--repeats=0"], 2, "--repeats"),
        ([SAMPLE, "--angle-deg=90"], 2, "--angle-deg"),
        ([SAMPLE, "--scale", "--smallest=0"], 2, "--smallest"),
        ([SAMPLE, "--smallest=1"], 2, "--smallest requires --scale"),
        ([SAMPLE, "--json=/none/figures.json"], 2, "/none is no folder"),
        ([SAMPLE, "--scale", "--folder=/none"], 2, "/none"),
    ],
)
def test_refusals(args: list[object], status: int, words: str) -> None:
    done = bench(*args)
    assert done.returncode == status
    assert words in done.stderr
    assert len(done.stderr.splitlines()) == 1


def test_a_scan_without_a_tank(tmp_path: Path) -> None:
    ground = np.random.default_rng(1).uniform([-20, -20, 0], [20, 20, 0.01], (50_000, 3))
    done = bench(write_xyz(tmp_path / "ground.pcd", ground))
    assert done.returncode == 3
    assert "no tank" in done.stderr
