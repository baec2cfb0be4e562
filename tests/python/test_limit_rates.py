"""Rates against limits: files, terminal and page, beside an independent computation."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from report_fixtures import JUDGED
from report_pages import SAMPLE, opened, plain
from results import Run, read_datum, read_points, write_xyz
from test_compare import compare, epoch

Runner = Callable[..., Run]

Z95 = 1.959963984540054
RULE = {
    "code": "API 653",
    "clause": "Annex B (before 2024)",
    "name": "out-of-plane settlement S_i",
    "unit": "m",
    "role": "governing",
    "verdict": "pass",
    "limit": 0.02,
}


def survey(path: Path, date: str | None, value: float, **changes: Any) -> Path:
    check = RULE | {"value": value, "sigma": 0.0002} | changes
    about = {} if date is None else {"survey_date": date}
    return epoch(path, checks=[check], about=about)


def year(date: str) -> float:
    day = np.datetime64(date)
    first = day.astype("datetime64[Y]")
    return float(
        1970
        + first.astype(int)
        + (day - first.astype("datetime64[D]"))
        / ((first + 1).astype("datetime64[D]") - first.astype("datetime64[D]"))
    )


def months_by_search(dates: list[str], values: list[float]) -> list[str]:
    """Where a weighted line and its band meet the limit, by trying every day of two centuries."""
    times, y = np.array([year(d) for d in dates]), np.array(values)
    design = np.column_stack([np.ones_like(times), times - times.mean()])
    covariance = 0.0002**2 * np.linalg.inv(design.T @ design)
    found = np.linalg.lstsq(design, y, rcond=None)[0]
    days = np.arange(np.datetime64(dates[-1]), np.datetime64("2200-01-01"))
    at = np.array([year(str(d)) for d in days[::7]])
    rows = np.column_stack([np.ones_like(at), at - times.mean()])
    line = rows @ found
    reach = Z95 * np.sqrt(np.einsum("ij,jk,ik->i", rows, covariance, rows))
    ends = [
        np.argmax(line + reach >= 0.02),
        np.argmax(line >= 0.02),
        np.argmax(line - reach >= 0.02),
    ]
    return [str(days[7 * i].astype("datetime64[M]")) for i in ends]


def test_dates_are_those_of_a_search(tmp_path: Path) -> None:
    dates, values = ["2016-03-01", "2019-06-15", "2024-10-01"], [0.004, 0.0055, 0.0079]
    surveys = [
        survey(tmp_path / f"{i}.json", d, v)
        for i, (d, v) in enumerate(zip(dates, values, strict=True))
    ]
    done = compare(*surveys, "-o", tmp_path / "m")
    assert done.returncode == 0, done.stderr
    result = json.loads((tmp_path / "m/movement.json").read_text())
    (rate,) = result["limits"]["rates"]
    assert rate["approach"] == "reached" and result["limits"]["none"] is None
    for key, month in zip(
        ("earliest", "expected", "latest"), months_by_search(dates, values), strict=True
    ):
        apart = np.datetime64(rate[key]).astype(int) - np.datetime64(month).astype(int)
        assert abs(apart) <= 1, (key, rate[key], month)  # a week's steps
    slope = np.polyfit([year(d) for d in dates], values, 1)[0]
    assert rate["rate"] == pytest.approx(slope, rel=1e-9)
    assert result["trend"]["unit"] == "m/survey"  # without --dates, as ever


def test_compare_says_the_same_on_its_page(browser: Any, tmp_path: Path) -> None:
    surveys = [survey(tmp_path / "a.json", None, 0.004), survey(tmp_path / "b.json", None, 0.008)]
    assert "not every survey has a date as" in compare(*surveys, "-o", tmp_path / "m").stdout
    dated = ("--dates", "2016-03-01,2024-10-01", "--language", "de")
    done = compare(*surveys, "-o", tmp_path / "m", *dated)
    told = next(line for line in done.stdout.splitlines() if line.startswith("limits: "))
    assert "Setzung aus der Ebene S_i: +0.47 mm" in told and "Grenzwert 20.0 mm: erreicht " in told
    with opened(browser, tmp_path / "m" / "report.html") as page:
        assert page.slips() == []
        assert told.removeprefix("limits: ") in plain(page.text("#trend .verdict"))
        row = plain(page.text("#limits tbody"))
        assert "8.0 mm" in row and "20.0 mm" in row and "+0.47 mm" in row


def test_baseline_with_dates(run: Runner, browser: Any, tmp_path: Path) -> None:
    """A tank bent by 30 mm between two surveys: the sentence on paper, screen and terminal."""
    points = read_points(SAMPLE)
    wave = np.cos(4 * np.arctan2(points[:, 1], points[:, 0]))
    for name, bend, date in (("before", 0.001, "2020-05-01"), ("after", 0.003, "2024-05-01")):
        moved = points.copy()
        moved[:, 2] += bend * wave
        write_xyz(tmp_path / f"{name}.pcd", moved)
        (tmp_path / f"{name}.toml").write_text(f"survey_date = {date}\n")
    first = (tmp_path / "before.pcd", "-o", tmp_path / "a", "--about", tmp_path / "before.toml")
    assert run(*first, *JUDGED).returncode == 0
    second = (tmp_path / "after.pcd", "-o", tmp_path / "b", "--about", tmp_path / "after.toml")
    done = run(*second, *JUDGED, "--baseline", tmp_path / "a")
    assert done.returncode == 0, done.stderr
    told = next(line for line in done.stdout.splitlines() if line.startswith("limits "))
    limits = read_datum(tmp_path / "b")["movement"]["limits"]
    checks = [{c["name"]: c for c in read_datum(tmp_path / n)["checks"]} for n in "ab"]
    span = year("2024-05-01") - year("2020-05-01")
    assert len(limits["rates"]) >= 3
    for rate in limits["rates"]:
        before, after = (c[rate["name"]] for c in checks)
        assert rate["rate"] == pytest.approx((after["value"] - before["value"]) / span, rel=1e-6)
        sigma = np.hypot(before["sigma"], after["sigma"]) / span
        assert rate["sigma"] == pytest.approx(sigma, rel=1e-6)
    with opened(browser, tmp_path / "b" / "report.html") as page:
        assert page.slips() == []
        shown = [plain(text) for text in page.texts("#summary .quality")]
        assert f"Limits: {told.split(maxsplit=1)[1]}" in shown
        assert page.page.locator("#movement tbody tr").count() == len(limits["rates"])
