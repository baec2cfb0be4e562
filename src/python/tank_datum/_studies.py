"""What studies need: the paper's curves, the codes' limits, simulated scans."""

from __future__ import annotations

import json
import math
import os
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray
from tank_datum_qa._regular_file import read_regular_text

from tank_datum import _core
from tank_datum._arguments import path_bytes, real, whole
from tank_datum._datum import Datum
from tank_datum._errors import file_error, option_error, refused_by_system, short
from tank_datum._record import Record


class Limit(Record):
    """A row of the limits of the codes: factor times powers of D H Y E L S, at most `at_most`."""

    code: str
    clause: str
    name: str
    quantity: str
    judged: bool
    factor: float
    powers: dict[str, int]
    at_most: float | None
    unit: str
    diameter_from: float
    diameter_to: float | None
    roof: str | None
    foundation: str | None
    service: str | None
    trust: str
    citation: str


class Curve(Record):
    """How well one of the paper's curves goes through the stations between its points [m]."""

    kind: str
    """Lagrange, Bezier, polynomial or B-spline"""
    rms: float
    largest: float
    overshoot: float


def limits(path: str | os.PathLike[str] | None = None) -> list[Limit]:
    """The limits of the codes that checks judge by: the library's own, or those of a file.

    Raises OptionError naming file and line, FileError.
    """
    file = b"" if path is None else path_bytes("limits", "path", path)
    return [Limit(row) for row in _core.limits(file)]


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
        try:
            if np.iscomplexobj(line):
                raise TypeError
            table = np.asarray(line, dtype=np.float64)
        except (TypeError, ValueError):
            wanted = "a Datum, or an array (n, 2) of numbers"
            raise TypeError(f"line = {short(line)}, expected {wanted}") from None
    if table.ndim != 2 or table.shape[1] != 2:
        raise option_error(
            "curves", "line", f"shape {table.shape}", "(n, 2): azimuth, elevation"
        )
    if not 0.0 < real("to_deg", to_deg) - real("from_deg", from_deg) <= 360.0:
        raise option_error(
            "options", "to_deg", to_deg, "more than from_deg, by a turn at most"
        )
    arc = _arc(table[np.isfinite(table).all(axis=1)], from_deg, to_deg)
    found = _core.compare_curves(arc, whole("points", points), whole("degree", degree))
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

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Simulation):
            return NotImplemented
        return (
            self.truth == other.truth
            and self.rays == other.rays
            and np.array_equal(self.points, other.points)
            and np.array_equal(self.intensity, other.intensity)
            and np.array_equal(self.setups, other.setups)
        )

    __hash__ = None  # type: ignore[assignment]

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
    text = (
        _scene_json(scene)
        if isinstance(scene, Mapping)
        else _scene_text(Path(os.fsdecode(path_bytes("scene", "scene", scene))))
    )
    file = b"" if output is None else path_bytes("scene", "output", output)
    made = _core.simulate(text, file, whole("threads", threads))
    return Simulation(
        points=made.get("points", np.empty((0, 3))),
        intensity=made.get("intensity", np.empty(0)),
        setups=made.get("setups", np.empty(0, dtype=np.uint16)),
        truth=Truth(made["truth"]),
        rays=made["rays"],
    )


def _scene_json(scene: Mapping[str, Any]) -> str:
    """NumPy's numbers and arrays are those of JSON."""
    wanted = "a dict of numbers, texts, lists and dicts"
    try:
        text = json.dumps(scene, default=_plain)
    except (TypeError, ValueError, RecursionError) as error:
        raise option_error("scene", "scene", str(error), wanted) from None
    if bad := _not_finite("scene", json.loads(text)):
        raise option_error("scene", bad, "not finite", "a finite number")
    return text


def _not_finite(place: str, value: object) -> str:
    """Where the first number is that JSON has no word for; or nothing."""
    if isinstance(value, dict):
        inner = [(f"{place}.{key}", one) for key, one in value.items()]
    elif isinstance(value, list):
        inner = [(f"{place}[{i}]", one) for i, one in enumerate(value)]
    else:
        return place if isinstance(value, float) and not math.isfinite(value) else ""
    return next((bad for at, one in inner if (bad := _not_finite(at, one))), "")


def _plain(value: object) -> object:
    if isinstance(value, np.generic | np.ndarray):
        return value.tolist()
    if isinstance(value, Mapping):
        return dict(value)
    raise TypeError(f"{short(value)}, of {type(value).__name__}")


def _scene_text(path: Path) -> str:
    try:
        text = read_regular_text(path)
        json.loads(text)
    except OSError as error:
        raise refused_by_system(
            "scene", str(path), error, "a scene file (JSON)"
        ) from None
    except (ValueError, RecursionError) as error:
        raise file_error(
            "scene", str(path), str(error), "a scene file (JSON)"
        ) from None
    return text
