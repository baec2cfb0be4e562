"""Scans by path, glob or fsspec URL: listed, hashed, and brought where the worker runs."""

from __future__ import annotations

import contextlib
import glob
import shutil
import tempfile
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import fsspec
import xxhash

BLOCK = 1 << 22  # bytes read at a time


@dataclass(frozen=True)
class Source:
    """A scan's file. stamp changes with its content as far as the storage tells: it names what
    was hashed before."""

    url: str
    size: int
    stamp: str


def is_url(place: str) -> bool:
    """Whether it names a file system of fsspec; a path does not."""
    scheme, found, _ = place.partition("://")
    return bool(found) and scheme.replace("+", "").replace(":", "").isalnum()


def resolved(place: str, folder: Path) -> str:
    """The place as a URL, or as an absolute path when it is one of this machine's."""
    return place if is_url(place) else str(folder / place)


def file_system(place: str) -> tuple[Any, str]:
    """Of a URL or a path, with its name there. A path is taken as it is, whatever is in it."""
    if is_url(place):
        system, path = fsspec.core.url_to_fs(place)
        return system, str(path)
    return fsspec.filesystem("file"), place


def unknown_system(place: str) -> str:
    """Why a URL's file system cannot be used here; empty when it can."""
    try:
        if is_url(place):
            fsspec.get_filesystem_class(place.partition("://")[0].partition("::")[0])
    except (ValueError, ImportError) as error:
        return str(error)
    return ""


def listed(places: tuple[str, ...], folder: Path) -> list[Source]:
    """The files of paths, globs and URLs, in the order given, those of a glob by name, each once.

    Raises FileNotFoundError for a place without any file, OSError as the storage does.
    """
    found: dict[str, Source] = {}
    for place in places:
        system, path = file_system(resolved(place, folder))
        names = [path]
        if set(place) & set("*?[") and not system.exists(path):
            names = _matching(place, folder) if not is_url(place) else system.glob(path)
        if not names:
            raise FileNotFoundError(2, "no file of this pattern", place)
        for name in sorted(map(str, names)):
            source = _source(system, name)
            found.setdefault(source.url, source)
    return list(found.values())


def _matching(pattern: str, folder: Path) -> list[str]:
    """Files of this machine; what the folder's name holds is no pattern."""
    names = glob.glob(pattern, root_dir=folder, recursive=True)
    return [str(folder / name) for name in names if (folder / name).is_file()]


def _source(system: Any, name: str) -> Source:
    about = system.info(name)
    if about["type"] != "file":
        raise FileNotFoundError(2, "not a file", name)
    stamps = (
        "ETag",
        "etag",
        "md5Hash",
        "mtime",
        "LastModified",
        "last_modified",
        "created",
    )
    stamp = next((str(about[key]) for key in stamps if about.get(key)), "")
    local = "file" in _protocols(system)
    url = name if local else str(system.unstrip_protocol(name))
    return Source(url, int(about["size"]), stamp)


def _protocols(system: Any) -> tuple[str, ...]:
    return (
        (system.protocol,)
        if isinstance(system.protocol, str)
        else tuple(system.protocol)
    )


def content_hash(url: str) -> str:
    """XXH3-128 of the bytes, as datum.json has it of its inputs. Raises OSError."""
    made = xxhash.xxh3_128()
    with _opened(url) as file:
        while block := file.read(BLOCK):
            made.update(block)
    return made.hexdigest()


def _opened(url: str) -> Any:
    return fsspec.open(url, "rb") if is_url(url) else open(url, "rb")


@contextlib.contextmanager
def local_copies(sources: list[Source]) -> Iterator[list[str]]:
    """Paths of this machine with the sources' content; copies are removed afterwards."""
    with contextlib.ExitStack() as stack:
        paths: list[str] = []
        for number, source in enumerate(sources):
            if not is_url(source.url):
                paths.append(source.url)
                continue
            folder = stack.enter_context(
                tempfile.TemporaryDirectory(prefix="tank_datum_")
            )
            paths.append(str(Path(folder) / f"{number}_{Path(source.url).name}"))
            with fsspec.open(source.url, "rb") as remote, open(paths[-1], "wb") as copy:
                shutil.copyfileobj(remote, copy, BLOCK)
        yield paths
