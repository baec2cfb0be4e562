"""A folder for the while, which does not outlive the run, and what ends a run from outside."""

from __future__ import annotations

import fcntl
import os
import shutil
import signal
import sys
import tempfile
import time
from collections.abc import Generator
from contextlib import contextmanager
from pathlib import Path
from types import FrameType

from tank_datum_qa._result_journal import no_stop

PREFIX = "tank_datum_qa-"
SETTLED = 60.0  # seconds after which a folder without a lock is no longer being made


@contextmanager
def scratch() -> Generator[Path]:
    """A new folder, removed at the end; those of runs that were killed are removed before."""
    with no_stop():  # its first call writes a file there and removes it
        place = Path(tempfile.gettempdir())
    clear_stale(place)
    folder, lock = None, -1
    try:
        with no_stop():
            folder = Path(tempfile.mkdtemp(prefix=PREFIX))
            lock = os.open(folder / "lock", os.O_RDWR | os.O_CREAT, 0o600)
            fcntl.flock(lock, fcntl.LOCK_EX)
        yield folder
    finally:
        with no_stop():
            if folder is not None:
                shutil.rmtree(folder, ignore_errors=True)
            if lock >= 0:
                os.close(lock)


def clear_stale(place: Path) -> None:
    """Removes the folders whose run lives no more: the lock goes with the process."""
    for folder in place.glob(f"{PREFIX}*"):
        try:
            lock = os.open(folder / "lock", os.O_RDWR)
        except FileNotFoundError:
            if folder.is_dir() and time.time() - folder.stat().st_mtime > SETTLED:
                shutil.rmtree(folder, ignore_errors=True)
            continue
        except OSError:
            continue  # somebody else's
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
            shutil.rmtree(folder, ignore_errors=True)
        except OSError:
            pass  # its run lives
        finally:
            os.close(lock)


def exit_on_signals() -> None:
    """SIGINT, SIGTERM and SIGHUP leave the main thread by SystemExit, with a line on stderr."""

    def leave(number: int, _: FrameType | None) -> None:
        signal.signal(number, signal.SIG_IGN)
        print(f"qa: stopped by {signal.strsignal(number)}", file=sys.stderr)
        sys.exit(128 + number)

    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        if signal.getsignal(number) != signal.SIG_IGN:
            signal.signal(number, leave)
