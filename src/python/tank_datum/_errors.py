"""The package's exceptions: what was wrong, where, and what was expected."""

from __future__ import annotations

import errno
import os
from typing import Any

_NUMBERS = {os.strerror(number): number for number in errno.errorcode}


class _Said(Exception):
    """With the parts of its message "stage: name, value, expected ..."."""

    def __init__(
        self,
        message: str,
        stage: str = "",
        name: str = "",
        value: str = "",
        expected: str = "",
    ) -> None:
        super().__init__(message)
        self._message = message
        self.stage, self.name, self.value, self.expected = stage, name, value, expected

    def __str__(self) -> str:
        return self._message

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (
            self._message,
            self.stage,
            self.name,
            self.value,
            self.expected,
        )


class OptionError(_Said, ValueError):
    """A refused option or argument.

    stage: of the chain, or "options"; name: of the option; value: as text; expected: what it must
    be.
    """


def _path_in(name: str) -> str:
    """The path in what was refused: "scan.pcd", "POINTS of scan.pcd", "z in stations.csv:7"."""
    for mark in (" of ", " in "):
        thing, found, path = name.partition(mark)
        if found and "/" not in thing:
            return path
    return name


class FileError(_Said, OSError):
    """A file that could not be read or written, or that holds something else.

    Beside stage, name, value and expected it has `filename`, and `errno` where the system refused
    the file; None where its content is at fault.
    """

    def __init__(self, *said: str) -> None:
        super().__init__(*said)
        self.errno = _NUMBERS.get(self.value)
        self.strerror = self.value or None
        self.filename = _path_in(self.name)


def option_error(stage: str, name: str, value: object, expected: str) -> OptionError:
    """With the message that the library would write."""
    return OptionError(
        f"{stage}: {name}, {value}, expected {expected}",
        stage,
        name,
        str(value),
        expected,
    )


def file_error(stage: str, name: str, value: str, expected: str) -> FileError:
    """With the message that the library would write."""
    return FileError(
        f"{stage}: {name}, {value}, expected {expected}", stage, name, value, expected
    )
