"""Files put into a folder whole or not at all, and in which everything else stays.

The Python side of apps/results, with the same manifest.
"""

from __future__ import annotations

import contextlib
import fcntl
import hashlib
import json
import os
import sys
import time
from collections.abc import Callable
from pathlib import Path

from tank_datum_qa._result_journal import (
    COMMIT,
    PATIENCE,
    Journal,
    ResultError,
    is_lock_of,
    kept_name,
    move,
    no_stop,
    remove_own,
    remove_stale,
    settle,
    sync,
    undo,
)

MANIFEST = "manifest.json"
IsOwn = Callable[[Path], bool]


class OutputIsInputError(Exception):
    """An output in the place of an input; the message is one line."""


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
        self._path: Path | None = None
        self._own_name = folder
        self.lock = -1
        self.made: list[Path] = []

    @property
    def path(self) -> Path:
        """The hidden folder of a run under way."""
        assert self._path is not None
        return self._path

    def __enter__(self) -> Path:
        try:
            with no_stop():
                return self._begin()
        except BaseException:  # also a signal that waited
            self.__exit__(ResultError)
            raise

    def __exit__(self, kind: type[BaseException] | None, *_: object) -> None:
        with no_stop():
            try:
                if kind is None:
                    self._commit()
                    self.made = []
            finally:
                self._clean_up()

    def _begin(self) -> Path:
        self.made = [p for p in (self.folder, *self.folder.parents) if not p.exists()]
        self.folder.mkdir(parents=True, exist_ok=True)
        remove_stale(self.folder)
        self._say(settle(self.folder))
        for number in range(100):
            path = self.folder / f".tank_datum-{os.getpid()}-{number}"
            try:
                path.mkdir()
                self.lock = os.open(path / "lock", os.O_RDWR | os.O_CREAT | os.O_EXCL)
                fcntl.flock(self.lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
            except (FileExistsError, FileNotFoundError, BlockingIOError):
                continue  # of another run, or taken for a stale one
            if not is_lock_of(self.lock, path):
                os.close(self.lock)
                continue  # the same, a moment later
            self._path = self._own_name = path
            (path / "new").mkdir()
            return path / "new"
        raise ResultError(
            f"{self.folder}, no hidden folder can be made, expected room for one"
        )

    def _clean_up(self) -> None:
        if self._path is not None:
            with contextlib.suppress(OSError):
                # the commit folder's name is the next run's as soon as this one's has left it
                if self.path != self._own_name:
                    self.path.rename(self._own_name)
                remove_own(self._own_name)
        if self.lock >= 0:
            os.close(self.lock)
        self.lock, self._path = -1, None
        for path in self.made:
            with contextlib.suppress(OSError):
                path.rmdir()

    def _commit(self) -> None:
        names = sorted(p.name for p in (self.path / "new").iterdir())
        hashes = {name: _hash(self.path / "new" / name) for name in names}
        self._enter()
        journal, said = self._plan(hashes)
        for path in [*(self.path / "new").iterdir(), self.path / "new"]:
            sync(path)
        (self.path / "old").mkdir()
        part = self.path / "journal.json.part"
        part.write_text(journal.text())
        sync(part)
        try:
            move(part, self.path / "journal.json")
            sync(self.path)
            for name, to in journal.displaced:
                move(self.folder / name, self.folder / to)
            for name in journal.added:
                move(self.path / "new" / name, self.folder / name)
            sync(self.folder)
            move(self.path / "journal.json", self.path / "done.json")
        except BaseException:
            try:
                undo(self.folder, journal)
            except OSError:
                self._path = None  # its journal stays, for the next run
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
                time.sleep(0.001)
                continue
            self._path = commit
            sync(self.folder)
            return
        raise ResultError(
            f"{commit}, other runs without end, expected one run at a time"
        )

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
            return (
                name in mine and now == listed[name]["sha256"]
            ) or now == hashes.get(name)

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
                why = (
                    "was changed since it was written"
                    if name in listed
                    else "is of others"
                )
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
            if _is_same(output, path):
                what = "expected a place outside of the inputs"
                raise OutputIsInputError(f"{output}, the input {path}, {what}")


def _is_same(one: Path, other: Path) -> bool:
    if os.path.exists(one) and os.path.exists(other):
        return os.path.samefile(one, other)
    return os.path.realpath(one) == os.path.realpath(other)
