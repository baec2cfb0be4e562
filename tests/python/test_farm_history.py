"""The history of a farm in SQLite and PostgreSQL: one row a result, migrations with data in it."""

from __future__ import annotations

import sqlite3
import sys
import threading
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from conftest import ROOT
from farm_made import Farm, require_farm

require_farm()
sys.path.insert(0, str(ROOT / "scripts"))

import farm_postgres  # noqa: E402
from sqlalchemy import create_engine, text  # noqa: E402
from tank_datum.farm import read_campaign  # noqa: E402
from tank_datum.farm.history import History, database_url, open_history  # noqa: E402
from tank_datum.farm.plan import store_url  # noqa: E402
from tank_datum.farm.record import Recorder  # noqa: E402
from tank_datum.farm.status import present_results, state_of  # noqa: E402
from tank_datum.farm.store import Store  # noqa: E402
from tank_datum.farm.task import Row  # noqa: E402

from farm_drawn import drawn_farm  # noqa: E402

TABLES = ("tank", "epoch", "run", "extraction", "input", "result", "station", "setup", "code_check")

MADE: list[str] = []  # databases


@pytest.fixture(scope="module")
def postgres() -> Iterator[str]:
    if farm_postgres.programs() is None:
        pytest.skip("no PostgreSQL server is installed")
    pytest.importorskip("psycopg", reason="the extra postgresql is not installed")
    with farm_postgres.server() as server:
        yield server.url


@pytest.fixture(params=["sqlite", "postgresql"])
def farm(request: pytest.FixtureRequest, tmp_path: Path) -> Farm:
    """Two tanks with two epochs each."""
    database = "history.sqlite"
    if request.param == "postgresql":
        server = request.getfixturevalue("postgres")
        database = f"{server}_{len(MADE)}"
        with create_engine(
            server.replace(":", "+psycopg:", 1), isolation_level="AUTOCOMMIT"
        ).connect() as connection:
            connection.execute(text(f"create database postgres_{len(MADE)}"))
        MADE.append(database)
    return drawn_farm(tmp_path, tanks=2, epochs=2, database=database)


def counts(history: History, names: tuple[str, ...] = TABLES) -> dict[str, int]:
    with history.engine.connect() as connection:
        return {
            name: connection.execute(text(f"select count(*) from {name}")).scalar_one()
            for name in names
        }


def results_of(campaign: Any, history: History) -> list[Any]:
    return present_results(campaign, history, state_of(campaign, history))


def stored_rows(farm: Farm) -> tuple[Any, list[tuple[Any, Row]]]:
    campaign = read_campaign(farm.file)
    store = Store(store_url(campaign))
    rows = []
    for path in sorted(Path(store.root).glob("*/*/row.json")):
        found = store.row(path.parent.name)
        assert found is not None
        row = Row.of(found)
        rows.append((next(s for s in campaign.surveys if s.job == row.job), row))
    return campaign, rows


def test_migrations_go_up_and_down_with_data(farm: Farm) -> None:
    """Movement and a column go and come back; what they do not touch stays."""
    campaign = read_campaign(farm.file)
    assert farm.command("report").returncode == 0
    history = open_history(campaign)
    before = counts(history)
    assert (before["result"], before["station"]) == (4, 4 * 36)
    assert counts(history, ("movement",)) == {"movement": 2}
    history.downgrade("0001")
    assert counts(history) == before
    with pytest.raises(Exception, match="movement"):
        counts(history, ("movement",))
    history.upgrade()
    assert counts(history) == before and counts(history, ("movement",)) == {"movement": 0}
    assert [r.extraction.worker for r in results_of(campaign, history)] == [""] * 4
    assert {r.epoch.kind for r in results_of(campaign, history)} == {"scan"}
    history.downgrade("base")
    with pytest.raises(Exception, match="tank"):
        counts(history)
    history.upgrade()
    assert set(counts(history).values()) == {0}
    history.close()


def test_a_row_that_is_there_is_not_written_twice(farm: Farm) -> None:
    """Also when two clients record the same at the same time."""
    campaign, rows = stored_rows(farm)
    history = open_history(campaign)
    before = counts(history)

    def again() -> None:
        recorder = Recorder(open_history(campaign), campaign, 1)
        for survey, row in rows:
            recorder.offer(survey, row)
        assert recorder.finish(20.0)

    clients = [threading.Thread(target=again) for _ in range(3)]
    for client in clients:
        client.start()
    for client in clients:
        client.join()
    assert counts(history) == before


def test_another_version_stands_beside_the_old_one(farm: Farm) -> None:
    campaign, rows = stored_rows(farm)
    survey, row = rows[0]
    store, history = Store(store_url(campaign)), open_history(campaign)
    datum = store.read(row.key, "tank_1/datum.json")
    made = Row.of(row.to_dict() | {"key": "f" * 40, "version": "9.9"})
    with store.making(made.key) as folder:
        (folder / "tank_1").mkdir()
        (folder / "tank_1/datum.json").write_bytes(datum)
        (folder / "row.json").write_text("{}")
    recorder = Recorder(history, campaign, 1)
    recorder.offer(survey, made)
    assert recorder.waiting == 0
    assert counts(history, ("result", "epoch")) == {"result": 5, "epoch": 4}
    versions = {r.extraction.version for r in results_of(campaign, history)}
    assert "9.9" in versions and len(results_of(campaign, history)) == 4


def forget_results(history: History) -> None:
    with history.engine.begin() as connection:
        for name in ("code_check", "setup", "station", "result", "input", "extraction"):
            connection.execute(text(f"delete from {name}"))


def test_a_locked_database_is_asked_again(tmp_path: Path) -> None:
    """Rows wait while another process writes, and none is lost."""
    farm = drawn_farm(tmp_path, tanks=1, epochs=2)
    campaign, rows = stored_rows(farm)
    history = open_history(campaign)
    forget_results(history)
    lock = sqlite3.connect(tmp_path / "history.sqlite", check_same_thread=False)
    lock.execute("begin immediate")
    recorder = Recorder(history, campaign, 1)
    for survey, row in rows:
        recorder.offer(survey, row)
    assert recorder.waiting == 2 and "locked" in recorder.trouble
    threading.Timer(0.5, lock.rollback).start()
    began = time.monotonic()
    assert recorder.finish(20.0) and time.monotonic() - began < 15
    assert counts(history)["result"] == 2 and recorder.trouble == ""


@pytest.mark.parametrize(
    ("harm", "said"),
    [("no database", "file is not a database"), ("0099", "it is of another version of tank_datum")],
)
def test_a_database_that_is_no_use_is_told_at_once(tmp_path: Path, harm: str, said: str) -> None:
    """Waiting would not mend it."""
    farm = drawn_farm(tmp_path, tanks=1, epochs=1)
    path = tmp_path / "history.sqlite"
    if harm == "0099":
        with sqlite3.connect(path) as database:
            database.execute("update alembic_version set version_num = '0099'")
    else:
        path.write_text(harm)
    began = time.monotonic()
    for command in (["status"], ["report"], ["run", "--database-wait", 60]):
        told = farm.command(*command)
        assert told.returncode == 3 and said in told.stderr
    assert time.monotonic() - began < 30


def test_a_database_that_comes_back_is_waited_for(tmp_path: Path) -> None:
    farm = drawn_farm(tmp_path, tanks=1, epochs=1)
    with sqlite3.connect(tmp_path / "history.sqlite") as database:
        database.execute("update alembic_version set version_num = '0002'")
        database.execute("alter table epoch drop column kind")
    lock = sqlite3.connect(tmp_path / "history.sqlite", check_same_thread=False)
    lock.execute("begin immediate")
    threading.Timer(4.0, lock.rollback).start()
    said = farm.command("run", "--collect", "--database-wait", 60)
    assert said.stdout.count("the database is away") == 1 and "locked" in said.stdout
    assert said.returncode == 3 and said.stdout.endswith("1 left\n")  # the scan was never hashed


def test_a_result_without_its_files_does_not_hold_up_the_others(tmp_path: Path) -> None:
    farm = drawn_farm(tmp_path, tanks=1, epochs=2)
    campaign, rows = stored_rows(farm)
    history = open_history(campaign)
    forget_results(history)
    store = Store(store_url(campaign))
    (Path(store.folder(rows[0][1].key)) / "tank_1/datum.json").unlink()
    recorder = Recorder(history, campaign, 1)
    for survey, row in rows:
        recorder.offer(survey, row)
    assert recorder.waiting == 0 and counts(history)["result"] == 1
    (failure,) = history.failures(campaign.site)
    assert (failure.job, failure.kind) == (rows[0][0].job, "store")


def test_a_database_that_is_not_there_is_told(tmp_path: Path) -> None:
    farm = Farm(tmp_path, head='site = "N"\ndatabase = "postgresql://u@127.0.0.1:1/x"\n')
    farm.tank("T")
    farm.scan("a.pcd", "T", "2020-01-01")
    farm.write()
    assert database_url(read_campaign(farm.file)).startswith("postgresql+psycopg://")
    said = farm.command("status")
    assert said.returncode == 3 and said.stderr.startswith("tank_datum_farm: database: ")
    assert len(said.stderr.splitlines()) == 1
