"""Where a scan of an E57 file stands in the file's frame."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tank_datum._foreign import Unreadable

TURN_TOLERANCE = 1e-3  # of the length of a quaternion, which is 1

Array = NDArray[np.float64]


@dataclass
class Pose:
    """From a scan's own frame to the file's."""

    turn: Array = field(default_factory=lambda: np.eye(3))
    shift: Array = field(default_factory=lambda: np.zeros(3))

    def apply(self, columns: Sequence[Array]) -> Array:
        """The points of columns x, y and z."""
        points = np.empty((len(columns[0]), 3))
        turned: Iterable[Array] = columns
        if not np.array_equal(self.turn, np.eye(3)):
            # no matrix product: its last digit may depend on the threads
            x, y, z = columns
            turned = (x * a + y * b + z * c for a, b, c in self.turn)
        for i, column in enumerate(turned):
            points[:, i] = column
        if self.shift.any():
            points += self.shift
        return points


def turn_of(quaternion: Array) -> Array:
    """The matrix of a unit quaternion w, x, y, z."""
    w, x, y, z = quaternion / np.linalg.norm(quaternion)
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ]
    )


def numbers_of(node: Any, names: str) -> Array:
    return np.array([float(node[name].value()) for name in names])


def pose_of(scan: Any, what: str) -> Pose:
    pose = Pose()
    if not scan.isDefined("pose"):
        return pose
    node = scan["pose"]
    if node.isDefined("translation"):
        pose.shift = numbers_of(node["translation"], "xyz")
    if node.isDefined("rotation"):
        quaternion = numbers_of(node["rotation"], "wxyz")
        if not abs(np.linalg.norm(quaternion) - 1) < TURN_TOLERANCE:
            shown = " ".join(f"{v:g}" for v in quaternion)
            raise Unreadable(f"rotation of {what}", shown, "a quaternion of length 1")
        pose.turn = turn_of(quaternion)
    if not np.isfinite(pose.shift).all():
        shown = " ".join(f"{v:g}" for v in pose.shift)
        raise Unreadable(f"translation of {what}", shown, "three numbers")
    return pose
