"""The hidden folders and the journal of a commit, and how a folder is put right by them.

The Python side of apps/results: either side puts right what a killed run of the other left.
"""

from __future__ import annotations

import contextlib
import fcntl
import json
import os
import re
import shutil
import signal
import sys
import time
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path

COMMIT = ".tank_datum-commit"
STALE = re.compile(r"\.tank_datum-[0-9]{1,9}-[0-9]{1,9}")
PAUSE, PATIENCE = 0.02, 1500  # s, and how often: a commit takes a fraction of one


class ResultError(Exception):
    """Results that are not whole, or cannot be put in place; the message is one line."""


@dataclass
class Journal:
    """What a commit moves, as in apps/results/journal.h."""

    displaced: list[tuple[str, str]] = field(default_factory=list)
    added: list[str] = field(default_factory=list)
    folders: list[str] = field(default_factory=list)
    emptied: list[str] = field(default_factory=list)

    def text(self) -> str:
        return json.dumps({"schema": 1, **vars(self)}, indent=1)

    @staticmethod
    def read(path: Path) -> Journal:
        try:
            table = json.loads(path.read_text())
            names = ("displaced", "added", "folders", "emptied")
            return Journal(*(table[name] for name in names))
        except (ValueError, KeyError, TypeError):
            raise ResultError(
                f"{path}, no journal, expected that of a stopped run"
            ) from None


@contextlib.contextmanager
def no_stop() -> Iterator[None]:
    """A signal waits as long as this lasts: for steps between which a process must not end."""
    stops = {signal.SIGINT, signal.SIGTERM, signal.SIGHUP}
    before = signal.pthread_sigmask(signal.SIG_BLOCK, stops)
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def kept_name(path: Path) -> Path:
    """A free name beside path: report.kept.html, report.kept-2.html."""
    count = 1
    while True:
        mark = ".kept" if count == 1 else f".kept-{count}"
        kept = path.with_name(f"{path.stem}{mark}{path.suffix}")
        if not os.path.lexists(kept):
            return kept
        count += 1


def move(source: Path, target: Path) -> None:
    if os.path.lexists(target):
        raise FileExistsError(17, "File exists", str(target))
    source.rename(target)


def sync(path: Path) -> None:
    descriptor = os.open(path, os.O_RDONLY)
    try:
        os.fsync(descriptor)
    finally:
        os.close(descriptor)


def undo(folder: Path, journal: Journal) -> None:
    # a new file cannot have the place of what has not been moved away
    untouched = {n for n, to in journal.displaced if not os.path.lexists(folder / to)}
    for name in reversed(journal.added):
        waiting, place = folder / COMMIT / "new" / name, folder / name
        moved = not os.path.lexists(waiting) and os.path.lexists(place)
        if moved and name not in untouched:
            move(place, waiting)
    for name in reversed(journal.folders):
        with contextlib.suppress(OSError):
            (folder / name).rmdir()
    for name, to in reversed(journal.displaced):
        place, away = folder / name, folder / to
        if os.path.lexists(away):
            if os.path.lexists(place):  # made after the run was stopped
                move(place, kept_name(place))
            move(away, place)
    sync(folder)
    (folder / COMMIT / "journal.json").unlink(missing_ok=True)


def remove_own(path: Path) -> None:
    """What a run makes in its hidden folder, and the folder if then empty; the lock last."""
    for name in ("new", "old"):
        if (path / name).is_dir():
            shutil.rmtree(path / name)
    for name in ("journal.json.part", "done.json", "lock"):
        (path / name).unlink(missing_ok=True)
    with contextlib.suppress(OSError):
        path.rmdir()


def is_lock_of(descriptor: int, path: Path) -> bool:
    """Whether the folder's lock is the open file, and not that of another run that has its name."""
    try:
        mine, there = os.fstat(descriptor), os.stat(path / "lock")
    except FileNotFoundError:
        return False
    return (mine.st_dev, mine.st_ino) == (there.st_dev, there.st_ino)


@contextlib.contextmanager
def lock_of(path: Path, how: int = 0) -> Iterator[bool]:
    """Whether the run of a hidden folder is gone; then it is ours as long as this lasts.

    With `how` os.O_CREAT | os.O_EXCL a folder is taken over whose lock is missing.
    """
    try:
        descriptor = os.open(path / "lock", os.O_RDWR | how, 0o666)
    except (FileExistsError, FileNotFoundError):
        yield False
        return
    try:
        fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
        yield is_lock_of(descriptor, path)
    except BlockingIOError:
        yield False
    finally:
        os.close(descriptor)


def settle(folder: Path) -> list[str]:
    """Puts a folder right whose last commit was stopped; one under way is waited for."""
    commit = folder / COMMIT
    for _ in range(PATIENCE):
        if not commit.is_dir() or commit.is_symlink():
            return []
        unlocked = not (commit / "lock").exists()
        if unlocked:
            with contextlib.suppress(OSError):
                commit.rmdir()  # of a run that has just removed its lock
                continue
        with lock_of(commit, os.O_CREAT | os.O_EXCL if unlocked else 0) as gone:
            if gone:
                said = []
                if (commit / "journal.json").exists():
                    undo(folder, Journal.read(commit / "journal.json"))
                    what = "a run was stopped while it replaced the results"
                    said.append(f"{folder}: {what}; those of the run before are back")
                elif (commit / "done.json").exists():
                    for name in Journal.read(commit / "done.json").emptied:
                        with contextlib.suppress(OSError):
                            (folder / name).rmdir()
                remove_own(commit)
                return said
        time.sleep(PAUSE)
    raise ResultError(
        f"{commit}, another run that does not end, expected one run at a time"
    )


def settle_to_read(folder: Path, program: str) -> None:
    """The same before results are read, of the folder and of the one it lies in."""
    for place in (folder, folder / ".."):
        if (place / COMMIT / "journal.json").exists():
            for line in settle(place):
                print(f"{program}: {line}", file=sys.stderr)


def remove_stale(folder: Path) -> None:
    for path in [p for p in folder.iterdir() if STALE.fullmatch(p.name)]:
        if path.is_dir() and not path.is_symlink():
            if not (path / "lock").exists():
                with contextlib.suppress(OSError):
                    path.rmdir()
                continue
            with lock_of(path) as gone:
                if gone:
                    remove_own(path)
