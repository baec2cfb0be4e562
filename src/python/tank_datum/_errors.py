"""The package's exceptions: what was wrong, where, and what was expected."""

from __future__ import annotations

import os
from typing import Any

from tank_datum import _core


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


class FileError(_Said, OSError):
    """A file that could not be read or written, or that holds something else.

    Beside stage, name, value and expected it has `filename`, and `errno` where the system refused
    the file; None where its content is at fault.
    """

    def __init__(self, *said: str) -> None:
        super().__init__(*said)
        self.errno = None
        self.strerror = self.value or None
        self.filename = self.name

    def __reduce__(self) -> tuple[Any, ...]:
        return *super().__reduce__(), {"errno": self.errno, "filename": self.filename}


def option_error(stage: str, name: str, value: object, expected: str) -> OptionError:
    """With the message that the library would write."""
    return OptionError(
        f"{stage}: {name}, {value}, expected {expected}",
        stage,
        name,
        str(value),
        expected,
    )


def file_error(stage: str, path: str, value: str, expected: str) -> FileError:
    """With the message that the library would write; the path's own bytes are in `filename`."""
    name = shown(path)
    made = FileError(
        f"{stage}: {name}, {value}, expected {expected}", stage, name, value, expected
    )
    made.filename = path
    return made


def refused_by_system(
    stage: str, path: str, error: OSError, expected: str
) -> FileError:
    """The same of what the system refused; its reason is in English in every locale."""
    number = error.errno or None
    reason = _core.system_text(number) if number else error.strerror or str(error)
    made = file_error(stage, path, reason, expected)
    made.errno = number
    return made


def shown(path: str) -> str:
    """A path that any terminal and file can hold: bytes that are no UTF-8 are replaced."""
    return os.fsencode(path).decode("utf-8", "replace")


def short(value: object) -> str:
    """A value for a message of one line."""
    text = " ".join(repr(value).split())
    return text if len(text) <= 80 else f"{text[:80]}..."
