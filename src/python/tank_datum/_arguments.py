"""Arguments as the compiled part takes them, or refused by name."""

from __future__ import annotations

import os
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tank_datum._errors import file_error, option_error, short

LARGEST = 2**31 - 1


def whole(name: str, value: Any) -> int:
    """A whole number. Raises TypeError for another type, OptionError beyond 32 bits."""
    if isinstance(value, bool | np.bool_) or not isinstance(value, int | np.integer):
        raise TypeError(f"{name} = {short(value)}, expected a whole number")
    if not -LARGEST <= int(value) <= LARGEST:
        raise option_error("options", name, value, f"at most {LARGEST}")
    return int(value)


def real(name: str, value: Any) -> float:
    """A number. Raises TypeError for another type, OptionError for one too large."""
    others = bool | np.timedelta64  # an integer to NumPy
    if isinstance(value, others) or not isinstance(
        value, int | float | np.integer | np.floating
    ):
        raise TypeError(f"{name} = {short(value)}, expected a number")
    try:
        return float(value)
    except OverflowError:
        raise option_error(
            "options", name, short(value), "a number of 64 bits"
        ) from None


def path_bytes(stage: str, name: str, given: Any) -> bytes:
    """A path as the system has it. Raises TypeError for another type, FileError for what no path can hold."""
    if not isinstance(given, str | bytes | os.PathLike):
        raise TypeError(f"{name} = {short(given)}, expected a path")
    try:
        encoded = os.fsencode(given)
    except UnicodeEncodeError:
        encoded = b"\0"
    if b"\0" in encoded or not encoded:
        shown = repr(os.fspath(given))
        raise file_error(stage, shown, "no name of a file", "a path")
    return encoded


def indices(name: str, given: Any) -> NDArray[np.int32]:
    """Whole numbers of any type. Raises TypeError for others, masks and truth values too; OptionError beyond 32 bits."""
    array = np.asarray(given)
    if array.size == 0:
        return array.astype(np.int32)
    if array.dtype.kind not in "iu":
        said = f"an array of shape {array.shape} in {array.dtype}"
        raise TypeError(f"{name} = {said}, expected whole numbers: indices of points")
    for worst in (array.min(), array.max()):
        if not 0 <= worst <= LARGEST:
            raise option_error(
                "stages", name, worst, f"0 to {LARGEST}, indices of points"
            )
    return array.astype(np.int32)
