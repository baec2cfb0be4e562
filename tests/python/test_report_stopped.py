"""tank_datum_report that is stopped while it prints leaves nothing; what a killed one left goes."""

from __future__ import annotations

import os
import signal
import subprocess
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

from programs import executable
from test_report_paper import to_pdf
from test_stopped import default_signals

SLOW = """#!/bin/sh
for word in "$@"; do
  case $word in --user-data-dir=*) folder=${word#*=} ;; esac
done
echo $$ > "$folder/pid.new"
mv "$folder/pid.new" "$folder/pid"
exec sleep 60
"""


def until(reached: Callable[[], bool]) -> None:
    end = time.monotonic() + 20
    while not reached():
        assert time.monotonic() < end, "waited in vain"
        time.sleep(0.02)


def profiles(folder: Path) -> list[Path]:
    return sorted(folder.glob("tank_datum_print_*"))


def is_running(pid: int) -> bool:
    try:
        return "Z" not in Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()[0]
    except FileNotFoundError:
        return False


@contextmanager
def printing(result: Path, folder: Path) -> Iterator[tuple[subprocess.Popen[str], int]]:
    """A report that is being printed by a browser that takes long, and that browser's number."""
    browser = folder / "slow_browser"
    browser.write_text(SLOW)
    browser.chmod(0o755)
    before = set(profiles(folder))
    command = [executable("tank_datum_report"), result, "--pdf", folder / "report.pdf"]
    environment = {**os.environ, "TMPDIR": str(folder)}
    with subprocess.Popen(
        [*map(str, command), "--browser", str(browser)],
        env=environment,
        stderr=subprocess.PIPE,
        text=True,
        preexec_fn=default_signals,
    ) as program:

        def started() -> set[Path]:
            return {p.parent for p in folder.glob("*/pid")} - before

        until(lambda: bool(started()))
        (profile,) = started()
        yield program, int((profile / "pid").read_text())
        if program.poll() is None:
            program.kill()


@pytest.mark.parametrize(
    "number", [signal.SIGTERM, signal.SIGINT], ids=["terminated", "interrupted"]
)
def test_a_signal_leaves_neither_folder_nor_browser(
    no_tank_report: Path, tmp_path: Path, number: signal.Signals
) -> None:
    with printing(no_tank_report, tmp_path) as (program, browser):
        program.send_signal(number)
        assert program.wait(20) == -number
        assert program.stderr is not None and "stopped by" in program.stderr.read()
    assert profiles(tmp_path) == []
    until(lambda: not is_running(browser))
    assert [p.name for p in tmp_path.iterdir()] == ["slow_browser"]


def test_what_a_killed_run_left_goes_with_the_next(no_tank_report: Path, tmp_path: Path) -> None:
    with printing(no_tank_report, tmp_path) as (program, browser):
        program.kill()
        program.wait(20)
    until(lambda: not is_running(browser))
    assert len(profiles(tmp_path)) == 1
    to_pdf(no_tank_report, tmp_path / "report.pdf", "--browser", "/bin/false", temporary=tmp_path)
    assert profiles(tmp_path) == []


def test_the_folder_of_a_run_that_lives_stays(no_tank_report: Path, tmp_path: Path) -> None:
    with printing(no_tank_report, tmp_path) as (program, browser):
        (tmp_path / "tank_datum_print_mine").write_text("no folder")
        to_pdf(no_tank_report, tmp_path / "b.pdf", "--browser", "/bin/false", temporary=tmp_path)
        assert is_running(browser) and program.poll() is None
        assert len(profiles(tmp_path)) == 2
