"""At every call to the file system that a run makes it may fail, be killed or be stopped: the old
result or the new one is there, whole, or the next program that looks puts it right and says so.
"""

from __future__ import annotations

import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from conftest import executable
from results import Run
from writers import WRITERS, Writer, snapshot, tanks, under_way

EIO, ENOSPC = 5, 28


def probe(folder: Path, program: str = "tank_datum") -> Run:
    """What every program does to a folder that it is about to read."""
    words = [str(executable("results_probe")), program, str(folder)]
    return subprocess.run(words, capture_output=True, text=True, timeout=60)


@pytest.fixture(scope="module", params=WRITERS, ids=lambda make: make.__name__)
def writer(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Writer:
    """A program and its folder, before and after a run that nothing disturbs."""
    made: Writer = request.param(tmp_path_factory.mktemp("before"))
    out = tmp_path_factory.mktemp("after") / "out"
    made.fresh(out)
    done = made.run(out)
    assert done.returncode == 0, done.stderr
    made.counted = int((out.parent / "count").read_text())
    made.after = snapshot(out)
    assert made.after != snapshot(made.before)
    assert under_way(out) == []
    assert made.counted > 20
    return made


def old_or_new(writer: Writer, out: Path) -> bool:
    return snapshot(out) in (snapshot(writer.before), writer.after)


@pytest.mark.parametrize("error", [EIO, ENOSPC], ids=["EIO", "ENOSPC"])
def test_a_call_that_fails(writer: Writer, tmp_path: Path, error: int) -> None:
    """Status 3, one line, and everything as it was; or 0 and all of the new."""
    out = tmp_path / "out"
    failed = 0
    for call in range(1, writer.counted + 1, 1 if error == EIO else 7):
        writer.fresh(out)
        done = writer.run(out, fail_at=call, fail_with=error)
        if done.returncode == 3:
            failed += 1
            assert snapshot(out) in (snapshot(writer.before), {}), f"call {call}: {done.stderr}"
            assert done.stderr.count("\n") == 1 and ", expected " in done.stderr, done.stderr
        else:
            assert done.returncode == 0, f"call {call}: {done.stderr}"
            assert snapshot(out) == writer.after, f"call {call}"
        if under_way(out):
            assert writer.run(out).returncode == 0
            assert (under_way(out), snapshot(out)) == ([], writer.after), f"call {call}"
    assert failed > writer.counted / (3 if error == EIO else 21)


def test_killed_before_a_call(writer: Writer, tmp_path: Path) -> None:
    """Without help the old or the new result, or a journal by which a reader brings the old one."""
    out = tmp_path / "out"
    put_right = 0
    for call in range(1, writer.counted + 1):
        writer.fresh(out)
        assert writer.run(out, kill_at=call).returncode == -9
        if (out / ".tank_datum-commit" / "journal.json").exists():
            put_right += 1
            read = probe(out)
            assert read.returncode == 0
            assert "those of the run before are back" in read.stderr, read.stderr
            assert snapshot(out) in (snapshot(writer.before), {}), f"call {call}"
        assert old_or_new(writer, out) or snapshot(out) == {}, f"call {call}"
        if call % 3 == 0:
            assert writer.run(out).returncode == 0
            assert (under_way(out), snapshot(out)) == ([], writer.after), f"call {call}"
    assert put_right >= 3


def test_stopped_by_a_signal(writer: Writer, tmp_path: Path) -> None:
    """SIGTERM leaves the old result, or the new one where it was in place already, and no rest."""
    out = tmp_path / "out"
    stopped = 0
    for call in range(1, writer.counted + 1, 5):
        writer.fresh(out)
        done = writer.run(out, stop_at=call)
        if done.returncode in (-15, 128 + 15):
            stopped += 1
            assert "stopped by Terminated" in done.stderr or writer.name == "pictures"
        else:
            assert done.returncode == 0, done.stderr
        assert under_way(out) == []
        assert old_or_new(writer, out) or snapshot(out) == {}, f"call {call}"
    assert stopped > 0


def test_killed_again_while_it_is_put_right(tmp_path: Path) -> None:
    """The journal leads back from wherever putting right was killed."""
    writer = tanks(tmp_path)
    out = tmp_path / "out"
    reader = Writer("reader", ["results_probe", "tank_datum", "{out}"], writer.before)
    writer.fresh(out)
    journal = out / ".tank_datum-commit" / "journal.json"
    seen = 0
    for call in range(1, 200):
        if writer.run(out, kill_at=call).returncode == 0:
            break
        seen += journal.exists()
        if journal.exists() and seen in (8, 16):
            interrupted = tmp_path / "interrupted"
            shutil.copytree(out, interrupted, symlinks=True)
            for again in range(1, 100):
                shutil.rmtree(out)
                shutil.copytree(interrupted, out, symlinks=True)
                killed = reader.run(out, kill_at=again).returncode
                if journal.exists():
                    assert probe(out).returncode == 0
                assert snapshot(out) == snapshot(writer.before), f"calls {call}, {again}"
                if killed == 0:
                    break
            assert again > 10
            shutil.rmtree(interrupted)
        writer.fresh(out)
    assert seen > 16


ROUNDS = 15
PYTHON_WRITER = """
import sys
from pathlib import Path
from tank_datum_qa._result_folder import ResultFolder
with ResultFolder(Path(sys.argv[1]), "pictures") as new:
    (new / "tank.png").write_text(sys.argv[2])
"""


def test_runs_at_the_same_time(tmp_path: Path) -> None:
    """Each commits a whole result, the last one stays; no folder of a living run is removed.

    One run's folder has gone from a name when the next one's gets it: what is removed must be one's
    own. This needs a few rounds to be seen.
    """
    program, out = str(executable("results_probe")), tmp_path / "out"
    names = ("datum.json", "stations.csv", "tank_1/datum.json")
    for turn in range(ROUNDS):
        words = [[program, "tank_datum", out, *(f"{n}={i}" for n in names)] for i in range(12)]
        words += [[sys.executable, "-c", PYTHON_WRITER, out, str(turn)] for _ in range(2)]
        runs = [subprocess.Popen(line) for line in words]
        assert [run.wait(timeout=60) for run in runs] == [0] * len(runs), f"round {turn}"
        assert len({(out / n).read_text() for n in names}) == 1
        assert (out / "tank.png").read_text() == str(turn)
        assert sorted(p.name for p in out.iterdir()) == [
            "datum.json", "manifest.json", "stations.csv", "tank.png", "tank_1",
        ]  # fmt: skip


def test_what_cannot_be_put_right_is_said(tmp_path: Path) -> None:
    """A reader that may not write refuses a result that is not whole."""
    writer = tanks(tmp_path)
    out = tmp_path / "out"
    reader = Writer("reader", ["results_probe", "tank_datum", "{out}"], writer.before)
    interrupted = tmp_path / "interrupted"
    for call in range(1, 200):
        writer.fresh(out)
        writer.run(out, kill_at=call)
        if not (out / "tank_3/datum.json").exists():
            break
    shutil.copytree(out, interrupted, symlinks=True)
    refused = []
    for number in range(1, 15):
        shutil.rmtree(out)
        shutil.copytree(interrupted, out, symlinks=True)
        run = reader.run(out, fail_at=number, fail_with=EIO)
        if run.returncode == 3:
            refused.append(run.stderr)
        assert probe(out).returncode == 0
        assert snapshot(out) == snapshot(writer.before)
    assert all(", expected " in line and line.count("\n") == 1 for line in refused)
    assert sum("results incomplete since a run was stopped" in line for line in refused) >= 5
