"""tank_datum_farm run and status: what is extracted, recorded, and not done twice."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from farm_made import Farm, command_line, environment, require_farm, rows, scan

require_farm()


@pytest.fixture(scope="module")
def scans(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("farm_scans")
    scan(folder / "a1.pcd", seed=1)
    scan(folder / "a2.pcd", seed=2, tilt=0.003)
    (folder / "bad.pcd").write_text("nonsense")
    return folder


@pytest.fixture
def farm(scans: Path, tmp_path: Path) -> Farm:
    """One tank with two good scans, one that is none, and one that is not there."""
    (tmp_path / "scans").symlink_to(scans)
    farm = Farm(tmp_path)
    farm.tank("A <i>", "height = 2\ncentre = [0, 0]\nradius = 4")
    for name, date in (
        ("a1", "2021-01-01"),
        ("a2", "2022-01-01"),
        ("bad", "2023-01-01"),
        ("no*", "2024-01-01"),
    ):
        farm.scan(f"scans/{name}.pcd", "A <i>", date)
    farm.write()
    return farm


def test_a_run_extracts_what_is_missing_and_tells_what_failed(farm: Farm) -> None:
    first = farm.command("run", "--workers", 1)
    assert first.returncode == 1, first.stderr
    said = first.stdout.splitlines()
    assert said[-1] == "2 done, 0 were there, 1 without a datum, 1 failed, 0 left"
    assert any(line.startswith("no datum  A <i>/2023-01-01: io: line 1 of") for line in said)
    assert any(
        line.startswith("failed  A <i>/2024-01-01: no file of this pattern: scans/no*.pcd")
        for line in said
    )
    results = rows(
        farm,
        "select epoch.label, status, (select count(*) from station "
        "where result_id = result.id) from result join epoch on epoch.id = epoch_id order by label",
    )
    assert results == [("2021-01-01", "ok", 90), ("2022-01-01", "ok", 90)]
    assert rows(farm, "select count(*) from station") == [(180,)]
    assert rows(farm, "select count(*) from code_check")[0][0] > 20
    assert rows(farm, "select outcome, count(*) from extraction group by outcome order by 1") == [
        ("bad", 1),
        ("ok", 2),
    ]
    assert rows(farm, "select job, kind from failure") == [("A <i>/2024-01-01", "missing")]

    again = farm.command("run", "--quiet")
    assert again.stdout.splitlines()[-1] == (
        "0 done, 2 were there, 1 without a datum, 1 failed, 0 left"
    )
    assert rows(farm, "select count(*) from extraction") == [(3,)]

    status = farm.command("status")
    assert status.returncode == 1
    assert "2 done, 1 no datum, 0 failed, 1 missing, 0 to do" in status.stdout.splitlines()


def test_shards_store_and_a_run_collects(farm: Farm, scans: Path) -> None:
    """Two shards do each task once; a changed option is a new result beside the old one."""
    for number in (1, 2):
        shard = farm.command("run", "--shard", f"{number}/2")
        assert "1 done, 0 were there" in shard.stdout.splitlines()[-1]
    assert not (farm.folder / "history.sqlite").exists()
    collected = farm.command("run", "--collect")
    assert collected.stdout.splitlines()[-1].startswith("2 done, 0 were there, 1 without")
    farm.scans[0] += "options.stations = 72\n"
    farm.write()
    assert farm.command("run", "--collect").stdout.splitlines()[-1].endswith("1 left")
    changed = farm.command("run", "--shard", "1/2")
    assert "1 done" in changed.stdout.splitlines()[-1]
    assert farm.command("run", "--collect").stdout.splitlines()[-1].startswith("1 done, 1 were")
    assert rows(
        farm,
        "select count(*) from station join result on id = result_id where epoch_id = 1 "
        "group by id order by 1",
    ) == [(72,), (90,)]


def test_tanks_are_found_by_their_place(tmp_path: Path) -> None:
    """A scan of "find" gives the site's tank that stands in it, with that tank's options."""
    scan(tmp_path / "far.pcd", seed=3, x=30.0)
    farm = Farm(tmp_path)
    farm.tank("near", "centre = [0, 0]\nradius = 4")
    farm.tank("far", "centre = [30, 0.3]\nradius = 4.2\noptions.stations = 60")
    farm.scan("far.pcd", "find", "2021-01-01")
    farm.scan("far.pcd", "near", "2021-01-01")
    farm.write()
    result = farm.command("run", "--shard", "1/1")
    assert result.returncode == 1
    assert "no datum  near/2021-01-01: the tank found has x, y, radius 30.00, 0.00, 4.00 m, " in (
        result.stdout
    )
    farm.command("run", "--collect")
    found = rows(
        farm,
        "select tank.name, result.status, (select count(*) from station where "
        "result_id = result.id) from result join epoch on epoch.id = epoch_id "
        "join tank on tank.id = tank_id order by 1, 2",
    )
    assert found == [("far", "ok", 60), ("near", "other_tank", 90)]


def test_ctrl_c_stops_soon_and_keeps_what_was_done(farm: Farm) -> None:
    """At the terminal the signal goes to every process of the group."""
    for stations in range(100, 130):
        farm.scan(
            "scans/a1.pcd",
            "A <i>",
            "2021-01-01",
            f'epoch = "{stations}"\noptions.stations = {stations}',
        )
    farm.write()
    words = command_line("run", farm.file, "--workers", 1)
    process = subprocess.Popen(
        words,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        start_new_session=True,
        env=environment(),
    )
    assert process.stdout
    said = []
    while not any(line.startswith("ok") for line in said):
        said.append(process.stdout.readline())
    asked = time.monotonic()
    os.killpg(process.pid, signal.SIGINT)
    out, err = process.communicate(timeout=30)
    assert time.monotonic() - asked < 10
    assert process.returncode == 130 and err == ""
    lines = ("".join(said) + out).splitlines()
    done = sum(line.startswith("ok") for line in lines)
    assert "stopped: interrupted" in lines
    assert rows(farm, "select count(*) from extraction where outcome = 'ok'") == [(done,)]
    assert lines[-1].startswith(f"{done} done") and lines[-1].endswith(f"{33 - done} left")


@pytest.mark.parametrize("package", ["sqlalchemy", "fsspec"])
def test_without_the_extra_it_is_named(tmp_path: Path, package: str) -> None:
    code = (
        f"import sys; sys.modules['{package}'] = None; "
        "from tank_datum.farm._main import main; sys.exit(main(['status', 'x.toml']))"
    )
    (tmp_path / "x.toml").write_text(
        'site="a"\n[[tank]]\nname="a"\n[[scan]]\nfiles="a"\ntank="a"\ndate=2021-01-01\n'
    )
    result = subprocess.run(
        [sys.executable, "-c", code], cwd=tmp_path, capture_output=True, text=True, timeout=60
    )
    assert result.returncode == 2 and "pip install 'tank_datum[farm]'" in result.stderr
