"""SIGINT and SIGTERM at random moments: nothing is left of the run but a whole result, or none.

Calls to the file system, each with a signal at it, are in test_commit.py; here are whole runs.
"""

from __future__ import annotations

import fcntl
import os
import random
import shutil
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import pytest

from conftest import ROOT, executable

TABLE = ROOT / "tests" / "data" / "levelling" / "fourteen_stations.csv"
SIGNALS = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)
OTHERS = (signal.SIGQUIT, signal.SIGALRM, signal.SIGXCPU)
MOMENTS = 8


@dataclass
class Place:
    """A folder to run in, with a folder for what is temporary."""

    folder: Path

    def fresh(self) -> None:
        shutil.rmtree(self.folder, ignore_errors=True)
        (self.folder / "tmp").mkdir(parents=True)

    def start(self, words: list[object]) -> subprocess.Popen[str]:
        return subprocess.Popen(
            [str(word) for word in words],
            cwd=self.folder,
            env=os.environ | {"TMPDIR": str(self.folder / "tmp")},
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            preexec_fn=default_signals,
        )

    def left(self) -> list[str]:
        """What is neither a result nor where one was asked for."""
        found = [p.relative_to(self.folder) for p in self.folder.rglob("*")]
        hidden = [str(p) for p in found if any(part.startswith(".") for part in p.parts)]
        return hidden + [str(p) for p in found if p.parts[0] == "tmp" and len(p.parts) > 1]


def default_signals() -> None:
    """A test run in the background may ignore SIGINT, and its children with it."""
    for number in SIGNALS:
        signal.signal(number, signal.SIG_DFL)


def cases_file(folder: Path) -> Path:
    """Cases of tank_datum_qa that take a while."""
    case = '[[case]]\nname = "{}"\ncommand = "levelling"\ninputs = ["table.csv"]\n'
    case += 'options = ["--diameter", "42"]\n'
    shutil.copyfile(TABLE, folder / "table.csv")
    (folder / "cases.toml").write_text("".join(case.format(i) for i in range(6)))
    return folder / "cases.toml"


def programs(inputs: Path) -> dict[str, list[object]]:
    """The commands, each as it is run in a folder of its own."""
    first, second = inputs / "first", inputs / "second"
    rows = TABLE.read_text().splitlines()
    heading = next(i for i, row in enumerate(rows) if row.startswith("azimuth_deg"))
    known = [
        row + (",sigma" if i == heading else ",0.001")
        for i, row in enumerate(rows[heading:], heading)
    ]
    (inputs / "known.csv").write_text("\n".join(known) + "\n")
    options = ("--stations-csv", inputs / "known.csv", "--diameter", 42, "--quiet")
    for epoch in (first, second):
        words = [executable("tank_datum"), *options, "-o", epoch]
        subprocess.run([str(word) for word in words], check=True)
    scan = inputs / "scan.pcd"
    small = "--radius 3 --scanners 2 --step-deg 0.6 --quiet".split()
    synth = [executable("tank_datum_synth"), *small, "-o"]
    subprocess.run([*map(str, synth), str(scan)], check=True)
    qa = [sys.executable, ROOT / "scripts" / "qa.py", cases_file(inputs)]
    return {
        "extract": [executable("tank_datum"), scan, "-o", "out", "--timings", "t.json"],
        "compare": [executable("tank_datum_compare"), first, second, "-o", "out"],
        "convert": [executable("tank_datum_convert"), scan, "copy.pcd"],
        "synth": [*synth, "scan.pcd"],
        "qa": [*qa, "--command", executable("tank_datum")],
    }


@pytest.fixture(scope="module")
def words(tmp_path_factory: pytest.TempPathFactory) -> dict[str, list[object]]:
    return programs(tmp_path_factory.mktemp("inputs"))


def stop_at_random(place: Place, words: list[object], whole: Callable[[], bool]) -> int:
    """Runs stopped at random moments; how many were. `whole`: of a run that ended itself."""
    place.fresh()
    began = time.monotonic()
    place.start(words).communicate(timeout=300)
    lasts = time.monotonic() - began
    chance = random.Random(18)
    stopped = 0
    for _ in range(MOMENTS):
        place.fresh()
        process = place.start(words)
        moment = chance.uniform(0.0, lasts)
        time.sleep(moment)
        number = chance.choice(SIGNALS)
        process.send_signal(number)
        _, said = process.communicate(timeout=300)
        ended = process.returncode in (-number, 128 + number)
        stopped += ended
        assert place.left() == [], f"{number.name}: {process.returncode} {said}"
        assert ended or whole(), f"{number.name}: {process.returncode} {said}"
        if not ended:
            lasts = moment  # the first run was slower
    return stopped


@pytest.mark.parametrize("name", ["extract", "compare", "convert", "synth", "qa"])
def test_a_program_leaves_nothing(
    words: dict[str, list[object]], tmp_path: Path, name: str
) -> None:
    place = Place(tmp_path / "run")
    result = {"extract": "out/datum.json", "compare": "out/movement.json"}
    result |= {"convert": "copy.pcd", "synth": "scan.pcd", "qa": "tmp"}
    stopped = stop_at_random(place, words[name], (place.folder / result[name]).exists)
    assert stopped > 0


@pytest.mark.parametrize("number", OTHERS, ids=[number.name for number in OTHERS])
def test_signals_that_are_rarer_leave_nothing(
    words: dict[str, list[object]], tmp_path: Path, number: signal.Signals
) -> None:
    place = Place(tmp_path / "run")
    if (
        signal.getsignal(number) is signal.SIG_IGN
    ):  # of a job in the background: runs would inherit it
        signal.signal(number, signal.SIG_DFL)
    for _ in range(3):
        place.fresh()
        process = place.start(words["extract"])
        until = time.monotonic() + 60
        while not place.left() and process.poll() is None and time.monotonic() < until:
            time.sleep(0.001)
        process.send_signal(number)
        _, said = process.communicate(timeout=300)
        assert place.left() == []
        if process.returncode == -number:
            assert said.startswith("tank_datum: stopped by ") and said.count("\n") == 1
            return
    pytest.fail("no run was stopped")


def test_what_a_killed_run_left_goes_with_the_next(
    words: dict[str, list[object]], tmp_path: Path
) -> None:
    """SIGKILL leaves a folder; the next run of the same kind removes it, and no other's."""
    place = Place(tmp_path / "run")
    place.fresh()
    lives = place.folder / "tmp" / "tank_datum_qa-lives"
    lives.mkdir()
    lock = os.open(lives / "lock", os.O_RDWR | os.O_CREAT)
    fcntl.flock(lock, fcntl.LOCK_EX)
    of_the_living = sorted(place.left())
    left = []
    for name in ("extract", "qa"):
        for wait in (0.05, 0.1, 0.2, 0.4, 0.8):
            process = place.start(words[name])
            time.sleep(wait)
            process.kill()
            process.communicate(timeout=60)
            left += place.left()
            if len(place.left()) > len(of_the_living):
                break
    assert len(left) > len(of_the_living), "no run was killed while it had a folder"
    for name in ("extract", "qa"):
        place.start(words[name]).communicate(timeout=300)
    assert sorted(place.left()) == of_the_living
    os.close(lock)
