"""Ctrl-C and SIGTERM: at once, but not in the middle of what must be done whole."""

from __future__ import annotations

import contextlib
import signal
from collections.abc import Iterator
from dataclasses import dataclass

SIGNALS = (signal.SIGINT, signal.SIGTERM)


@dataclass
class _State:
    held: int = 0
    asked: bool = False
    seen: bool = False


_state = _State()


@contextlib.contextmanager
def interruptible() -> Iterator[None]:
    """Either signal raises KeyboardInterrupt, once: a second one does not cut short the end that
    the first one began. For the main thread."""
    _state.seen = False
    before = {number: signal.signal(number, _interrupt) for number in SIGNALS}
    try:
        yield
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)


@contextlib.contextmanager
def whole() -> Iterator[None]:
    """What is done inside is done to its end; a signal comes after it."""
    _state.held += 1
    try:
        yield
    finally:
        _state.held -= 1
        asked, _state.asked = (
            _state.asked and not _state.held,
            _state.asked and bool(_state.held),
        )
    if asked:
        raise KeyboardInterrupt


def stop_if_asked() -> None:
    """For loops that wait: an interrupt that fell into a finalizer was raised there and ended nothing."""
    if _state.seen:
        raise KeyboardInterrupt


def _interrupt(number: int, frame: object) -> None:
    _state.seen = True
    for each in SIGNALS:
        signal.signal(each, signal.SIG_IGN)
    if _state.held:
        _state.asked = True
    else:
        raise KeyboardInterrupt
