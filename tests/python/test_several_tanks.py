"""Scans of several tanks: --all, --pick, and a baseline for one of them."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from report_pages import opened
from results import RESULTS, Run, read_datum, read_points
from results import write_xyz as write

Runner = Callable[..., Run]
Synth = Callable[..., Path]


@pytest.fixture(scope="module")
def two_tanks(synth: Synth, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The tank whole, and another 20 m east and 1 m higher of which 200 degrees are seen."""
    first = read_points(synth())
    other = read_points(synth(radius=3, seed=2, tilt_slope=0))
    azimuth = np.degrees(np.arctan2(other[:, 1], other[:, 0])) % 360.0
    other = other[azimuth < 200.0] + (20.0, 0.0, 1.0)
    return write(tmp_path_factory.mktemp("two") / "two.pcd", np.vstack([first, other]))


def test_all(run: Runner, two_tanks: Path, tmp_path: Path) -> None:
    """A folder for each, the one most of which is seen first, and a page that leads to them."""
    result = run(two_tanks, "-o", tmp_path, "--all")
    assert result.returncode == 0, result.stderr
    assert sorted(p.name for p in tmp_path.iterdir()) == [
        "index.html",
        "manifest.json",
        "tank_1",
        "tank_2",
    ]
    assert result.stdout.splitlines()[-1].split() == ["index", str(tmp_path / "index.html")]
    circles = [read_datum(tmp_path / n)["tank"] for n in ("tank_1", "tank_2")]
    assert [c["radius"] for c in circles] == pytest.approx([4.0, 3.0], abs=0.001)
    assert [c["center"][0] for c in circles] == pytest.approx([0.0, 20.0], abs=0.001)
    means = [read_datum(tmp_path / n)["datum"]["mean"] for n in ("tank_1", "tank_2")]
    assert means == pytest.approx([0.0, 1.0], abs=0.006)
    for folder in tmp_path.glob("tank_*"):
        assert sorted(p.name for p in folder.iterdir()) == sorted(RESULTS)


def test_each_has_its_own_name(run: Runner, two_tanks: Path, tmp_path: Path) -> None:
    """What is said of all makes no one tank of them; of the one picked it is as it was said."""
    (tmp_path / "about.toml").write_text('tank = "T-12"\nsite = "North"\n')
    about = ("--about", tmp_path / "about.toml")
    run(two_tanks, "-o", tmp_path / "all", "--all", *about)
    told = [read_datum(tmp_path / "all" / n)["about"] for n in ("tank_1", "tank_2")]
    assert told == [{"tank": f"T-12, tank_{n}", "site": "North"} for n in (1, 2)]
    run(two_tanks, "-o", tmp_path / "one", "--no-report", *about)
    assert read_datum(tmp_path / "one")["about"]["tank"] == "T-12"


@pytest.mark.parametrize(("pick", "radius"), [(1, 4.0), (2, 3.0)])
def test_pick(run: Runner, two_tanks: Path, tmp_path: Path, pick: int, radius: float) -> None:
    assert run(two_tanks, "-o", tmp_path / "out", "--pick", pick).returncode == 0
    assert read_datum(tmp_path / "out")["tank"]["radius"] == pytest.approx(radius, abs=0.001)


def test_pick_beyond_the_last(run: Runner, two_tanks: Path, tmp_path: Path) -> None:
    result = run(two_tanks, "-o", tmp_path / "out", "--pick", 3)
    assert result.returncode == 1
    datum = read_datum(tmp_path / "out")
    assert datum["status"] == "no_tank"
    assert datum["message"] == "only 2 found, no tank 3 to pick"
    assert any(datum["input"]["origin"])
    assert datum["input"]["files"][0]["points"] > 10_000


def test_all_of_one_tank(run: Runner, synth: Synth, tmp_path: Path) -> None:
    assert run(synth(), "-o", tmp_path / "one").returncode == 0
    assert run(synth(), "-o", tmp_path / "all", "--all").returncode == 0
    for name in RESULTS:
        one = (tmp_path / "one" / name).read_bytes()
        assert (tmp_path / "all" / "tank_1" / name).read_bytes() == one
    assert (tmp_path / "all" / "index.html").exists()
    assert run(synth(), "-o", tmp_path / "all").returncode == 0
    assert not (tmp_path / "all" / "index.html").exists()


def test_the_index_leads_to_every_tank(
    run: Runner, browser: Any, two_tanks: Path, tmp_path: Path
) -> None:
    assert run(two_tanks, "-o", tmp_path, "--all").returncode == 0
    with opened(browser, tmp_path / "index.html") as page:
        assert page.slips() == []
        assert page.text("#title") == "Storage tanks of a scan"
        rows = [row.locator("td").all_inner_texts() for row in page.page.locator("tbody tr").all()]
        for i, row in enumerate(rows, 1):
            datum = read_datum(tmp_path / f"tank_{i}")
            assert row[0].strip() == f"tank {i}"
            assert row[1].strip() == datum["verdict"]["word"]
            assert row[2].strip() == datum["verdict"]["sentence"]
            assert f"{datum['tank']['radius']:.3f}" in row[5]
            kinds = ("measured", "interpolated", "missing")
            assert row[7].strip() == ", ".join(f"{datum['datum'][k]} {k}" for k in kinds)
        assert len(rows) == 2
        circles = page.page.locator("#index-chart circle")
        assert circles.count() == 2
        radii = [float(c.get_attribute("r")) for c in circles.all()]
        assert radii[0] / radii[1] == pytest.approx(4 / 3, rel=1e-3)
        page.page.locator("tbody a").nth(1).click()
        assert page.text("#title") == "Datum of a storage tank"
        assert page.errors == []


def test_the_index_leads_to_numbers_where_there_is_no_page(
    run: Runner, two_tanks: Path, tmp_path: Path
) -> None:
    assert run(two_tanks, "-o", tmp_path, "--all", "--no-report").returncode == 0
    index = (tmp_path / "index.html").read_text()
    assert "tank_2/datum.json" in index and "tank_2/report.html" not in index


def test_all_with_a_baseline_of_one(run: Runner, two_tanks: Path, tmp_path: Path) -> None:
    """The baseline's tank has a movement; the other says why it has none."""
    assert run(two_tanks, "-o", tmp_path / "a", "--pick", 2).returncode == 0
    result = run(two_tanks, "-o", tmp_path / "b", "--all", "--baseline", tmp_path / "a")
    assert result.returncode == 0, result.stderr
    assert "no movement: movement: radius of this survey" in result.stderr
    first, second = (read_datum(tmp_path / "b" / n) for n in ("tank_1", "tank_2"))
    assert first["status"] == "ok"
    assert first["movement"]["stations"] == [] and "radius" in first["movement"]["message"]
    assert second["movement"]["message"] == ""
    assert second["movement"]["rms"] == pytest.approx(0.0, abs=1e-12)
    result = run(
        two_tanks, "-o", tmp_path / "c", "--baseline", tmp_path / "a"
    )  # the best seen is the other
    assert result.returncode == 2
    assert list((tmp_path / "c").iterdir()) == [] if (tmp_path / "c").exists() else True
