"""Files put into a folder whole or not at all, and in which everything else stays.

The Python side of apps/results: the same hidden folders, journal and manifest, so that either side
puts right what a killed run of the other left.
"""

from __future__ import annotations

import contextlib
import fcntl
import hashlib
import json
import os
import re
import shutil
import sys
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path

COMMIT, MANIFEST = ".tank_datum-commit", "manifest.json"
STALE = re.compile(r"\.tank_datum-[0-9]{1,9}-[0-9]{1,9}")
PAUSE, PATIENCE = 0.02, 1500  # s, and how often: a commit takes a fraction of one
IsOwn = Callable[[Path], bool]


class ResultError(Exception):
    """Results that are not whole, or cannot be put in place; the message is one line."""


class OutputIsInputError(Exception):
    """An output in the place of an input; the message is one line."""


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
            raise ResultError(f"{path}, no journal, expected that of a stopped run") from None


def kept_name(path: Path) -> Path:
    """A free name beside path: report.kept.html, report.kept-2.html."""
    count = 1
    while True:
        mark = ".kept" if count == 1 else f".kept-{count}"
        kept = path.with_name(f"{path.stem}{mark}{path.suffix}")
        if not os.path.lexists(kept):
            return kept
        count += 1


def _move(source: Path, target: Path) -> None:
    if os.path.lexists(target):
        raise FileExistsError(17, "File exists", str(target))
    source.rename(target)


def _sync(path: Path) -> None:
    descriptor = os.open(path, os.O_RDONLY)
    try:
        os.fsync(descriptor)
    finally:
        os.close(descriptor)


def _undo(folder: Path, journal: Journal) -> None:
    for name in reversed(journal.added):
        waiting, place = folder / COMMIT / "new" / name, folder / name
        if not os.path.lexists(waiting) and os.path.lexists(place):
            _move(place, waiting)
    for name in reversed(journal.folders):
        with contextlib.suppress(OSError):
            (folder / name).rmdir()
    for name, to in reversed(journal.displaced):
        place, away = folder / name, folder / to
        if os.path.lexists(away):
            if os.path.lexists(place):  # made after the run was stopped
                _move(place, kept_name(place))
            _move(away, place)
    _sync(folder)
    (folder / COMMIT / "journal.json").unlink(missing_ok=True)


def _remove_own(path: Path) -> None:
    """What a run makes in its hidden folder, and the folder if then empty; the lock last."""
    for name in ("new", "old"):
        if (path / name).is_dir():
            shutil.rmtree(path / name)
    for name in ("journal.json.part", "done.json", "lock"):
        (path / name).unlink(missing_ok=True)
    with contextlib.suppress(OSError):
        path.rmdir()


@contextlib.contextmanager
def _lock_of(path: Path) -> Iterator[bool]:
    """Whether the run of a hidden folder is gone; then it is ours as long as this lasts."""
    try:
        descriptor = os.open(path / "lock", os.O_RDWR)
    except FileNotFoundError:
        yield True
        return
    try:
        fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
        mine, there = os.fstat(descriptor), os.stat(path / "lock")
        yield (mine.st_dev, mine.st_ino) == (there.st_dev, there.st_ino)
    except (BlockingIOError, FileNotFoundError):
        yield False
    finally:
        os.close(descriptor)


def settle(folder: Path) -> list[str]:
    """Puts a folder right whose last commit was stopped; one under way is waited for."""
    commit = folder / COMMIT
    for _ in range(PATIENCE):
        if not commit.is_dir() or commit.is_symlink():
            return []
        with _lock_of(commit) as gone:
            if gone:
                said = []
                if (commit / "journal.json").exists():
                    _undo(folder, Journal.read(commit / "journal.json"))
                    what = "a run was stopped while it replaced the results"
                    said.append(f"{folder}: {what}; those of the run before are back")
                elif (commit / "done.json").exists():
                    for name in Journal.read(commit / "done.json").emptied:
                        with contextlib.suppress(OSError):
                            (folder / name).rmdir()
                _remove_own(commit)
                return said
        time.sleep(PAUSE)
    raise ResultError(f"{commit}, another run that does not end, expected one run at a time")


def settle_to_read(folder: Path, program: str) -> None:
    """The same before results are read, of the folder and of the one it lies in."""
    for place in (folder, folder / ".."):
        if (place / COMMIT / "journal.json").exists():
            for line in settle(place):
                print(f"{program}: {line}", file=sys.stderr)


def _remove_stale(folder: Path) -> None:
    for path in [p for p in folder.iterdir() if STALE.fullmatch(p.name)]:
        if path.is_dir() and not path.is_symlink():
            if not (path / "lock").exists():
                with contextlib.suppress(OSError):
                    path.rmdir()
                continue
            with _lock_of(path) as gone:
                if gone:
                    _remove_own(path)


def _hash(path: Path) -> str:
    return hashlib.sha256(path.read_bytes()).hexdigest()


def read_manifest(folder: Path) -> dict[str, dict[str, str]] | None:
    """The own files by path, each with sha256 and program; None without an own manifest."""
    path = folder / MANIFEST
    if not path.exists() or path.is_symlink():
        return None
    try:
        table = json.loads(path.read_bytes())
        if table["schema"] != 1:
            return None
        return {
            file["path"]: {"sha256": file["sha256"], "program": file["program"]}
            for file in table["files"]
        }
    except (ValueError, KeyError, TypeError):
        return None


def _manifest_text(files: dict[str, dict[str, str]]) -> str:
    listed = [{"path": path, **entry} for path, entry in sorted(files.items())]
    about = "files of tank_datum, which its next run replaces; no others"
    return json.dumps({"schema": 1, "about": about, "files": listed}, indent=1) + "\n"


class ResultFolder:
    """A folder that receives files together; `with ResultFolder(...) as new:` writes into `new`.

    With `own` None a manifest says which files are the program's; else own(path) does, and no
    manifest is written. What else stands in the way is kept under another name, and said.
    """

    def __init__(self, folder: Path, program: str, own: IsOwn | None = None) -> None:
        self.folder, self.program, self.own = folder, program, own

    def __enter__(self) -> Path:
        self.made = [p for p in (self.folder, *self.folder.parents) if not p.exists()]
        self.folder.mkdir(parents=True, exist_ok=True)
        _remove_stale(self.folder)
        self._say(settle(self.folder))
        for number in range(100):
            self.path = self.folder / f".tank_datum-{os.getpid()}-{number}"
            try:
                self.path.mkdir()
                self.lock = (self.path / "lock").open("x")
                fcntl.flock(self.lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
                break
            except (FileExistsError, FileNotFoundError, BlockingIOError):
                continue
        else:
            raise ResultError(f"{self.folder}, no hidden folder can be made, expected room for one")
        (self.path / "new").mkdir()
        return self.path / "new"

    def __exit__(self, kind: type[BaseException] | None, *_: object) -> None:
        try:
            if kind is None:
                self._commit()
                self.made = []
        finally:
            if self.path is not None:
                with contextlib.suppress(OSError):
                    _remove_own(self.path)
            self.lock.close()
            for path in self.made:
                with contextlib.suppress(OSError):
                    path.rmdir()

    def _commit(self) -> None:
        names = sorted(p.name for p in (self.path / "new").iterdir())
        hashes = {name: _hash(self.path / "new" / name) for name in names}
        self._enter()
        journal, said = self._plan(hashes)
        for path in (self.path / "new").iterdir():
            _sync(path)
        (self.path / "old").mkdir()
        part = self.path / "journal.json.part"
        part.write_text(journal.text())
        _sync(part)
        _move(part, self.path / "journal.json")
        _sync(self.path)
        try:
            for name, to in journal.displaced:
                _move(self.folder / name, self.folder / to)
            for name in journal.added:
                _move(self.path / "new" / name, self.folder / name)
            _sync(self.folder)
            _move(self.path / "journal.json", self.path / "done.json")
        except BaseException:
            try:
                _undo(self.folder, journal)
            except OSError:
                self.path = None  # its journal stays, for the next run
            raise
        self._say(said)

    def _enter(self) -> None:
        commit = self.folder / COMMIT
        for _ in range(PATIENCE):
            try:
                self.path.rename(commit)
            except OSError as error:
                if error.errno not in (17, 39):  # EEXIST, ENOTEMPTY: another run's
                    raise
                self._say(settle(self.folder))
                continue
            self.path = commit
            _sync(self.folder)
            return
        raise ResultError(f"{commit}, other runs without end, expected one run at a time")

    def _plan(self, hashes: dict[str, str]) -> tuple[Journal, list[str]]:
        before = read_manifest(self.folder) if self.own is None else {}
        listed = before or {}
        mine = {n for n, entry in listed.items() if entry["program"] == self.program}
        journal, said = Journal(), []

        def is_own(name: str) -> bool:
            place = self.folder / name
            if place.is_symlink() or not place.is_file():
                return False
            if self.own is not None:
                return self.own(place)
            if name == MANIFEST:
                return before is not None
            now = _hash(place)
            return (name in mine and now == listed[name]["sha256"]) or now == hashes.get(name)

        names = sorted(mine | set(hashes))
        if self.own is None:
            others = {n: e for n, e in listed.items() if n not in mine}
            own = {n: {"sha256": h, "program": self.program} for n, h in hashes.items()}
            (self.path / "new" / MANIFEST).write_text(_manifest_text(others | own))
            names.append(MANIFEST)
        for name in names:
            place = self.folder / name
            if "/" in name or not os.path.lexists(place):
                continue
            if is_own(name):
                journal.displaced.append((name, f"{COMMIT}/old/{name}"))
            else:
                kept = kept_name(place)
                journal.displaced.append((name, kept.name))
                why = "was changed since it was written" if name in listed else "is of others"
                said.append(f"{place} {why}: kept as {kept}")
        journal.added = sorted(p.name for p in (self.path / "new").iterdir())
        return journal, said

    def _say(self, lines: list[str]) -> None:
        for line in lines:
            print(f"{self.program}: {line}", file=sys.stderr)


def require_apart(inputs: list[Path], outputs: list[Path]) -> None:
    """Raises OutputIsInputError for an output that is, links to or is a hard link of an input."""
    for output in outputs:
        for path in inputs:
            there = output.exists() and path.exists()
            same = output.samefile(path) if there else output.resolve() == path.resolve()
            if same:
                what = "expected a place outside of the inputs"
                raise OutputIsInputError(f"{output}, the input {path}, {what}")
