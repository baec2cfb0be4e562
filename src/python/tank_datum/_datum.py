"""The result of a run."""

from __future__ import annotations

import copy
import json
import os
import stat
import tempfile
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from tank_datum import _core, _html
from tank_datum._arguments import path_bytes
from tank_datum._errors import file_error, option_error
from tank_datum._extras import imported
from tank_datum._figures import Figures

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from tank_datum._plot import Chart


class Datum(Figures):
    """What a scan gave: one row of `stations` per azimuth, and what their shape means.

    stations: structured array of the columns of stations.csv (azimuth_deg, x, y, z, sigma_z, ...,
    flag); unknown values are NaN. edge_points: array (n, 3) of the paper's edge points, in order
    round the tank. shell_points: structured array of the columns of shell.csv (azimuth_deg,
    height, radius, deviation, sigma, n, offset). All three are read-only: `.copy()` gives one that
    can be changed. All other figures are those of datum.json by its keys: dicts whose keys are
    attributes too. Metres, degrees, the scan's own frame. Two are equal when all of this is.
    """

    stations: NDArray[Any]
    edge_points: NDArray[np.float64]
    shell_points: NDArray[Any]

    def __init__(
        self,
        record: dict[str, Any],
        stations: NDArray[Any],
        edge_points: NDArray[np.float64],
        shell_points: NDArray[Any],
        *,
        files: dict[str, bytes] | None = None,
        summary: str = "",
        source: str = "",
        result: _core.Result | None = None,
    ) -> None:
        self.stations, self.edge_points = stations, edge_points
        self.shell_points = shell_points
        self._lock_arrays()
        self._record, self._files, self._result = record, files, result
        self._summary, self._source = summary, source

    @classmethod
    def _of(cls, result: _core.Result) -> Datum:
        stations = result.stations()  # without them there are no files of points either
        return cls(
            result.record(),
            stations,
            result.edge_points() if len(stations) else np.empty((0, 3)),
            result.shell_points(),
            summary=result.summary(),
            result=result,
        )

    @property
    def source(self) -> str:
        """Where it was loaded from, or the scans it is of; what a comparison calls it."""
        scans = ", ".join(file["path"] for file in self._record["input"]["files"])
        return self._source or scans or "datum in memory"

    def covariance(self) -> NDArray[np.float64]:
        """Covariance of the stations' z [m2], in their order; NaN where a station is missing.

        Shape (n, n). Shared errors are in it: those of the scanner's setups.
        """
        own, shared = self._errors()
        return np.asarray(np.diag(own**2) + shared.T @ shared)

    def _errors(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """The stations' own errors, and the factors of those they share. Raises ValueError, TypeError."""
        count = len(self.stations)
        given = self._record.get("covariance")
        if given is None:
            return np.full(count, np.nan), np.full((1, count), np.nan)
        own = np.array(given["independent"], dtype=float).reshape(count)
        return own, np.array(given["factors"], dtype=float).reshape(-1, count)

    def to_dict(self) -> dict[str, Any]:
        """Everything, as in datum.json."""
        return copy.deepcopy(self._record)

    def to_json(self) -> str:
        """The text of datum.json."""
        if self._result is not None:
            return self._result.json()
        files = self._files or {}
        if "datum.json" in files:
            return files["datum.json"].decode("utf-8")
        return json.dumps(self._record, indent=2) + "\n"

    def to_pandas(self) -> Any:
        """The stations as a DataFrame, a row each; needs pandas."""
        return imported("pandas", "to_pandas", "pandas").DataFrame(
            {n: self.stations[n] for n in self.stations.dtype.names or ()}
        )

    def summary(self) -> str:
        """What the command prints; of one that was loaded, its main lines."""
        return self._summary or _html.summary_of(self)

    def files(self) -> dict[str, bytes]:
        """The files that the command writes, by name; of one loaded, those that were there."""
        if self._files is None:
            with tempfile.TemporaryDirectory() as folder:
                assert self._result is not None
                self._result.write(os.fsencode(folder))
                self._files = {
                    path.name: path.read_bytes() for path in Path(folder).iterdir()
                }
        return dict(self._files)

    def save(self, folder: str | os.PathLike[str]) -> None:
        """Writes these files into a folder as the command does: whole or not at all.

        What the folder holds of others is kept. A signal that ends the process meanwhile ends it
        behind. Raises FileError.
        """
        _core.save_files(path_bytes("report", "folder", folder), self.files())

    def report(self, path: str | os.PathLike[str]) -> None:
        """Writes the page report.html, whole or not at all.

        A file of the same name that is no report is kept under another name. Raises FileError;
        OptionError when the result was loaded without its page.
        """
        to = path_bytes("report", "path", path)
        if stat.S_ISFIFO(_mode(to)):
            raise file_error("report", os.fsdecode(to), "a pipe", "a file")
        page = self.files().get("report.html")
        if page is None:
            raise option_error(
                "report",
                "report.html",
                "not with the result loaded",
                "a folder that holds it",
            )
        _core.save_page(to, page)

    def plot(self, kind: Chart = "elevation", axes: Axes | None = None) -> Axes:
        """One of the report's charts with matplotlib (the extra `plot`).

        kind: elevation, out_of_plane, curvature, sigma, plan, residuals, roundness, plumbness,
        movement or covariance. axes: to draw into; by default new ones. Raises OptionError for
        another kind, and for one that this result has nothing of.
        """
        from tank_datum import _plot

        return _plot.draw(self, kind, axes)

    def __repr__(self) -> str:
        return f"<tank_datum.Datum {self.status}, {len(self.stations)} stations>"

    def _repr_html_(self) -> str:
        return _html.page_of(self)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Datum):
            return NotImplemented
        return (
            self.to_json() == other.to_json()
            and same(self.stations, other.stations)
            and same(self.shell_points, other.shell_points)
            and np.array_equal(self.edge_points, other.edge_points)
        )

    def __hash__(self) -> int:
        return hash(self.to_json())

    def __getstate__(self) -> dict[str, Any]:
        self.files()
        return {**self.__dict__, "_result": None}

    def __setstate__(self, state: dict[str, Any]) -> None:
        self.__dict__.update(state)
        self._lock_arrays()

    def _lock_arrays(self) -> None:
        """Files and pages are of these: they stay as they are."""
        for array in (self.stations, self.edge_points, self.shell_points):
            array.setflags(write=False)

    def __copy__(self) -> Datum:
        made = Datum.__new__(Datum)
        made.__dict__.update(self.__dict__)
        return made

    def __deepcopy__(self, memo: dict[int, Any]) -> Datum:
        made = self.__copy__()
        made._record = copy.deepcopy(self._record, memo)
        return made


def _mode(path: bytes) -> int:
    """Of what has the name; 0: nothing has."""
    try:
        return os.stat(path).st_mode
    except OSError:
        return 0


def same(a: NDArray[Any], b: NDArray[Any]) -> bool:
    """Whether two structured arrays are equal, NaN where NaN."""
    if a.dtype != b.dtype or a.shape != b.shape:
        return False
    return all(
        np.array_equal(a[name], b[name], equal_nan=a[name].dtype.kind == "f")
        for name in a.dtype.names or ()
    )
