"""Straight lines through values with known standard errors: rate, interval, date of a limit."""

from __future__ import annotations

import functools
import math
from dataclasses import dataclass
from statistics import NormalDist

import numpy as np
from numpy.typing import ArrayLike, NDArray

LEVEL = 0.95  # of every interval


@dataclass(frozen=True)
class Line:
    """value(t) = level + rate (t - at). covariance of (level, rate), the scatter about the line
    included where it is larger than the standard errors say; then `degrees` are its degrees of
    freedom, else 0 and the errors are normal."""

    at: float
    level: float
    rate: float
    covariance: NDArray[np.float64]
    degrees: int = 0

    def sigma_rate(self) -> float:
        return math.sqrt(self.covariance[1, 1])

    def quantile(self, chance: float) -> float:
        """Of |error| over its standard error, exceeded with this chance."""
        if self.degrees:
            return student(1.0 - chance / 2.0, self.degrees)
        return NormalDist().inv_cdf(1.0 - chance / 2.0)

    def interval(self, chance: float = 1.0 - LEVEL) -> tuple[float, float]:
        """Of the rate."""
        reach = self.quantile(chance) * self.sigma_rate()
        return self.rate - reach, self.rate + reach

    def chance(self) -> float:
        """That a rate of zero shows one so large: the p-value, two-sided."""
        ratio = abs(self.rate) / self.sigma_rate() if self.sigma_rate() > 0.0 else 0.0
        if self.degrees:
            return 2.0 * (1.0 - student_share(ratio, self.degrees))
        return math.erfc(ratio / math.sqrt(2.0))


def fit_line(times: ArrayLike, values: ArrayLike, sigmas: ArrayLike) -> Line | None:
    """Weighted least squares; None with fewer than two times, or an error that is not above zero.

    sigmas: standard errors of the values, independent.
    """
    t, y, s = (np.asarray(v, dtype=float) for v in (times, values, sigmas))
    if len(np.unique(t)) < 2 or not np.all(s > 0.0):
        return None
    weights = 1.0 / s**2
    at = float(np.sum(weights * t) / np.sum(weights))
    design = np.column_stack([np.ones_like(t), t - at])
    found, covariance, degrees = _least_squares(design, y, weights)
    return Line(at, float(found[0]), float(found[1]), covariance, degrees)


def fit_line_and_level(
    times: ArrayLike, levels: ArrayLike, values: ArrayLike, sigmas: ArrayLike
) -> tuple[Line, float, float] | None:
    """The same with a part that follows a level: the line, slope by level, its standard error.

    None where the two cannot be told apart: fewer than four values, or levels and times that
    follow each other (correlation above 0.95).
    """
    t, h, y, s = (np.asarray(v, dtype=float) for v in (times, levels, values, sigmas))
    if len(t) < 4 or np.ptp(t) == 0.0 or np.ptp(h) == 0.0 or not np.all(s > 0.0):
        return None
    if abs(np.corrcoef(t, h)[0, 1]) > 0.95:
        return None
    weights = 1.0 / s**2
    at = float(np.sum(weights * t) / np.sum(weights))
    design = np.column_stack([np.ones_like(t), t - at, h - h.mean()])
    found, covariance, degrees = _least_squares(design, y, weights)
    line = Line(at, float(found[0]), float(found[1]), covariance[:2, :2], degrees)
    return line, float(found[2]), math.sqrt(covariance[2, 2])


def _least_squares(
    design: NDArray[np.float64], y: NDArray[np.float64], weights: NDArray[np.float64]
) -> tuple[NDArray[np.float64], NDArray[np.float64], int]:
    normal = np.linalg.inv(design.T @ (weights[:, None] * design))
    covariance = np.asarray(normal, dtype=np.float64)
    found = covariance @ design.T @ (weights * y)
    degrees = len(y) - design.shape[1]
    misfit = float(np.sum(weights * (y - design @ found) ** 2))
    if degrees == 0 or chi2_chance(misfit, degrees) > 1.0 - LEVEL:
        return found, covariance, 0
    return found, covariance * misfit / degrees, degrees


def crossing(
    line: Line, limit: float, chance: float = 1.0 - LEVEL
) -> tuple[float, float | None]:
    """When |value| reaches a limit > 0: earliest and latest time of the interval (Fieller).

    None as the latest: perhaps never, and not before the earliest. Times before the last value are
    possible: then it is passed. Source: E. C. Fieller, "Some problems in interval estimation",
    J. R. Statist. Soc. B 16 (1954).
    """
    gap = math.copysign(limit, line.rate or line.level) - line.level
    q2 = line.quantile(chance) ** 2
    a = line.rate**2 - q2 * float(line.covariance[1, 1])
    b = -2.0 * (line.rate * gap + q2 * float(line.covariance[0, 1]))
    c = gap**2 - q2 * float(line.covariance[0, 0])
    if a <= 0.0 and c <= 0.0:  # the limit is within the error already
        return line.at, None
    half = math.sqrt(max(b * b - 4.0 * a * c, 0.0))
    if a > 0.0:  # the rate differs from zero
        return line.at + (-b - half) / (2.0 * a), line.at + (-b + half) / (2.0 * a)
    if a == 0.0:
        return line.at - c / b, None
    return line.at + (-b - half) / (2.0 * a), None


def chi2_chance(value: float, degrees: int) -> float:
    """That a chi-square variable is larger, by its series of halves (Abramowitz and Stegun
    26.4.4, 26.4.5)."""
    half = value / 2.0
    if degrees % 2 == 0:
        term, total = math.exp(-half), 0.0
        for k in range(degrees // 2):
            total += term
            term *= half / (k + 1)
        return total
    total = math.erfc(math.sqrt(half))
    term = math.exp(-half) * math.sqrt(half) / math.gamma(1.5)
    for k in range((degrees - 1) // 2):
        total += term
        term *= half / (k + 1.5)
    return total


def student_share(t: float, degrees: int) -> float:
    """Student's distribution function at t >= 0 (Abramowitz and Stegun 26.7.3, 26.7.4)."""
    angle = math.atan(t / math.sqrt(degrees))
    cosine, sine = math.cos(angle), math.sin(angle)
    odd = degrees % 2 == 1
    term, total = (cosine if odd else 1.0), 0.0
    for k in range(3 if odd else 2, degrees + 1, 2):
        total += term
        term *= cosine**2 * (k - 1) / k
    inside = 2.0 / math.pi * (angle + sine * total) if odd else sine * total
    return 0.5 + 0.5 * inside


@functools.cache
def student(share: float, degrees: int) -> float:
    """Its inverse for a share above one half."""
    low, high = 0.0, 1e9
    for _ in range(200):
        middle = 0.5 * (low + high)
        low, high = (
            (middle, high) if student_share(middle, degrees) < share else (low, middle)
        )
    return high
