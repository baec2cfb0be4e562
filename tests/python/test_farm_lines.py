"""Lines through epochs: rates, intervals, dates of limits; all with known answers."""

from __future__ import annotations

import math

import numpy as np
import pytest

from farm_made import require_farm

require_farm()

from tank_datum.farm.dates import date_of, date_ticks, year_of  # noqa: E402
from tank_datum.farm.lines import (  # noqa: E402
    chi2_chance,
    crossing,
    fit_line,
    fit_line_and_level,
    student,
)


@pytest.mark.parametrize(
    ("degrees", "value"), [(1, 12.7062), (2, 4.3027), (3, 3.1824), (4, 2.7764), (10, 2.2281)]
)
def test_students_quantiles_are_those_of_the_tables(degrees: int, value: float) -> None:
    assert student(0.975, degrees) == pytest.approx(value, abs=1e-4)


@pytest.mark.parametrize(
    ("degrees", "value"), [(1, 3.8415), (2, 5.9915), (3, 7.8147), (4, 9.4877), (5, 11.0705)]
)
def test_chances_of_chi_square_are_those_of_the_tables(degrees: int, value: float) -> None:
    assert chi2_chance(value, degrees) == pytest.approx(0.05, abs=1e-5)


def test_a_rate_and_its_interval() -> None:
    """Slope of equal errors s at 0, 1, 2, 3: variance s^2 / 5."""
    line = fit_line([0, 1, 2, 3], [0.0, 0.01, 0.02, 0.03], [0.001] * 4)
    assert line is not None and line.rate == pytest.approx(0.01)
    reach = 1.959964 * 0.001 / math.sqrt(5)
    assert line.interval() == pytest.approx((0.01 - reach, 0.01 + reach))


def test_errors_larger_than_stated_are_taken_from_the_scatter() -> None:
    """Residuals of +-10 mm about the line, errors stated as 0.1 mm: Student's t on 2 degrees."""
    values = [0.01, 0.0, 0.0, 0.01]
    line = fit_line([0, 1, 2, 3], values, [0.0001] * 4)
    assert line is not None and line.degrees == 2
    scatter = math.sqrt(4 * 0.005**2 / 2)
    assert line.sigma_rate() == pytest.approx(scatter / math.sqrt(5))
    assert line.interval()[1] == pytest.approx(4.3027 * scatter / math.sqrt(5), rel=1e-4)


def test_one_date_or_no_error_is_no_line() -> None:
    assert fit_line([1, 1], [0, 1], [1, 1]) is None
    assert fit_line([1, 2], [0, 1], [0, 1]) is None


def test_what_follows_the_level_is_told_apart() -> None:
    times, levels = [0, 1, 2, 3, 4], [0, 10, 0, 10, 2]
    values = [0.002 * t + 0.0005 * h for t, h in zip(times, levels, strict=True)]
    found = fit_line_and_level(times, levels, values, [0.0001] * 5)
    assert found is not None
    line, slope, sigma = found
    assert (line.rate, slope) == (pytest.approx(0.002), pytest.approx(0.0005))
    assert 0.0 < sigma < 1e-4
    assert fit_line_and_level(times, times, values, [0.0001] * 5) is None
    assert fit_line_and_level(times[:3], levels[:3], values[:3], [0.0001] * 3) is None


def test_the_date_of_a_limit_is_an_interval() -> None:
    """10 mm a year: 50 mm after 5 years; the ends are where the band of the line meets it."""
    line = fit_line([0, 1, 2, 3], [0.0, 0.01, 0.02, 0.03], [0.001] * 4)
    assert line is not None
    early, late = crossing(line, 0.05)
    assert late is not None and early < 5.0 < late
    for end, side in ((early, 1), (late, -1)):
        along = end - line.at
        band = 1.959964 * math.sqrt(0.001**2 * (1 / 4 + along**2 / 5))
        assert line.level + line.rate * along + side * band == pytest.approx(0.05)
    assert crossing(line, 0.1)[0] > late


def test_a_falling_line_reaches_the_limit_below() -> None:
    line = fit_line([0, 1, 2, 3], [0.0, -0.01, -0.02, -0.03], [0.001] * 4)
    assert line is not None
    early, late = crossing(line, 0.05)
    assert late is not None and early < 5.0 < late


def test_a_rate_that_may_be_zero_gives_not_before() -> None:
    line = fit_line([0, 1, 2, 3], [0.0, 0.0003, -0.0002, 0.0002], [0.001] * 4)
    assert line is not None
    early, late = crossing(line, 0.05)
    assert late is None
    along = early - line.at
    band = 1.959964 * math.sqrt(0.001**2 * (1 / 4 + along**2 / 5))
    assert line.level + line.rate * along + band == pytest.approx(0.05)
    assert crossing(line, 0.0005) == (line.at, None)


def test_the_interval_of_the_date_covers() -> None:
    """Of 500 drawn lines, 95 % of the intervals hold the true date (478 when written)."""
    random = np.random.default_rng(20)
    times, rate, sigma = np.arange(5.0), 0.004, 0.001
    held = 0
    for _ in range(500):
        line = fit_line(times, rate * times + sigma * random.standard_normal(5), [sigma] * 5)
        assert line is not None
        early, late = crossing(line, 0.05)
        held += early <= 0.05 / rate and (late is None or 0.05 / rate <= late)
    assert 462 <= held <= 490


@pytest.mark.parametrize(
    ("low", "high", "words"),
    [
        (2018.2, 2024.7, ["2019", "2020", "2021", "2022", "2023", "2024"]),
        (1955.0, 2024.0, ["1960", "1980", "2000", "2020"]),
        (2024.02, 2024.48, ["2024-02", "2024-03", "2024-04", "2024-05", "2024-06"]),
        (2024.30, 2024.32, ["2024-04-20", "2024-04-23", "2024-04-26"]),
    ],
    ids=["years", "decades", "months", "days"],
)
def test_charts_of_any_length_have_dates(low: float, high: float, words: list[str]) -> None:
    ticks = date_ticks(low, high)
    assert [word for _, word in ticks] == words
    assert all(low <= at <= high for at, _ in ticks)


def test_dates_and_years_are_the_cores() -> None:
    assert year_of("2024-07-02") == 2024.5
    assert str(date_of(2024.5)) == "2024-07-02"
    assert date_of(12000.0) is None
