"""The report's charts with matplotlib."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Literal

import numpy as np
from numpy.typing import NDArray

from tank_datum._errors import OptionError, option_error, short
from tank_datum._extras import imported

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from tank_datum._datum import Datum
    from tank_datum._record import Record

Chart = Literal[
    "elevation",
    "out_of_plane",
    "curvature",
    "sigma",
    "plan",
    "residuals",
    "roundness",
    "plumbness",
    "movement",
    "covariance",
]
MM = 1e3
LIMIT_95 = 1.96


def _round_the_tank(axes: Axes, label: str) -> None:
    axes.set_xlim(0, 360)
    axes.set_xticks(range(0, 361, 45))
    axes.set_xlabel("azimuth [deg]")
    axes.set_ylabel(label)


def _nothing(kind: str, why: str) -> OptionError:
    return option_error(
        "plot", "kind", kind, f"a chart that this result has figures for: {why}"
    )


def _values(datum: Datum, column: str) -> NDArray[np.float64]:
    """A column of the stations; NaN of one that the result was loaded without."""
    stations = datum.stations
    if column not in (stations.dtype.names or ()):
        return np.full(len(stations), np.nan)
    return np.asarray(stations[column], dtype=np.float64)


def _line(
    datum: Datum, kind: str, axes: Axes, column: str, label: str, scale: float
) -> None:
    values = _values(datum, column)
    if not np.isfinite(values).any():
        raise _nothing(kind, f"{column} is not known")
    axes.plot(datum.stations["azimuth_deg"], scale * values, lw=1.2)
    _round_the_tank(axes, label)


def _elevation(datum: Datum, kind: str, axes: Axes) -> None:
    stations = datum.stations
    z, sigma = stations["z"], stations["sigma_z"]
    if not np.isfinite(z).any():
        raise _nothing(kind, "no elevation is known")
    mean = float(np.nanmean(z))
    above = MM * (z - mean)
    axes.fill_between(
        stations["azimuth_deg"],
        above - LIMIT_95 * MM * sigma,
        above + LIMIT_95 * MM * sigma,
        alpha=0.3,
        label="95 %",
    )
    axes.plot(stations["azimuth_deg"], above, lw=1.2, label="z")
    if "z_paper" in (stations.dtype.names or ()):
        axes.plot(
            stations["azimuth_deg"],
            MM * (stations["z_paper"] - mean),
            lw=0.8,
            label="paper",
        )
        axes.plot(
            stations["azimuth_deg"],
            MM * (stations["z_tilt"] - mean),
            lw=0.8,
            label="plane",
        )
    axes.set_title(f"Elevation about {mean:.4f} m")
    axes.legend()
    _round_the_tank(axes, "elevation [mm]")


def _plan(datum: Datum, kind: str, axes: Axes) -> None:
    stations = datum.stations
    if not np.isfinite(stations["z"]).any() or "x" not in (stations.dtype.names or ()):
        raise _nothing(kind, "no station is known")
    drawn = axes.scatter(
        stations["x"], stations["y"], c=MM * stations["u"], s=8, cmap="coolwarm"
    )
    axes.figure.colorbar(drawn, ax=axes, label="out of plane [mm]")
    axes.set_aspect("equal")
    axes.set_xlabel("x [m]")
    axes.set_ylabel("y [m]")


def _residuals(datum: Datum, kind: str, axes: Axes) -> None:
    """Edge points above the refined datum: why the paper's curve is not the datum."""
    tank, stations = datum.tank, datum.stations
    if (
        tank is None
        or not len(datum.edge_points)
        or not np.isfinite(stations["z"]).any()
    ):
        raise _nothing(kind, "there are no edge points")
    x, y = (datum.edge_points[:, :2] - tank.center).T
    turned = datum.options.get("stations") or {}
    azimuth = np.degrees(np.arctan2(y, x)) - turned.get("zero_azimuth_deg", 0.0)
    azimuth = np.mod(-azimuth if turned.get("clockwise") else azimuth, 360.0)
    known = np.isfinite(stations["z"])
    datum_there = np.interp(
        azimuth, stations["azimuth_deg"][known], stations["z"][known], period=360.0
    )
    axes.plot(azimuth, MM * (datum.edge_points[:, 2] - datum_there), ".", ms=2)
    _round_the_tank(axes, "edge points above the datum [mm]")


def _column(rows: Sequence[Record], name: str) -> NDArray[np.float64]:
    return np.array(
        [np.nan if row[name] is None else row[name] for row in rows], dtype=float
    )


def _roundness(datum: Datum, kind: str, axes: Axes) -> None:
    """Radial deviation of the shell round the tank, a line a height."""
    points = datum.shell_points
    if not len(points):
        raise _nothing(kind, "the shell was not surveyed")
    for height in np.unique(points["height"]):
        row = points[points["height"] == height]
        axes.plot(
            row["azimuth_deg"], MM * row["deviation"], lw=1, label=f"{height:g} m"
        )
    axes.legend(title="above the datum")
    _round_the_tank(axes, "radial deviation [mm]")


def _plumbness(datum: Datum, kind: str, axes: Axes) -> None:
    rows = [] if datum.shell is None else datum.shell.plumbness
    if not rows:
        raise _nothing(kind, "the shell is not seen at two heights")
    azimuth, offset = _column(rows, "azimuth_deg"), MM * _column(rows, "offset")
    band = LIMIT_95 * MM * _column(rows, "sigma")
    axes.fill_between(azimuth, offset - band, offset + band, alpha=0.3, label="95 %")
    axes.plot(azimuth, offset, lw=1.2, label="offset")
    axes.legend()
    _round_the_tank(axes, "plumbness, outwards [mm]")


def _movement(datum: Datum, kind: str, axes: Axes) -> None:
    moved = datum.movement
    if moved is None or not moved.stations:
        raise _nothing(kind, "it was not compared with a baseline")
    azimuth, dz = (
        _column(moved.stations, "azimuth_deg"),
        MM * _column(moved.stations, "dz"),
    )
    lod = MM * _column(moved.stations, "lod95")
    axes.fill_between(azimuth, -lod, lod, alpha=0.25, label="level of detection, 95 %")
    axes.plot(azimuth, dz, lw=1.2, label="movement")
    significant = np.array([bool(row["significant"]) for row in moved.stations])
    axes.plot(azimuth[significant], dz[significant], "r.", label="significant")
    axes.legend()
    _round_the_tank(axes, "movement [mm]")


def _covariance(datum: Datum, kind: str, axes: Axes) -> None:
    covariance = datum.covariance()
    if not np.isfinite(covariance).any():
        raise _nothing(kind, "the covariance is not known")
    drawn = axes.imshow(MM**2 * covariance, origin="lower", cmap="viridis")
    axes.figure.colorbar(drawn, ax=axes, label="covariance [mm2]")
    axes.set_xlabel("station")
    axes.set_ylabel("station")


def _out_of_plane(datum: Datum, kind: str, axes: Axes) -> None:
    _line(datum, kind, axes, "u", "out of plane [mm]", MM)
    axes.plot(datum.stations["azimuth_deg"], MM * _values(datum, "u_fit"), lw=0.8)


def _curvature(datum: Datum, kind: str, axes: Axes) -> None:
    _line(datum, kind, axes, "curvature", "curvature [1/m]", 1.0)


def _sigma(datum: Datum, kind: str, axes: Axes) -> None:
    _line(datum, kind, axes, "sigma_z", "standard error of z [mm]", MM)


KINDS: dict[Chart, Callable[[Datum, str, Axes], None]] = {
    "elevation": _elevation,
    "out_of_plane": _out_of_plane,
    "curvature": _curvature,
    "sigma": _sigma,
    "plan": _plan,
    "residuals": _residuals,
    "roundness": _roundness,
    "plumbness": _plumbness,
    "movement": _movement,
    "covariance": _covariance,
}


def _new_axes() -> Axes:
    plt = imported("matplotlib.pyplot", "plot", "plot")
    axes: Axes = plt.subplots(layout="constrained")[1]
    return axes


def draw(datum: Datum, kind: Chart, axes: Axes | None) -> Axes:
    """One chart; see Datum.plot."""
    if not isinstance(kind, str) or kind not in KINDS:
        said = kind if isinstance(kind, str) else short(kind)
        raise option_error("plot", "kind", said, ", ".join(KINDS))
    if axes is not None and not hasattr(axes, "scatter"):
        raise TypeError(f"axes = {short(axes)}, expected Axes of matplotlib, or None")
    drawn: Axes = _new_axes() if axes is None else axes
    KINDS[kind](datum, kind, drawn)
    return drawn
