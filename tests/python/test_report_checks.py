"""The checks of the codes in report.html: value, limit, verdict, trust, and what they lack."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from conftest import ROOT
from report_pages import Opened, opened, plain, with_data
from results import Run, read_datum

Runner = Callable[..., Run]

ORDER = ["fail", "undecided", "pass", "not evaluated", "not applicable"]
UNITS = {
    "m": (1e3, "mm", 1),
    "m/m": (1e3, "mm/m", 2),
    "1/m": (1e6, "\u00d7 10\u207b\u2076 1/m", 1),
}


def in_its_unit(value: float | None, unit: str) -> str:
    if value is None:
        return "\u2013"
    factor, name, digits = UNITS[unit]
    shown = f"{factor * value:.{digits}f}"
    return f"{shown.removeprefix('-') if float(shown) == 0 else shown}\u00a0{name}"


def rows(page: Opened) -> list[list[str]]:
    page.page.evaluate("document.querySelectorAll('details').forEach(d => { d.open = true; })")
    found = page.page.locator("#summary tbody tr").all()
    return [[c.strip() for c in row.locator("td").all_inner_texts()] for row in found]


def test_each_says_value_limit_verdict_and_trust(still: Opened, sample_report: Path) -> None:
    shown, checks = rows(still), read_datum(sample_report)["checks"]
    assert len(shown) == len(checks)
    assert {c["verdict"] for c in checks} >= {"pass", "not_applicable"}
    for check in checks:
        name = check["name"][0].upper() + check["name"][1:]
        cells = next(r for r in shown if r[0].startswith(name) and check["code"] in r[0])
        assert cells[0].endswith(check["clause"])
        assert cells[1].startswith(in_its_unit(check["value"], check["unit"]))
        if check["value"] is not None and check["sigma"] is not None:
            low, high = (in_its_unit(check[key], check["unit"]) for key in ("low95", "high95"))
            interval = f"95 %: {low.split(chr(0xA0))[0]} to {high}"
            assert f"{interval}, at {check['azimuth_deg']:.0f}\u00b0" in cells[1]
        assert cells[2] == in_its_unit(check["limit"], check["unit"])
        assert cells[3] == check["verdict"].replace("_", " ")
        assert cells[4].split("\n")[0] == check["source"]
        assert cells[4].endswith(check["citation"].replace("+-", "\u00b1").replace("^2", "\u00b2"))
        assert cells[5] == check["note"]


def test_failures_come_first_and_the_verdict_names_them(still: Opened, sample_report: Path) -> None:
    verdicts = [row[3] for row in rows(still)]
    assert verdicts == sorted(verdicts, key=ORDER.index)
    count = verdicts.count
    judged = len(verdicts) - count("not applicable") - count("not evaluated")
    said = still.text(".verdict")
    assert f"{count('pass')} of {judged} judged checks pass" in said
    assert f"{count('not applicable')} not applicable" in said
    datum = read_datum(sample_report)
    headline = datum["verdict"]
    assert headline["word"] in still.text(".verdict .word") and headline["sentence"] in plain(said)
    for check in datum["checks"]:
        if check["verdict"] == "fail":
            assert f"{check['code']} {check['name']}" in said
    shown = {"FAIL": "fail", "PASS": "pass", "UNDECIDED": "undecided", "INCOMPLETE": "undecided"}
    assert shown[headline["word"]] in still.page.locator(".verdict").get_attribute("class")
    for note in read_datum(sample_report)["notes"]:
        assert note.replace(">=", "\u2265") in still.text("#summary li")


def test_what_they_lack_is_listed(run: Runner, browser: Any, tmp_path: Path) -> None:
    table = ROOT / "tests" / "data" / "levelling" / "fourteen_stations.csv"
    assert run("--stations-csv", table, "--diameter", 42, "-o", tmp_path).returncode == 0
    with opened(browser, tmp_path / "report.html") as page:
        assert page.slips() == []
        said = page.text("#summary ul:not(:last-child) li")
        for option in ("roof", "foundation", "height", "yield_mpa", "modulus_mpa"):
            assert f"option {option}" in said


@pytest.mark.parametrize("verdict", ["pass", "fail", "undecided"])
def test_words_of_a_result_are_never_markup(
    browser: Any, sample_report: Path, tmp_path: Path, verdict: str
) -> None:
    check = {"code": "API 653", "clause": "<i>B</i>", "name": "<b>tilt</b>", "verdict": verdict}
    check |= {"value": 0.031, "limit": 0.02, "unit": "m", "source": "verified"}
    check |= {"note": "<u>n</u> --roof", "citation": "<s>c</s>"}
    headline = {"word": verdict.upper(), "governing": "<b>tilt</b>", "utilisation": 1.55}
    headline |= {"sentence": "<u>s</u>"}
    changes = {"checks": [check], "verdict": headline, "notes": ["no <i>evaluation</i>"]}
    path = with_data(sample_report / "report.html", tmp_path / "page.html", changes)
    with opened(browser, path) as page:
        assert page.slips() == []
        assert verdict in page.page.locator(".verdict").get_attribute("class")
        assert "<b>tilt</b>" in page.text(".verdict" if verdict == "fail" else "#summary .bars")
        assert page.page.locator("main :is(i:not(.legend i, .bars i), b, u, s)").count() == 0
        assert "no <i>evaluation</i>" in page.text("#summary li")


def test_a_maximum_is_shown_with_its_interval(
    browser: Any, sample_report: Path, tmp_path: Path
) -> None:
    """Which reaches further up than down: verdict, bar and table say both ends."""
    check = {"code": "GB", "clause": "", "name": "planar tilt", "verdict": "fail", "note": ""}
    check |= {"value": 0.0088, "low95": 0.0081, "high95": 0.032, "sigma": 0.0118, "limit": 0.008}
    check |= {"unit": "m", "source": "verified", "azimuth_deg": 118.0, "citation": ""}
    verdict = {"word": "FAIL", "governing": "GB planar tilt", "utilisation": 1.1}
    verdict |= {"utilisation_95": [1.0125, 4.0], "sentence": "GB planar tilt is at 118 deg of it"}
    changes = {"checks": [check], "verdict": verdict}
    path = with_data(sample_report / "report.html", tmp_path / "page.html", changes)
    with opened(browser, path) as page:
        assert page.slips() == []
        assert "at 110 % of its limit (95 %: 101 to 400 %) at 118\u00b0." in page.text(".verdict")
        assert page.texts(".bars .number") == ["110 % (101 to 400 %)"]
        assert "8.8\u00a0mm\n95 %: 8.1 to 32.0\u00a0mm, at 118\u00b0" in page.text("#summary tbody")
        assert "23.6" not in page.text("#summary")  # two of its sigma


def made(name: str, value: float, verdict: str, role: str) -> dict[str, Any]:
    check = {"code": "A", "clause": "", "name": name, "verdict": verdict, "role": role, "note": "n"}
    check |= {"value": value, "limit": 0.01, "low95": None, "high95": None, "sigma": None}
    return check | {"unit": "m", "source": "verified", "azimuth_deg": None, "citation": ""}


def test_bars_beyond_their_limits_differ_and_show_it(
    browser: Any, sample_report: Path, tmp_path: Path
) -> None:
    checks = [
        made("second", 0.0241, "fail", "second opinion"),
        made("milder", 0.0158, "fail", "judged"),
        made("graver", 0.0166, "fail", "governing"),
        made("fine", 0.005, "pass", "judged"),
    ]
    path = with_data(sample_report / "report.html", tmp_path / "page.html", {"checks": checks})
    with opened(browser, path) as page:
        assert page.slips() == []
        bars = page.page.locator(".bars li").all()
        tracks, fills, limits = (
            [bar.locator(part).bounding_box() for bar in bars] for part in (".track", "i", "em")
        )
        widths = [f["width"] / t["width"] for f, t in zip(fills, tracks, strict=True)]
        wanted = [share / 2.41 for share in (2.41, 1.66, 1.58, 0.5)]
        assert widths == pytest.approx(wanted, abs=0.01)
        for track, limit in zip(tracks, limits, strict=True):
            at = (limit["x"] - track["x"]) / track["width"]
            assert at == pytest.approx(1 / 2.41, abs=0.01)
        assert "The line across the bars is the limit." in page.text("#summary")
        said = page.text(".verdict")
        assert "3 fail: A graver, A milder, A second (a second opinion)" in said
        found = rows(page)
        assert [r[0].split("\n")[0] for r in found] == ["Graver", "Milder", "Second", "Fine"]
        assert [r[5] for r in found] == ["n", "n", "a second opinion; n", "n"]


def test_tolerances_of_new_tanks_are_said_to_judge_nothing(
    browser: Any, sample_report: Path, tmp_path: Path
) -> None:
    """A roundness that fails beside PASS."""
    with opened(browser, sample_report / "report.html") as page:
        assert "For comparison: a rule for new tanks." in page.text("#shell caption")
    checks = [c | {"role": "judged", "note": ""} for c in read_datum(sample_report)["checks"]]
    path = with_data(sample_report / "report.html", tmp_path / "page.html", {"checks": checks})
    with opened(browser, path) as page:
        assert "omparison" not in page.text("#shell caption")


def test_bars_are_shares_of_the_limits_the_fullest_first(
    still: Opened, sample_report: Path
) -> None:
    judged = [
        c
        for c in read_datum(sample_report)["checks"]
        if c["verdict"] in ("pass", "fail", "undecided") and c["limit"]
    ]
    judged.sort(key=lambda c: c["value"] / c["limit"], reverse=True)
    shares = [100 * c["value"] / c["limit"] for c in judged]
    said = [
        "{:.0f} % ({:.0f} to {:.0f} %)".format(
            *(100 * c[key] / c["limit"] for key in ("value", "low95", "high95"))
        )
        for c in judged
    ]
    assert still.texts(".bars .number") == said
    track = still.page.locator(".bars .track").first.bounding_box()["width"]
    for bar, share in zip(still.page.locator(".bars i").all(), shares, strict=True):
        width = bar.bounding_box()["width"]
        assert width == pytest.approx(track * min(share, 100) / 100, abs=3)


def test_what_passes_is_folded(page: Opened) -> None:
    folded = page.page.locator("#summary details")
    assert folded.count() == 2
    for details in folded.all():
        assert not details.get_by_role("table").is_visible()
        details.locator("summary").click()
        assert details.get_by_role("table").is_visible()
