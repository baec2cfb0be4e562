"""Where results are kept: a folder a key, on shared storage or in an object store.

A result is there when its row.json is. On a local file system the folder is renamed into place when
it is whole; in an object store row.json is written last.
"""

from __future__ import annotations

import contextlib
import json
import os
import shutil
import socket
import tempfile
import time
import uuid
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import fsspec
import xxhash

from tank_datum.farm.sources import Source, content_hash, file_system, is_url

ROW, DATUM = "row.json", "datum.json"
PARTS = ".parts"
STALE = 24 * 3600.0  # seconds after which a part belongs to no worker


class Store:
    """Results by key. url: a path or URL of fsspec. Raises OSError as the storage does."""

    def __init__(self, url: str) -> None:
        self.url = url
        self._system, self.root = file_system(url)
        self.is_local = isinstance(
            self._system, fsspec.implementations.local.LocalFileSystem
        )

    def folder(self, key: str) -> str:
        return f"{self.root}/{key[:2]}/{key}"

    def row(self, key: str) -> dict[str, Any] | None:
        """The row of a result that is there, whole with the datum of every tank."""
        content = self._read(f"{self.folder(key)}/{ROW}")
        try:
            row = dict(json.loads(content or b""))
        except ValueError:  # cut off, as by a power failure
            return None
        needed = (f"{tank['folder']}/{DATUM}" for tank in row.get("tanks", ()))
        whole = all(self.has(key, name) for name in needed)
        return row if whole else None

    def has(self, key: str, name: str) -> bool:
        """Whether a result's file is there."""
        return bool(self._system.exists(f"{self.folder(key)}/{name}"))

    def read(self, key: str, name: str) -> bytes:
        """A file of a result. Raises FileNotFoundError."""
        content = self._read(f"{self.folder(key)}/{name}")
        if content is None:
            raise FileNotFoundError(2, "No such file", f"{self.folder(key)}/{name}")
        return content

    def note(self, name: str) -> bytes | None:
        """What was kept by this name."""
        return self._read(f"{self.root}/{name}")

    def keep_note(self, name: str, content: bytes) -> None:
        self._write(f"{self.root}/{name}", content)

    @contextlib.contextmanager
    def making(self, key: str) -> Iterator[Path]:
        """A folder for the files of a result; at the end it is put in place, with its row.json.

        A result of the same key that came first stays, and this one is dropped.
        """
        if self.is_local:
            part = Path(self.root) / PARTS / f"{_maker()}.{key}.{uuid.uuid4().hex}"
            part.mkdir(parents=True)
        else:
            part = Path(tempfile.mkdtemp(prefix="tank_datum_"))
        try:
            yield part
            self._publish(key, part)
        finally:
            shutil.rmtree(part, ignore_errors=True)

    def sweep(self) -> None:
        """Removes what workers left unfinished that are no more, or are older than a day."""
        if not self.is_local:
            return
        for part in (Path(self.root) / PARTS).glob("*"):
            with contextlib.suppress(OSError):
                if _is_gone(part.name) or time.time() - part.stat().st_mtime > STALE:
                    shutil.rmtree(part, ignore_errors=True)

    def hash_of(self, source: Source) -> str:
        """The hash of a source's content, remembered until its size or stamp changes."""
        if known := self.known_hash(source):
            return known
        found = content_hash(source.url)
        self._write(self._hash_place(source), found.encode())
        return found

    def known_hash(self, source: Source) -> str | None:
        """The hash where it was taken before."""
        content = self._read(self._hash_place(source)) if source.stamp else None
        return content.decode() if content and len(content) == 32 else None

    def _hash_place(self, source: Source) -> str:
        place = source.url
        if self.is_local and not is_url(place):
            place = os.path.relpath(
                place, self.root
            )  # scans and results may move together
        text = f"{place}\n{source.size}\n{source.stamp}"
        return f"{self.root}/inputs/{xxhash.xxh3_128(text.encode()).hexdigest()}"

    def _publish(self, key: str, part: Path) -> None:
        place = self.folder(key)
        if self.is_local:
            Path(place).parent.mkdir(parents=True, exist_ok=True)
            try:
                os.rename(part, place)
            except OSError:
                if self.row(key) is None:
                    self._replace(part, Path(place))
            return
        files = sorted(path for path in part.rglob("*") if path.is_file())
        for path in sorted(files, key=lambda path: path == part / ROW):
            self._write(
                f"{place}/{path.relative_to(part).as_posix()}", path.read_bytes()
            )

    def _replace(self, part: Path, place: Path) -> None:
        """In place of what is left of a result."""
        old = part.with_name(f"{part.name}.old")
        os.rename(place, old)
        try:
            os.rename(part, place)
        finally:
            shutil.rmtree(old, ignore_errors=True)

    def _read(self, place: str) -> bytes | None:
        try:
            return bytes(self._system.cat_file(place))
        except (FileNotFoundError, NotADirectoryError):
            return None

    def _write(self, place: str, content: bytes) -> None:
        """Whole or not at all."""
        if not self.is_local:
            self._system.pipe_file(place, content)
            return
        Path(place).parent.mkdir(parents=True, exist_ok=True)
        part = f"{place}.{uuid.uuid4().hex}"
        try:
            Path(part).write_bytes(content)
            os.replace(part, place)
        finally:
            Path(part).unlink(missing_ok=True)


def _maker() -> str:
    """Names this process among those of all machines."""
    return f"{socket.gethostname()}.{os.getpid()}"


def _is_gone(part: str) -> bool:
    """Whether the maker of a part was a process of this machine that ended."""
    host, _, process = ".".join(part.split(".")[:-2]).rpartition(".")
    if host != socket.gethostname() or not process.isdecimal():
        return False
    try:
        os.kill(int(process), 0)
    except ProcessLookupError:
        return True
    except OSError:
        return False
    return False
