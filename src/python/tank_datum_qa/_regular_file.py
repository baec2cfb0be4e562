"""The one place where the Python side opens a file that somebody names."""

from __future__ import annotations

import os
import stat

LARGEST = 1 << 28  # bytes, as src/io/whole_file.h has it


def read_regular(path: str | os.PathLike[str]) -> bytes:
    """The bytes of a regular file.

    Raises OSError, with its reason in `strerror`, for a folder, pipe, socket or device too; nothing
    is waited for.
    """
    descriptor = os.open(path, os.O_RDONLY | os.O_NONBLOCK | os.O_CLOEXEC)
    with open(descriptor, "rb") as file:
        about = os.fstat(descriptor)
        if stat.S_ISDIR(about.st_mode):
            raise OSError(0, "a folder", os.fspath(path))
        if not stat.S_ISREG(about.st_mode):
            raise OSError(0, "not a regular file", os.fspath(path))
        if about.st_size > LARGEST:
            raise OSError(0, f"{about.st_size} bytes, above {LARGEST}", os.fspath(path))
        return file.read()


def text_of(content: bytes, encoding: str = "utf-8") -> str:
    """Bytes as text with \\n for its line ends. Raises UnicodeDecodeError."""
    return content.decode(encoding).replace("\r\n", "\n").replace("\r", "\n")


def read_regular_text(path: str | os.PathLike[str]) -> str:
    """The same of a file. Raises OSError and UnicodeDecodeError."""
    return text_of(read_regular(path))
