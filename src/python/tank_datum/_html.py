"""What a notebook shows of a result: its verdict, its main figures and a small picture."""

from __future__ import annotations

from html import escape
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from tank_datum._survey_records import Movement

if TYPE_CHECKING:
    from tank_datum._compare import Comparison
    from tank_datum._datum import Datum

WIDTH, HEIGHT, MARGIN = 480.0, 90.0, 6.0  # of the picture [px]


def _shown(value: float | None, digits: int = 0, scale: float = 1.0) -> str:
    return "?" if value is None else f"{scale * value:.{digits}f}"


def _rows(datum: Datum) -> list[tuple[str, str]]:
    rows = [("status", datum.status + (f": {datum.message}" if datum.message else ""))]
    if datum.tank is not None:
        at = ", ".join(_shown(place, 3) for place in datum.tank.center)
        rows.append(("tank", f"radius {_shown(datum.tank.radius, 3)} m, centre {at}"))
    level = datum.datum
    if level is not None:
        seen = f"{level.measured} measured, {level.interpolated} interpolated, "
        rows.append(("stations", f"{seen}{level.missing} missing"))
        span = f"mean {_shown(level.mean, 4)} m, range {_shown(level.range, 1, 1e3)} mm"
        low = f"{_shown(level.min, 4)} m at {_shown(level.min_azimuth_deg)} deg"
        high = f"{_shown(level.max, 4)} m at {_shown(level.max_azimuth_deg)} deg"
        rows.append(("datum", f"{span}: lowest {low}, highest {high}"))
    if datum.tilt is not None:
        tilt = datum.tilt
        towards = f" towards {_shown(tilt.direction_deg)} deg"
        rows.append(("tilt", f"{_shown(tilt.angle_arcsec, 1)} arc-seconds{towards}"))
    moved = datum.movement
    if moved is not None:
        text = moved.message or f"{moved.significant} of {moved.matched} stations moved"
        rows.append(("movement", f"since {moved.baseline}: {text}"))
    if datum.verdict is not None:
        rows.append(("verdict", f"{datum.verdict.word}: {datum.verdict.sentence}"))
    return rows


def summary_of(datum: Datum) -> str:
    """Lines for a terminal, from the figures alone."""
    return "".join(f"{name:<15}{text}\n" for name, text in _rows(datum))


def _runs(known: NDArray[np.bool_]) -> list[NDArray[np.intp]]:
    """Indices of the stations between gaps."""
    indices = np.flatnonzero(known)
    return (
        np.split(indices, np.flatnonzero(np.diff(indices) > 1) + 1)
        if len(indices)
        else []
    )


def picture(datum: Datum) -> str:
    """The elevations round the tank as a line in SVG; nothing without stations."""
    z = datum.stations["z"]
    known = np.isfinite(z)
    if not known.any():
        return ""
    low, high = float(z[known].min()), float(z[known].max())
    span = max(high - low, 1e-6)
    x = MARGIN + (WIDTH - 2 * MARGIN) * datum.stations["azimuth_deg"] / 360.0
    y = MARGIN + (HEIGHT - 2 * MARGIN) * (high - z) / span
    lines = "".join(
        '<polyline fill="none" stroke="#1f4e8c" stroke-width="1.5" points="'
        + " ".join(f"{x[i]:.1f},{y[i]:.1f}" for i in run)
        + '"/>'
        for run in _runs(known)
    )
    title = f"elevation of the datum, 0 to 360 deg, {1e3 * (high - low):.1f} mm from low to high"
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" role="img" width="{WIDTH:.0f}" '
        f'height="{HEIGHT:.0f}" viewBox="0 0 {WIDTH:.0f} {HEIGHT:.0f}"><title>{title}</title>'
        f"{lines}</svg>"
    )


def _table(rows: list[tuple[str, str]]) -> str:
    cells = "".join(
        f'<tr><th style="text-align:left">{escape(name)}</th>'
        f'<td style="text-align:left">{escape(text)}</td></tr>'
        for name, text in rows
    )
    return f"<table>{cells}</table>"


def page_of(datum: Datum) -> str:
    """The verdict, the main figures, and the picture."""
    word = datum.verdict.word if datum.verdict is not None else datum.status
    return f"<div><strong>{escape(word)}</strong>{_table(_rows(datum))}{picture(datum)}</div>"


def _moved(movement: Movement) -> str:
    if movement.message:
        return movement.message
    mean = f"mean {_shown(movement.mean.value, 1, 1e3)} mm"
    return f"{movement.significant} of {movement.matched} stations moved, {mean}"


def movements_of(comparison: Comparison) -> str:
    """What moved between the first survey and each of the others."""
    dates = [f" ({date})" for date in comparison.dates] or [""] * len(comparison.names)
    named = [n + d for n, d in zip(comparison.names, dates, strict=True)]
    rows = [("since", named[0])]
    rows += [
        (name, _moved(m))
        for name, m in zip(named[1:], comparison.movements, strict=True)
    ]
    return f"<div>{_table(rows)}</div>"
