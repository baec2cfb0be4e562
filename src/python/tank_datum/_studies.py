"""What studies need: the paper's curves, the codes' limits, simulated scans."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray
from tank_datum_qa._regular_file import read_regular_text

from tank_datum import _core
from tank_datum._datum import Datum
from tank_datum._errors import file_error, option_error
from tank_datum._records import Curve, Limit, Record


def limits(path: str | os.PathLike[str] | None = None) -> list[Limit]:
    """The limits of the codes that checks judge by: the library's own, or those of a file.

    Raises OptionError naming file and line, FileError.
    """
    return [Limit(row) for row in _core.limits("" if path is None else os.fspath(path))]


def limits_text() -> str:
    """The library's own limits as a file for the option `limits`, to be changed."""
    return _core.limits_text()


def compare_curves(
    line: Datum | ArrayLike,
    *,
    points: int = 10,
    degree: int = 3,
    from_deg: float = 0.0,
    to_deg: float = 360.0,
) -> list[Curve]:
    """The paper's four curves through the same points of a datum, and how well each does.

    line: a Datum, or an array (n, 2) of azimuth [deg] and elevation [m]; points: that the curves
    are laid through, 4 to 50; degree: of the least-squares polynomial; from_deg, to_deg: the arc,
    a turn at most. The places between the points check the curves.

    Raises OptionError for a refused argument, and for a line with fewer than points + 1 known
    places.
    """
    if isinstance(line, Datum):
        table = np.column_stack([line.stations["azimuth_deg"], line.stations["z"]])
    else:
        table = np.asarray(line, dtype=np.float64)
    if table.ndim != 2 or table.shape[1] != 2:
        raise option_error(
            "curves", "line", f"shape {table.shape}", "(n, 2): azimuth, elevation"
        )
    if not 0.0 < to_deg - from_deg <= 360.0:
        raise option_error(
            "options", "to_deg", to_deg, "more than from_deg, by a turn at most"
        )
    arc = _arc(table[np.isfinite(table).all(axis=1)], from_deg, to_deg)
    found = _core.compare_curves(arc, points, degree)
    if not found:
        raise option_error("curves", "known places", len(arc), f"more than {points}")
    return [Curve(figures) for figures in found]


def _arc(
    line: NDArray[np.float64], from_deg: float, to_deg: float
) -> NDArray[np.float64]:
    """The places from one azimuth to another, in order; the first again at the end of a turn."""
    first = from_deg + np.mod(line[:, 0] - from_deg, 360.0)
    both = np.vstack(
        [np.column_stack([first + turn, line[:, 1]]) for turn in (0.0, 360.0)]
    )
    arc = both[both[:, 0] <= to_deg]
    return arc[np.argsort(arc[:, 0], kind="stable")]


class Truth(Record):
    """What a simulated scan should give: keys of truth.json; metres, degrees."""

    seed: int
    options: dict[str, Any]
    scanners: list[Any]
    tanks: list[dict[str, Any]]


@dataclass(frozen=True, eq=False)
class Simulation:
    """A simulated scan. points: (n, 3) [m], intensity: (n,), setups: (n,) index of the scanner."""

    points: NDArray[np.float64]
    intensity: NDArray[np.float64]
    setups: NDArray[np.uint16]
    truth: Truth
    rays: int

    def by_setup(self) -> list[NDArray[np.float64]]:
        """The points of each scanner."""
        return [self.points[self.setups == number] for number in np.unique(self.setups)]


Scene = Mapping[str, Any] | str | os.PathLike[str]


def simulate(
    scene: Scene, output: str | os.PathLike[str] | None = None, *, threads: int = 0
) -> Simulation:
    """A terrestrial laser scan of a storage tank by ray casting, with its true datum.

    scene: a dict as a scene file of tank_datum_synth holds, or the path of one; what is not given
    keeps its default. output: a PCD to write, with OUT.truth.json beside it; then the arrays are
    empty. The points depend on the scene alone. Raises OptionError naming the key, FileError.
    """
    text = json.dumps(scene) if isinstance(scene, Mapping) else _scene_text(Path(scene))
    made = _core.simulate(text, "" if output is None else os.fspath(output), threads)
    return Simulation(
        points=made.get("points", np.empty((0, 3))),
        intensity=made.get("intensity", np.empty(0)),
        setups=made.get("setups", np.empty(0, dtype=np.uint16)),
        truth=Truth(made["truth"]),
        rays=made["rays"],
    )


def _scene_text(path: Path) -> str:
    try:
        text = read_regular_text(path)
        json.loads(text)
    except OSError as error:
        raise file_error(
            "scene", str(path), error.strerror or "", "a scene file (JSON)"
        ) from None
    except ValueError as error:
        raise file_error(
            "scene", str(path), str(error), "a scene file (JSON)"
        ) from None
    return text
