"""Programs that are run: none outlives the run, and what it says on stderr is shown at a length."""

from __future__ import annotations

import contextlib
import os
import signal
import subprocess
import tempfile
import threading
import time
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import IO

GRACE, PAUSE = 5.0, 0.02  # s: to clean up after SIGTERM, and how often is looked
SHOWN = 4096  # bytes of stderr, of its beginning and of its end

_running: set[subprocess.Popen[bytes]] = set()
_stopped = threading.Event()


def run(words: Sequence[str], folder: Path) -> tuple[int, str]:
    """Runs a program to its end, or until stop_programs: exit status, and stderr.

    It has a process group of its own, so that what it starts ends with it. Stderr goes to a file:
    nothing is waited for but the program.
    """
    with (
        tempfile.TemporaryFile() as said,
        subprocess.Popen(
            words,
            cwd=folder,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            stderr=said,
            process_group=0,
        ) as program,
    ):
        _running.add(program)
        try:
            if _stopped.is_set():
                _end([program])
            program.wait()
        except BaseException:  # a signal, or a time-out of who calls
            _end([program])
            raise
        finally:
            _running.discard(program)
        return program.returncode, _shown(said)


def stop_programs() -> None:
    """Ends what runs; they clean up themselves, as long as GRACE."""
    _stopped.set()
    _end(list(_running))


def _end(programs: Iterable[subprocess.Popen[bytes]]) -> None:
    """SIGTERM, and SIGKILL for what is there after GRACE."""
    left = {program.pid for program in programs if program.returncode is None}
    until, number = time.monotonic() + GRACE, signal.SIGTERM
    for group in left:
        _signalled(group, number)
    while left and time.monotonic() < until:
        for program in programs:
            program.poll()
        left = {group for group in left if _signalled(group, 0)}
        time.sleep(PAUSE)
    for group in left:
        _signalled(group, signal.SIGKILL)


def _signalled(group: int, number: int) -> bool:
    """Whether the group was there for a signal."""
    with contextlib.suppress(ProcessLookupError, PermissionError):
        os.killpg(group, number)
        return True
    return False


def _shown(said: IO[bytes]) -> str:
    """A file's text; of a long one the first and the last lines, and how much is left out."""
    size = said.seek(0, os.SEEK_END)
    said.seek(0)
    if size <= 2 * SHOWN:
        return _text(said.read()).strip()
    first = said.read(SHOWN)
    said.seek(size - SHOWN)
    last = said.read()
    first = first[: first.rfind(b"\n") + 1] or first
    last = last[last.find(b"\n") + 1 :] or last
    left_out = f"... {size - len(first) - len(last)} bytes left out ..."
    return "\n".join([_text(first).strip(), left_out, _text(last).strip()])


def _text(content: bytes) -> str:
    return content.decode(errors="backslashreplace")
