"""Packages that only some functions need."""

from __future__ import annotations

import importlib
from typing import Any


def imported(package: str, function: str, extra: str) -> Any:
    """The package. Raises ModuleNotFoundError that says what to install."""
    try:
        return importlib.import_module(package)
    except ModuleNotFoundError as error:
        if error.name != package.partition(".")[0]:
            raise
        raise ModuleNotFoundError(
            f"{function} needs {error.name}: pip install 'tank_datum[{extra}]'",
            name=error.name,
        ) from None
