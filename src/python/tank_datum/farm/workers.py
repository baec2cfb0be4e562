"""Where tasks run, as the user says it."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Workers:
    """Where tasks run. scheduler: address, or a scheduler file; empty: on this machine.

    count: processes, 0 for one a core; memory: bytes for all of them, 0 for nine tenths of what
    is free.
    """

    scheduler: str = ""
    count: int = 0
    memory: int = 0
