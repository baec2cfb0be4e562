"""Scans and results of any name, moved, taken away or cut off; and what a run says at its end."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from conftest import ROOT
from farm_made import Farm, command_line, environment, require_farm, rows, scan

require_farm()
sys.path.insert(0, str(ROOT / "scripts"))

from tank_datum.farm import read_campaign  # noqa: E402
from tank_datum.farm._main import printable  # noqa: E402
from tank_datum.farm.plan import tasks_of  # noqa: E402
from tank_datum.farm.sources import listed  # noqa: E402

SHARD = ("run", "--shard", "1/1")
TWO = "2 done, 0 were there, 0 without a datum, 0 failed, 0 left"


@pytest.fixture(scope="module")
def scans(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("farm_scans")
    for number in (1, 2):
        scan(folder / f"a{number}.pcd", seed=number)
    return folder


@pytest.fixture
def farm(scans: Path, tmp_path: Path) -> Farm:
    """A tank with two scans, in a folder whose name is a pattern."""
    folder = tmp_path / "f [1]"
    shutil.copytree(scans, folder / "scans")
    farm = Farm(folder)
    farm.tank("T", "centre = [0, 0]\nradius = 4")
    for number in (1, 2):
        farm.scan(f"scans/a{number}.pcd", "T", f"{2020 + number}-01-01")
    farm.write()
    return farm


def names_of(farm: Farm, *places: str) -> list[str]:
    return [Path(source.url).name for source in listed(places, farm.folder)]


@pytest.mark.parametrize("name", ["b [2021].pcd", "a::b.pcd", "ünï ✓.pcd", "-o.pcd", "what?.pcd"])
def test_a_file_of_any_name_is_itself(farm: Farm, name: str) -> None:
    (farm.folder / f"scans/{name}").write_text("x")
    assert names_of(farm, f"scans/{name}") == [name]


def test_patterns_give_each_file_once_and_no_folders(farm: Farm) -> None:
    (farm.folder / "scans/a3.pcd").mkdir()
    assert names_of(farm, "scans/a2.pcd", "scans/a?.pcd", "**/*.pcd") == ["a2.pcd", "a1.pcd"]
    with pytest.raises(FileNotFoundError, match="no file of this pattern"):
        names_of(farm, "scans/b*.pcd")


def test_a_link_is_its_target(farm: Farm) -> None:
    """A scan that is another one now has another stamp."""
    (farm.folder / "link.pcd").symlink_to("scans/a1.pcd")
    (before,) = listed(("link.pcd",), farm.folder)
    assert before.size == (farm.folder / "scans/a1.pcd").stat().st_size
    os.utime(farm.folder / "scans/a1.pcd", (1.0, 1.0))
    assert listed(("link.pcd",), farm.folder)[0].stamp != before.stamp


def test_a_moved_campaign_is_done_already(farm: Farm, tmp_path: Path) -> None:
    """Also where an option names a file of it."""
    limits = farm.folder / "limits.toml"
    import tank_datum

    limits.write_text(tank_datum.limits_text())
    farm.head += 'limits = "limits.toml"\n'
    farm.write()
    assert farm.command(*SHARD).returncode == 0
    assert farm.command("run", "--collect").stdout.endswith(f"{TWO}\n")
    moved = Farm(tmp_path / "moved", farm.head, farm.tanks, farm.scans)
    farm.folder.rename(moved.folder)
    assert moved.command("status").stdout.startswith("2 done, 0 no datum")
    assert moved.command("report").returncode == 0


def taken_away(folder: Path) -> None:
    shutil.rmtree(folder)


def without_datum(folder: Path) -> None:
    (folder / "tank_1/datum.json").unlink()


def cut_off(folder: Path) -> None:
    (folder / "row.json").write_text('{"job": "T')


@pytest.mark.parametrize("harm", [taken_away, without_datum, cut_off])
def test_a_result_that_is_lost_is_made_again(farm: Farm, harm: object) -> None:
    """The status says so, the report goes on with the others, and nothing is there twice."""
    farm.command(*SHARD)
    farm.command("run", "--collect")
    key = rows(farm, "select key from extraction where job = 'T/2022-01-01'")[0][0]
    assert callable(harm)
    harm(farm.folder / f"results/{key[:2]}/{key}")
    status = farm.command("status")
    assert "to do     T/2022-01-01  its result is no longer in the store" in status.stdout
    assert farm.command("report").returncode == 0
    page = (farm.folder / "pages/tanks/T.html").read_text()
    assert "to do: 2022-01-01. its result is no longer in the store" in page
    assert farm.command(*SHARD).returncode == 0
    again = farm.command("run", "--collect")
    assert again.stdout.endswith("0 done, 2 were there, 0 without a datum, 0 failed, 0 left\n")
    assert rows(farm, "select count(*) from result") == [(2,)]
    assert farm.command("report").returncode == 0
    assert "no longer" not in (farm.folder / "pages/tanks/T.html").read_text()


def test_a_survey_that_is_taken_out_of_the_campaign_is_not_shown(farm: Farm) -> None:
    """Its epoch is still one of another tank."""
    farm.tank("U", "centre = [0, 0]\nradius = 4")
    farm.scan("scans/a2.pcd", "U", "2022-01-01")
    farm.write()
    farm.command(*SHARD)
    farm.command("run", "--collect")
    del farm.scans[1]
    farm.write()
    assert farm.command("export", "-o", farm.folder / "out").returncode == 0
    view = json.loads((farm.folder / "out/tank_T.json").read_text())
    assert [epoch["epoch"] for epoch in view["epochs"]] == ["2021-01-01"]


def test_a_tanks_own_scan_comes_before_one_of_find(farm: Farm) -> None:
    farm.scan("scans/a1.pcd", "find", "2022-01-01")
    farm.write()
    farm.command(*SHARD)
    farm.command("run", "--collect")
    farm.command("export", "-o", farm.folder / "out")
    surveys = {survey.job: survey for survey in read_campaign(farm.file).surveys}
    (_, own), *_ = [
        (survey, row) for survey, row in _stored(farm) if survey == surveys["T/2022-01-01"]
    ]
    view = json.loads((farm.folder / "out/tank_T.json").read_text())
    assert [epoch["key"] for epoch in view["epochs"]][1] == own


def _stored(farm: Farm) -> list[tuple[object, str]]:
    from tank_datum.farm.plan import known_key, store_url
    from tank_datum.farm.store import Store

    campaign = read_campaign(farm.file)
    store = Store(store_url(campaign))
    return [(s, known_key(store, task) or "") for s, task in tasks_of(campaign)[0]]


def test_a_run_says_nothing_but_its_own(farm: Farm) -> None:
    """No line of the engine's, also when workers end; and a reader may go away."""
    words = command_line("run", farm.file, "--workers", 1)
    done = subprocess.run(words, capture_output=True, text=True, env=environment(), timeout=120)
    assert (done.returncode, done.stderr) == (0, "") and done.stdout.endswith(f"{TWO}\n")
    words = command_line("status", farm.file)
    reader = subprocess.Popen(words, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    assert reader.stdout and reader.stderr
    reader.stdout.close()
    assert reader.stderr.read() == "" and reader.wait(60) == 0


def test_a_scheduler_without_workers_is_told(farm: Farm, monkeypatch: pytest.MonkeyPatch) -> None:
    import farm_trials
    import tank_datum.farm.engine as engine

    monkeypatch.setattr(engine, "ALONE", 1.0)
    port = farm_trials.free_port()
    cluster = farm_trials.Cluster(farm.folder, port)
    cluster.start("scheduler")
    try:
        address = f"tcp://127.0.0.1:{port}"
        said = farm.command("run", "--scheduler", address, "--scheduler-wait", 15)
    finally:
        cluster.end()
    assert said.returncode == 3
    assert "stopped: the scheduler is away: it has no workers" in said.stdout
    assert said.stdout.endswith("2 left\n")


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["--shard", "1/2", "--collect"], "--shard and --collect, expected one of them"),
        (["--memory", "infG"], "--memory: infG, expected bytes as 16G"),
        (["--memory", "x"], "--memory: x, expected bytes as 16G"),
        (["--workers", "0"], "--workers: 0, expected 1 to"),
        (["--database-wait", "nan"], "--database-wait: nan, expected seconds"),
        (["--shard", "3/2"], "--shard: 3/2, expected I/N"),
    ],
)
def test_wrong_words_are_refused(farm: Farm, words: list[str], said: str) -> None:
    done = subprocess.run(command_line("run", farm.file, *words), capture_output=True, text=True)
    assert done.returncode == 2 and said in done.stderr and "Traceback" not in done.stderr


def test_any_terminal_takes_any_name() -> None:
    assert printable("Köln ✓\x1b", "latin-1") == "Köln \\u2713\\x1b"
    assert printable("Köln ✓") == "Köln ✓"
    code = "from tank_datum.farm._main import say; say('\\u2713')"
    said = subprocess.run(
        [sys.executable, "-c", code],
        capture_output=True,
        env=os.environ | {"PYTHONIOENCODING": "ascii"},
    )
    assert (said.returncode, said.stdout) == (0, b"\\u2713\n")
