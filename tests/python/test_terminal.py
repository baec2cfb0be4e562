"""What the command shows on a terminal alone: a sparkline, and how far it is."""

from __future__ import annotations

import os
import pty
import re
import subprocess
from collections.abc import Callable
from pathlib import Path

from conftest import executable

Synth = Callable[..., Path]


def stdout_on_terminal(locale: str, *args: object) -> str:
    """What a run writes to standard output when that is a terminal."""
    master, slave = pty.openpty()
    command = [str(executable("tank_datum")), *map(str, args)]
    environment = {**os.environ, "LC_ALL": locale}
    with subprocess.Popen(command, stdout=slave, stderr=subprocess.DEVNULL, env=environment):
        os.close(slave)
        text = b""
        try:
            while part := os.read(master, 4096):
                text += part
        except OSError:  # the other end has closed
            pass
    os.close(master)
    return text.decode()


def test_sparkline_on_a_terminal(synth: Synth, tmp_path: Path) -> None:
    """A row of blocks on a terminal of a UTF-8 locale, and nowhere else; the rest is the same."""
    args = (synth(), "-o", tmp_path / "out")
    lines = stdout_on_terminal("C.UTF-8", *args).splitlines()
    row = next(line for line in lines if line.startswith("elevation"))
    assert {"▁", "█"} <= set(row)
    assert len(lines) <= 15
    plain = stdout_on_terminal("C", *args).splitlines()
    assert plain == [line for line in lines if line != row]


def stderr_on_terminal(*args: object) -> tuple[int, str]:
    """What a run writes to standard error when that is a terminal."""
    master, slave = pty.openpty()
    command = [str(executable("tank_datum")), *map(str, args)]
    with subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=slave) as process:
        os.close(slave)
        text = b""
        try:
            while part := os.read(master, 4096):
                text += part
        except OSError:  # the other end has closed
            pass
        status = process.wait(timeout=60)
    os.close(master)
    return status, text.decode()


def test_progress_on_a_terminal(synth: Synth, tmp_path: Path) -> None:
    """One line that is written over, and cleared at the end; nothing when quiet."""
    status, text = stderr_on_terminal(synth(), "-o", tmp_path / "out")
    assert status == 0
    assert text.count("...") >= 5
    assert re.search(r"locate 100 %  \d+\.\d M points/s  0 s left", text)
    assert "\n" not in text
    assert text.endswith("\r\033[K")
    assert stderr_on_terminal(synth(), "-o", tmp_path / "out", "--quiet") == (0, "")
