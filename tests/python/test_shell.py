"""The shell above the datum by the command: shell.csv, the section of datum.json, the options."""

from __future__ import annotations

import csv
import json
import re
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from results import Run, read_datum, read_truth

Runner = Callable[..., Run]
Synth = Callable[..., Path]

SCENE = Path(__file__).resolve().parents[1] / "scenes" / "shell20.json"
HEADER = "azimuth_deg,height,radius,deviation,sigma,n,offset"


@pytest.fixture(scope="module")
def scan(synth: Synth) -> Path:
    """20 m wide, leaning and out of round, stairs and nozzles before it, 2.5 mm of noise."""
    return synth(base=[("--scene", SCENE)])


@pytest.fixture(scope="module")
def out(run: Runner, scan: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("shell") / "out"
    result = run(scan, "-o", folder, "--height-step", 1)  # the truth's
    assert result.returncode == 0, result.stderr
    (folder / "stdout").write_text(result.stdout)
    return folder


def rows(folder: Path) -> dict[str, np.ndarray]:
    text = (folder / "shell.csv").read_text()
    assert text.splitlines()[0] == HEADER
    table = list(csv.DictReader(text.splitlines()))
    return {n: np.array([float(row[n] or "nan") for row in table]) for n in HEADER.split(",")}


def test_roundness_is_the_truths(scan: Path, out: Path) -> None:
    """The issue's figure: within 0.3 mm of the truth at every height."""
    found = read_datum(out)["shell"]["roundness"]
    truth = read_truth(scan)["tanks"][0]["shell"]["roundness"]
    assert [r["height"] for r in found] == pytest.approx([r["height"] for r in truth])
    for a, b in zip(found, truth, strict=True):
        assert a["max_deviation"] == pytest.approx(b["max_deviation"], abs=0.0003)
        assert a["min_deviation"] == pytest.approx(b["min_deviation"], abs=0.0003)
        assert a["radius"] == pytest.approx(b["radius"], abs=0.0002)
        assert 0 < a["sigma"] < 0.0003
    assert [r["tolerance"] for r in found] == pytest.approx([0.019] + [0.057] * 8)
    assert {r["verdict"] for r in found} == {"not_applicable"}  # rules for tanks of another service


def test_roundness_is_judged_by_the_rule_of_the_service(
    scan: Path, run: Runner, tmp_path: Path
) -> None:
    result = run(scan, "-o", tmp_path / "out", "--service", "rebuilt", "--no-report")
    assert result.returncode == 0, result.stderr
    found = read_datum(tmp_path / "out")["shell"]["roundness"]
    assert {r["verdict"] for r in found[1:]} == {"pass"}
    assert found[0]["verdict"] == "undecided"  # near to 19 mm
    assert re.search(r"worst at \d+ deg \(tolerance 19 mm: undecided\)", result.stdout)


def test_setups_beside_their_places_are_in_the_sigmas(
    synth: Synth, run: Runner, tmp_path: Path
) -> None:
    """The shell is surveyed as the scan has it: setups 3 mm off are lobes of it."""
    scene = json.loads(SCENE.read_text())
    scene["scanner"]["registration"] = {"sigma_plan": 0.003, "sigma_dz": 0.0005}
    description = tmp_path / "scene.json"
    description.write_text(json.dumps(scene))
    scan = synth(base=[("--scene", description)])
    assert run(scan, "-o", tmp_path / "out", "--height-step", 1).returncode == 0
    found, truth = read_datum(tmp_path / "out"), read_truth(scan)["tanks"][0]
    lobes, round_ = found["shell"]["roundness"], truth["shell"]["roundness"]
    off = [abs(a["max_deviation"] - b["max_deviation"]) for a, b in zip(lobes, round_, strict=True)]
    assert max(off) > 0.001
    assert all(error < 3 * a["sigma"] for error, a in zip(off, lobes, strict=True))
    sigma = found["tank"]["sigma_radius"]
    assert 0.0005 < sigma < 0.004
    assert abs(found["tank"]["radius"] - truth["radius"]) < 3 * sigma


def test_plumbness_is_the_truths(scan: Path, out: Path) -> None:
    """The issue's figure: within 5 % of the truth, the largest offset and the tank's lean."""
    found, truth = read_datum(out)["shell"], read_truth(scan)["tanks"][0]["shell"]
    assert found["plumbness_height"] == pytest.approx(truth["plumbness_height"])
    assert found["plumbness_max"] == pytest.approx(truth["plumbness_max"], rel=0.05)
    assert found["lean"]["slope"] == pytest.approx(truth["lean"]["slope"], rel=0.05)
    assert found["lean"]["direction_deg"] == pytest.approx(truth["lean"]["direction_deg"], abs=3)
    assert len(found["plumbness"]) == 360


def test_csv_is_a_row_per_degree_and_height(out: Path) -> None:
    table = rows(out)
    assert len(table["height"]) > 0.98 * 9 * 360
    assert np.all(np.diff(table["height"]) >= 0)
    assert set(table["azimuth_deg"]) == set(range(360))
    assert np.nanmin(table["sigma"]) > 0
    assert np.all(table["n"] >= 40)
    assert np.all(np.isfinite(table["deviation"]))
    at_foot = {r["azimuth_deg"]: r["offset"] for r in dicts(table) if r["height"] == 0.3}
    assert set(at_foot.values()) == {0.0}


def dicts(table: dict[str, np.ndarray]) -> list[dict[str, float]]:
    return [{n: float(c[i]) for n, c in table.items()} for i in range(len(table["height"]))]


def test_summary_says_the_worst(out: Path) -> None:
    lines = dict(line.split(None, 1) for line in (out / "stdout").read_text().splitlines())
    shell = read_datum(out)["shell"]
    assert f"{1e3 * shell['roundness'][0]['max_deviation']:+.1f} / " in lines["roundness"]
    worst, sigma = 1e3 * shell["plumbness_max"], 1e3 * shell["plumbness_sigma"]
    said = f"{worst:.1f} +- {2 * sigma:.1f} mm (2 sigma) over 8.0 m"
    assert said in lines["plumbness"]
    assert f"leans {1e3 * shell['lean']['offset']:.1f} mm" in lines["plumbness"]


def test_heights(run: Runner, scan: Path, out: Path, tmp_path: Path) -> None:
    """A height of one's own is what it is among others."""
    assert run(scan, "-o", tmp_path / "out", "--heights", "0.5,2.3,7").returncode == 0
    found = read_datum(tmp_path / "out")["shell"]["roundness"]
    assert [r["height"] for r in found] == [0.5, 2.3, 7.0]
    among = read_datum(out)["shell"]["roundness"][2]
    assert found[1]["max_deviation"] == pytest.approx(among["max_deviation"], abs=0.0002)
    assert found[2]["max_deviation"] > found[0]["max_deviation"] + 0.004


def test_heights_are_half_a_metre_apart(run: Runner, scan: Path, tmp_path: Path) -> None:
    assert run(scan, "-o", tmp_path / "out").returncode == 0
    heights = sorted(set(rows(tmp_path / "out")["height"]))
    assert heights == pytest.approx([0.3 + 0.5 * i for i in range(18)])


def test_height_step(run: Runner, scan: Path, tmp_path: Path) -> None:
    assert run(scan, "-o", tmp_path / "out", "--height-step", 2.4).returncode == 0
    assert sorted(set(rows(tmp_path / "out")["height"])) == pytest.approx([0.3, 2.7, 5.1, 7.5])


@pytest.mark.parametrize(
    ("options", "said"),
    [
        (
            ["--heights", "1,0.5"],
            "--heights, 0.5, expected > 0 and <= 100 m and above the one before",
        ),
        (["--heights", "1,two"], "--heights, 1,two, expected H,H,... in metres"),
        (["--height-step", "0"], "--height-step, 0, expected >= 0.1 m"),
    ],
)
def test_refused(run: Runner, synth: Synth, tmp_path: Path, options: list[str], said: str) -> None:
    result = run(synth(), "-o", tmp_path / "out", *options)
    assert result.returncode == 2
    assert said in result.stderr


def test_no_shell_above_the_foot_says_so(run: Runner, synth: Synth, tmp_path: Path) -> None:
    result = run(synth(), "-o", tmp_path / "out", "--heights", "2")  # it ends at one metre
    assert result.returncode == 0
    assert "shell          the scan holds no shell 2 m or more above the datum" in result.stdout
    assert "shell" not in json.loads((tmp_path / "out" / "datum.json").read_text())
    assert (tmp_path / "out" / "shell.csv").read_text() == HEADER + "\n"


def test_courses_that_step_are_no_lean(run: Runner, synth: Synth, tmp_path: Path) -> None:
    """Each course 4 mm thinner: the shell steps in all round, the tank stays upright."""
    scan = synth(near_datum=0, tilt_slope=0, course_step=0.004, max_range=12)
    assert run(scan, "-o", tmp_path / "out", "--heights", "0.3,2.2,2.6").returncode == 0
    shell = read_datum(tmp_path / "out")["shell"]
    radii = [r["radius"] for r in shell["roundness"]]
    assert radii[1] - radii[0] == pytest.approx(0.0, abs=0.0002)
    assert radii[2] - radii[0] == pytest.approx(-0.004, abs=0.0002)
    assert shell["lean"]["offset"] < 0.0003
    assert all(r["max_deviation"] < 0.001 for r in shell["roundness"])
