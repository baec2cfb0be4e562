"""Levelling surveys as epochs of a tank, beside its scans."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

import pytest

from farm_made import Farm, require_farm, rows, scan

require_farm()

from tank_datum.farm.campaign import FarmTank, Limits, Survey  # noqa: E402
from tank_datum.farm.heights import datum_of  # noqa: E402
from tank_datum.farm.over_time import EpochDatum, history_of  # noqa: E402

TILT = 0.002  # of the simulated tank [m/m]


def table(path: Path, lift: float, sigma: float | None = None, stations: int = 16) -> Path:
    """Elevations of a tank of 4 m radius."""
    lines = ["azimuth_deg,elevation" + (",sigma" if sigma else "")]
    for number in range(stations):
        azimuth = 360.0 * number / stations
        z = lift + 4.0 * TILT * math.cos(math.radians(azimuth))
        lines.append(f"{azimuth},{z:.6f}" + (f",{sigma}" if sigma else ""))
    path.write_text("\n".join(lines) + "\n")
    return path


def levelling(file: str, year: int, more: str) -> str:
    return f'[[levelling]]\nfile = "{file}"\ntank = "T"\ndate = {year}-01-01\n{more}\n'


@pytest.fixture
def farm(tmp_path: Path) -> Farm:
    """Levelled 30 mm above the datum, then scanned; between them the tank sank 4 mm."""
    table(tmp_path / "old.csv", 0.034)
    table(tmp_path / "older.csv", 0.034, sigma=0.0003)
    scan(tmp_path / "a.pcd", seed=1, tilt=TILT)
    farm = Farm(tmp_path, head='site = "North"\n[options]\nstations = 360\n')
    farm.tank("T", "radius = 4")
    farm.scans.append(levelling("older.csv", 1990, "above_datum = 0.030"))
    farm.scans.append(levelling("old.csv", 2000, "above_datum = 0.030\nelevation_error = 0.0003"))
    farm.scan("a.pcd", "T", "2010-01-01", "registration_error = 0.0002")
    farm.write()
    return farm


def test_levellings_and_scans_are_one_history(farm: Farm) -> None:
    assert farm.command("run", "--shard", "1/1").returncode == 0
    farm.command("run", "--collect")
    kinds = "select label, kind, status from epoch join result on epoch.id = epoch_id order by 1"
    assert [(kind, status) for _, kind, status in rows(farm, kinds)] == [
        ("levelling", "ok"),
        ("levelling", "ok"),
        ("scan", "ok"),
    ]
    assert farm.command("export", "-o", farm.folder / "out").returncode == 0
    view = json.loads((farm.folder / "out/tank_T.json").read_text())
    assert view["notes"] == [] and [e["kind"] for e in view["epochs"]][0] == "levelling"
    settled = [change["settlement"] for change in view["changes"][1:]]
    assert settled == pytest.approx([0.0, 0.004], abs=2e-4)
    sigma = math.hypot(0.0003 * math.sqrt(2 / 16), 0.0002)  # the largest registration error of all
    assert view["changes"][1]["sigma_settlement"] == pytest.approx(sigma, rel=0.02)
    again = farm.command("run", "--collect")
    assert again.stdout.endswith("0 done, 3 were there, 0 without a datum, 0 failed, 0 left\n")
    assert farm.command("report").returncode == 0
    assert "levelling" in (farm.folder / "pages/tanks/T.html").read_text()


def test_a_table_that_is_none_is_a_row_with_its_reason(farm: Farm) -> None:
    (farm.folder / "old.csv").write_text("a;b\n1;2\n")
    said = farm.command("run", "--shard", "1/1")
    assert said.returncode == 1 and "old.csv line 1" in said.stdout


def test_a_diameter_is_part_of_the_key(farm: Farm) -> None:
    farm.command("run", "--shard", "1/1")
    farm.tanks[0] = farm.tanks[0].replace("radius = 4", "radius = 4.01")
    farm.write()
    farm.command("run", "--shard", "1/1")
    farm.command("run", "--collect")
    assert len(list((farm.folder / "results").glob("??/*/row.json"))) == 5


def drawn(path: Path, year: int, lift: float, given: dict[str, Any]) -> EpochDatum:
    import tank_datum

    datum = tank_datum.read_levelling(table(path, lift), 8.0)
    survey = Survey(("s",), "T", f"{year}-01-01", str(year), levelled=True, **given)
    return EpochDatum(survey, datum_of(json.dumps(datum.to_dict()), str(year)), year)


def scanned(year: int) -> EpochDatum:
    from farm_drawn import base

    record = json.loads(json.dumps(base()))
    survey = Survey(("s",), "T", f"{year}-01-01", str(year))
    return EpochDatum(survey, datum_of(json.dumps(record), str(year)), year)


def test_without_the_rods_height_only_the_shape_is_compared(tmp_path: Path) -> None:
    """36 stations of the scan stand at every fourth of 9 of the levelling."""
    import tank_datum

    known = {"elevation_error": 0.0003}
    datum = tank_datum.read_levelling(table(tmp_path / "a.csv", 0.034, stations=9), 8.0)
    first = drawn(tmp_path / "b.csv", 2000, 0.034, known)
    first = EpochDatum(first.survey, datum_of(json.dumps(datum.to_dict()), "2000"), 1)
    history = history_of(FarmTank("T"), [first, scanned(2010)], Limits())
    assert "the mean is taken out" in " ".join(history.notes)
    assert history.changes[-1].settlement is None and history.changes[-1].tilt is not None
    levelled = [
        drawn(tmp_path / "c.csv", y, 0.034 - 1e-4 * (y - 2000), known) for y in (2000, 2010)
    ]
    both = history_of(FarmTank("T"), levelled, Limits())
    assert both.notes == () and both.changes[-1].settlement == pytest.approx(0.001, abs=1e-6)


def test_a_levelling_without_errors_is_left_out_and_the_others_stay(tmp_path: Path) -> None:
    epochs = [
        drawn(tmp_path / "t.csv", 2000, 0.0, {}),
        drawn(tmp_path / "t.csv", 2005, 0.0, {"elevation_error": 0.0005}),
        drawn(tmp_path / "t.csv", 2010, -0.002, {"elevation_error": 0.0005}),
    ]
    history = history_of(FarmTank("T"), epochs, Limits())
    assert [change.epoch for change in history.changes] == ["2005", "2010"]
    assert history.notes[0].startswith("2000: a levelling without standard errors")


def test_a_first_epoch_that_fits_no_other_is_named_and_left_out() -> None:
    strange = scanned(2000)
    record = strange.datum.to_dict()
    record["tank"]["radius"] += 1.0
    strange = EpochDatum(strange.survey, datum_of(json.dumps(record), "2000"), 1)
    history = history_of(FarmTank("T"), [strange, scanned(2005), scanned(2010)], Limits())
    assert [change.epoch for change in history.changes] == ["2005", "2010"]
    assert "2000: movement: radius" in history.notes[0]


def test_a_hydrotest_of_levellings_alone_has_pages(tmp_path: Path) -> None:
    """Nobody knows where the tank stands, so the map has none."""
    table(tmp_path / "empty.csv", 0.030)
    table(tmp_path / "full.csv", 0.025)
    farm = Farm(tmp_path, head='site = "North"\n')
    farm.tank("T", "radius = 4")
    for day, (file, level) in enumerate((("empty", 0), ("full", 10), ("empty", 0)), start=1):
        more = f'fill_level = {level}\nhydrotest = "h"\nelevation_error = 0.0005'
        text = levelling(f"{file}.csv", 2020, more)
        farm.scans.append(text.replace("2020-01-01", f"2020-01-0{day}"))
    farm.write()
    assert farm.command("run", "--shard", "1/1").returncode == 0
    assert farm.command("run", "--collect").returncode == 0
    assert farm.command("report").returncode == 0
    assert "No tank has a known centre." in (tmp_path / "pages/index.html").read_text()
    assert farm.command("export", "-o", tmp_path / "out").returncode == 0
    (test,) = json.loads((tmp_path / "out/tank_T.json").read_text())["hydrotests"]
    assert test["per_metre"]["value"] == pytest.approx(0.0005)
    assert test["lasting"]["value"] == 0.0
    assert ",-0.0," not in (tmp_path / "out/hydrotests.csv").read_text()
