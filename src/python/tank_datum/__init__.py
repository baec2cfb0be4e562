"""The datum of a storage tank, the line where its shell meets the foundation, from a laser scan::

    import tank_datum
    datum = tank_datum.extract_datum("scan.pcd", stations=360)
    datum.stations["z"], datum.tilt, datum.status

Lengths are metres, angles degrees, coordinates the scan's own.
"""

from __future__ import annotations

import csv
import io
import json
import os
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tank_datum import _core
from tank_datum._core import FileError, OptionError, __version__

__all__ = [
    "Datum",
    "FileError",
    "OptionError",
    "__version__",
    "defaults",
    "extract_datum",
]

_TEXTS = {"flag": "U12", "reason": "U13"}
_COUNTS = {"station": "i8"}


def _table(text: str) -> NDArray[Any]:
    """stations.csv as a structured array; an empty cell is NaN."""
    header, *rows = list(csv.reader(io.StringIO(text)))
    kinds = {**_TEXTS, **_COUNTS}
    table = np.zeros(
        len(rows), dtype=[(name, kinds.get(name, "f8")) for name in header]
    )
    for at, name in enumerate(header):
        column = [row[at] for row in rows]
        table[name] = (
            column if name in kinds else [float(cell or "nan") for cell in column]
        )
    return table


class Datum:
    """What a scan gave: one row of `stations` per azimuth, and what their shape means.

    stations: structured array of the columns of stations.csv (azimuth_deg, x, y, z, sigma_z, ...,
    flag); unknown values are NaN. edge_points: array (n, 3) of the paper's edge points, in order
    round the tank. All other figures are those of datum.json.
    """

    def __init__(self, made: dict[str, Any]) -> None:
        self._json: str = made["json"]
        self._dict: dict[str, Any] = json.loads(self._json)
        self._summary: str = made["summary"]
        self.stations: NDArray[Any] = _table(made["csv"])
        self.edge_points: NDArray[np.float64] = made["edge_points"]

    @property
    def status(self) -> str:
        """ok, partial, doubtful, no_tank, no_crease, too_few_points or fit_failed."""
        return str(self._dict["status"])

    @property
    def message(self) -> str:
        """Why there is no datum, or what of it is missing."""
        return str(self._dict["message"])

    @property
    def usable(self) -> bool:
        """Whether there is a datum: status ok or partial."""
        return self.status in ("ok", "partial")

    @property
    def setups(self) -> list[dict[str, Any]]:
        """One entry a setup of the scanner: what it was moved by, and how it agreed with the others."""
        return list(self._dict.get("setups") or [])

    def covariance(self) -> NDArray[np.float64]:
        """Covariance of the stations' z [m2], in their order; NaN where a station is missing.

        Shape (n, n). Shared errors are in it: those of the scanner's setups.
        """
        given = self._dict.get("covariance")
        if given is None:
            return np.full((len(self.stations), len(self.stations)), np.nan)
        own = np.array(given["independent"], dtype=float)
        shared = np.array(given["factors"], dtype=float).reshape(-1, len(own))
        return np.asarray(np.diag(own**2) + shared.T @ shared)

    @property
    def tank(self) -> dict[str, Any] | None:
        """Center [m], radius [m], coverage_deg, side; None without a tank."""
        found: dict[str, Any] | None = self._dict.get("tank")
        return found

    @property
    def tilt(self) -> dict[str, Any] | None:
        """Slope [m/m], angle_arcsec, direction_deg (towards the highest point), sigma_slope, ..."""
        found: dict[str, Any] | None = self._dict.get("tilt")
        return found

    @property
    def antipodal(self) -> dict[str, Any] | None:
        """The paper's inclination: max_h [m] over a diameter [m], angle_deg, azimuth_deg."""
        found: dict[str, Any] | None = self._dict.get("antipodal")
        return found

    @property
    def movement(self) -> dict[str, Any] | None:
        """Per station dz, lod95 [m] and significance since the baseline; None without one."""
        found: dict[str, Any] | None = self._dict.get("movement")
        return found

    @property
    def shell(self) -> dict[str, Any] | None:
        """Roundness, plumbness, lean; None when no shell above the foot was seen."""
        found: dict[str, Any] | None = self._dict.get("shell")
        return found

    @property
    def harmonics(self) -> list[dict[str, Any]]:
        """n, amplitude [m], phase_deg, sigma [m]; empty when they were not fitted."""
        found: list[dict[str, Any]] = self._dict.get("harmonics", [])
        return found

    @property
    def out_of_plane(self) -> dict[str, Any] | None:
        """Order, adjusted_r2, max_abs_u [m], max_curvature [1/m], second_differences, ..."""
        found: dict[str, Any] | None = self._dict.get("out_of_plane")
        return found

    @property
    def checks(self) -> list[dict[str, Any]]:
        """Rules of the codes with value, limit and verdict; empty when none were made."""
        found: list[dict[str, Any]] = self._dict.get("checks", [])
        return found

    def to_dict(self) -> dict[str, Any]:
        """Everything, as in datum.json."""
        result: dict[str, Any] = json.loads(self._json)
        return result

    def to_json(self) -> str:
        """The text of datum.json."""
        return self._json

    def summary(self) -> str:
        """What the command prints."""
        return self._summary

    def __repr__(self) -> str:
        return f"<tank_datum.Datum {self.status}, {len(self.stations)} stations>"


def defaults() -> dict[str, Any]:
    """The options of extract_datum and their defaults, which are the C++ library's."""
    found: dict[str, Any] = _core.defaults()
    return found


def extract_datum(
    points: Any,
    *,
    progress: Callable[[str], object] | None = None,
    **options: Any,
) -> Datum:
    """The datum of the best seen tank in a scan, or of the one picked.

    points:
        an array of shape (n, 3), float32 or float64 of any stride, vertical z, in `units`; the
        path of a scan of any format; or a list of arrays or of paths, which are stations of one
        tank. E57, LAZ and COPC need pip install 'tank_datum[formats]'.
        Points that are not finite are dropped. Nothing is copied.
    progress:
        called with the name of each stage as it begins; what it raises ends the run.
    options:
        those of the command line with underscores; help() lists them, defaults() their values.

    Raises OptionError (a ValueError) for a refused option, FileError (an OSError) for a file that
    cannot be read, TypeError for points or options of the wrong type. What the scan lacks is no
    exception but the result's status. Ctrl-C is heard within a second.
    """
    sources: Sequence[Any] = points if isinstance(points, list | tuple) else [points]
    paths = [os.fspath(s) for s in sources if isinstance(s, str | os.PathLike)]
    arrays = [s for s in sources if not isinstance(s, str | os.PathLike)]
    if paths and arrays:
        raise TypeError(
            "points = paths and arrays together, expected the one or the other"
        )
    if not sources:
        raise TypeError("points = [], expected an array or a path")
    return Datum(_core.extract(paths, arrays, options, progress))


_KEYWORDS = _core.keyword_help()
if isinstance(_KEYWORDS, str):  # the documentation is made without the compiled part
    extract_datum.__doc__ = f"{extract_datum.__doc__}\n    Options:\n{_KEYWORDS}"
