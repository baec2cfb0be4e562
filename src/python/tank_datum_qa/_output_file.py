"""A file that a person named, whole or not at all, as apps/results/output_file.h has it."""

from __future__ import annotations

import os
import stat
import sys
from pathlib import Path

from tank_datum_qa._result_folder import IsOwn, ResultFolder


def write_output(path: Path, content: bytes, program: str, own: IsOwn) -> None:
    """Puts a file in place; one that is not the program's own is kept under another name.

    A symbolic link is followed. A device or a pipe is written to as it is, and so is the file that
    standard output or error goes to. Raises OSError and ResultError.
    """
    about = _status(path)
    if about and stat.S_ISDIR(about.st_mode):
        raise OSError(0, "a folder", os.fspath(path))
    stream = _stream(about) if about else None
    if stream is not None or (about and not stat.S_ISREG(about.st_mode)):
        sys.stdout.flush()
        with open(path if stream is None else os.dup(stream), "wb") as file:
            file.write(content)
        return
    place = Path(os.path.realpath(path))
    with ResultFolder(place.parent, program, own=own) as new:
        (new / place.name).write_bytes(content)


def _status(path: Path) -> os.stat_result | None:
    try:
        return os.stat(path)
    except FileNotFoundError:
        return None


def _stream(about: os.stat_result) -> int | None:
    """Standard output or error, when a file is that."""
    for stream in (1, 2):
        try:
            if os.path.samestat(about, os.fstat(stream)):
                return stream
        except OSError:  # closed
            continue
    return None
