"""Faults made in a campaign with a real scheduler and workers; scripts/farm_faults.py makes each
of them many times. And what a store and a worker do when a disk or a scan fails."""

from __future__ import annotations

import errno
import os
import random
import sys
from pathlib import Path

import pytest

from conftest import ROOT
from farm_made import Farm, require_farm, rows, scan

require_farm()
sys.path.insert(0, str(ROOT / "scripts"))

import farm_faults  # noqa: E402
import farm_trials  # noqa: E402
from tank_datum.farm import read_campaign  # noqa: E402
from tank_datum.farm.engine import threads_for  # noqa: E402
from tank_datum.farm.sources import Source  # noqa: E402
from tank_datum.farm.store import Store  # noqa: E402
from tank_datum.farm.task import task_of  # noqa: E402
from tank_datum.farm.work import work  # noqa: E402


@pytest.mark.parametrize("fault", ["worker", "client", "scheduler"])
def test_a_fault_loses_nothing_and_doubles_nothing(
    fault: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(farm_trials, "TASKS", 4)
    random.seed(3)
    given = scan(tmp_path / "scan.pcd", seed=1)
    faults, _, wrong = farm_faults.campaigns(fault, given, times=1)
    assert (faults, wrong) == (1, [])


@pytest.fixture
def farm(tmp_path: Path) -> Farm:
    farm = Farm(tmp_path)
    scan(tmp_path / "a.pcd", seed=1)
    farm.tank("T")
    farm.scan("a.pcd", "T", "2020-01-01")
    farm.write()
    return farm


def test_a_store_leaves_nothing_of_a_result_that_failed(tmp_path: Path) -> None:
    store = Store(str(tmp_path))
    with pytest.raises(OSError, match="full"), store.making("ab12") as folder:
        (folder / "row.json").write_text("{}")
        raise OSError(errno.ENOSPC, "full")
    assert store.row("ab12") is None and list((tmp_path / ".parts").iterdir()) == []


def test_of_two_results_of_a_key_the_first_stays(tmp_path: Path) -> None:
    store = Store(str(tmp_path))
    for number in (1, 2):
        with store.making("ab12") as folder:
            (folder / "row.json").write_text(f'{{"number": {number}}}')
    assert store.row("ab12") == {"number": 1} and list((tmp_path / ".parts").iterdir()) == []


def test_what_dead_workers_left_is_swept(tmp_path: Path) -> None:
    store = Store(str(tmp_path))
    host = os.uname().nodename
    for name in (f"{host}.999999999.ab.cd", f"{host}.{os.getpid()}.ab.cd", "other.1.ab.cd"):
        (tmp_path / ".parts" / name).mkdir(parents=True)
    store.sweep()
    left = sorted(path.name for path in (tmp_path / ".parts").iterdir())
    assert left == sorted([f"{host}.{os.getpid()}.ab.cd", "other.1.ab.cd"])


def test_a_store_of_another_file_system(tmp_path: Path) -> None:
    """An object store has no rename: row.json comes last."""
    store = Store("memory://farm")
    with store.making("ab12") as folder:
        (folder / "tank_1").mkdir()
        (folder / "tank_1/datum.json").write_text("{}")
        (folder / "row.json").write_text('{"a": 1}')
    assert store.row("ab12") == {"a": 1} and store.read("ab12", "tank_1/datum.json") == b"{}"
    path = tmp_path / "x"
    path.write_text("content")
    source = Source(str(path), 7, "1")
    assert store.hash_of(source) == store.known_hash(source)
    assert store.known_hash(Source(str(path), 7, "2")) is None


def test_scans_of_another_file_system(farm: Farm) -> None:
    """A memory:// scan is copied to where the worker runs; the key is that of its content."""
    import fsspec

    fsspec.filesystem("memory").pipe_file("/scans/a.pcd", (farm.folder / "a.pcd").read_bytes())
    farm.scan("memory://scans/*.pcd", "T", "2021-01-01")
    farm.write()
    campaign = read_campaign(farm.file)
    first, second = (work(task_of(campaign, survey)) for survey in campaign.surveys)
    assert (first["outcome"], second["outcome"]) == ("ok", "ok")
    assert first["key"] == second["key"]


def test_a_scan_that_goes_away_is_an_io_failure_and_comes_back(farm: Farm) -> None:
    campaign = read_campaign(farm.file)
    task = task_of(campaign, campaign.surveys[0])
    (farm.folder / "a.pcd").rename(farm.folder / "b.pcd")
    row = work(task)
    assert (row["outcome"], row["kind"]) == ("failed", "io")
    assert row["reason"].startswith("No such file or directory: ")
    (farm.folder / "b.pcd").rename(farm.folder / "a.pcd")
    assert work(task)["outcome"] == "ok"


def test_a_failure_is_kept_until_it_ends_well(farm: Farm) -> None:
    (farm.folder / "a.pcd").rename(farm.folder / "b.pcd")
    assert farm.command("run", "--quiet").returncode == 1
    assert rows(farm, "select job, kind from failure") == [("T/2020-01-01", "missing")]
    (farm.folder / "b.pcd").rename(farm.folder / "a.pcd")
    farm.command("run", "--shard", "1/1")
    assert farm.command("run", "--collect").returncode == 0
    assert rows(farm, "select count(*) from failure") == [(0,)]


def test_threads_are_those_of_workers_without_a_task() -> None:
    assert [threads_for(8, left) for left in (1, 2, 3, 8, 100)] == [8, 4, 2, 1, 1]
