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


def on_terminal(stream: str, *args: object, **environment: str) -> tuple[int, str]:
    """The status of a run, and what it writes to one of its streams when that is a terminal."""
    master, slave = pty.openpty()
    command = [str(executable("tank_datum")), *map(str, args)]
    streams = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL} | {stream: slave}
    with subprocess.Popen(command, env={**os.environ, **environment}, **streams) as process:
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


def test_sparkline_on_a_terminal(synth: Synth, tmp_path: Path) -> None:
    """A row of blocks on a terminal of a UTF-8 locale, and nowhere else; the rest is the same."""
    args = (synth(), "-o", tmp_path / "out")
    lines = on_terminal("stdout", *args, LC_ALL="C.UTF-8")[1].splitlines()
    row = next(line for line in lines if line.startswith("elevation"))
    assert {"▁", "█"} <= set(row)
    assert len(lines) <= 16
    plain = on_terminal("stdout", *args, LC_ALL="C")[1].splitlines()
    assert plain == [line for line in lines if line != row]


def test_progress_on_a_terminal(synth: Synth, tmp_path: Path) -> None:
    """One line that is written over, and cleared at the end; nothing when quiet."""
    status, text = on_terminal("stderr", synth(), "-o", tmp_path / "out")
    assert status == 0
    assert text.count("...") >= 5
    assert re.search(r"locate 100 %  \d+\.\d M points/s  0 s left", text)
    assert "\n" not in text
    assert text.endswith("\r\033[K")
    assert on_terminal("stderr", synth(), "-o", tmp_path / "out", "--quiet") == (0, "")
