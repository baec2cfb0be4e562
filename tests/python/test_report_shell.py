"""The shell in report.html: map, roundness, plumbness."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

from report_pages import opened, scale_of, with_data
from results import Run, read_datum

Runner = Callable[..., Run]
Synth = Callable[..., Path]


def test_shell_of_a_scan(
    run: Runner,
    synth: Synth,
    browser: Any,
    tmp_path: Path,
) -> None:
    """Map, curves and tables of the shell at six heights, held to shell.csv and datum.json."""
    assert (
        run(
            synth(out_of_round="2:0.01:0", near_datum=4, step_deg=0.3), "-o", tmp_path / "out"
        ).returncode
        == 0
    )
    shell = read_datum(tmp_path / "out")["shell"]
    table = np.genfromtxt(tmp_path / "out" / "shell.csv", delimiter=",", names=True)
    heights = np.unique(table["height"])
    assert len(heights) == 6
    with opened(browser, tmp_path / "out" / "report.html") as page:
        assert page.slips() == []
        assert page.page.locator("#shell-map image").count() == len(heights)
        assert page.page.locator("#roundness-chart path.height").count() == len(heights)
        assert page.page.locator("#shell tbody tr").count() == len(shell["roundness"])
        worst = max(shell["roundness"], key=lambda r: r["max_deviation"])
        assert f"{1e3 * worst['max_deviation']:.1f}\u00a0mm" in page.text("#shell tbody")
        (ax, bx), (ay, by) = (scale_of(page, "shell-map", axis) for axis in (0, 1))
        image = page.picture("#shell-map svg").astype(int)
        for azimuth in (0.0, 90.0):  # outwards red, inwards blue
            cell = table[(table["azimuth_deg"] == azimuth) & (table["height"] == heights[1])][0]
            assert abs(cell["deviation"]) > 0.005
            x, y = (azimuth + 3.0 - ax) / bx, (heights[1] - ay) / by
            red, _, blue = image[round(y), round(x)]
            assert (red > blue + 40) == (cell["deviation"] > 0) and abs(red - blue) > 40
            page.hover("shell-map", (azimuth - ax) / bx, y)
            tip = page.text("#tip").replace("\u2212", "-")
            assert f"Shell at {azimuth:.1f}\u00b0, {heights[1]:.2f}\u00a0m above the datum" in tip
            assert f"{1e3 * cell['deviation']:.1f}\u00a0mm" in tip
        page.hover("plumbness-chart", 300, 100)
        assert "Offset" in page.text("#tip") and "over 2.50\u00a0m" in page.text("#tip")
    for p in shell["plumbness"][:20]:
        p["height"] = 1.0
    path = with_data(tmp_path / "out" / "report.html", tmp_path / "page.html", {"shell": shell})
    with opened(browser, path) as page:  # a top seen less high is no plumbness of the whole
        assert page.page.locator("#plumbness-chart circle.lower").count() == 20
        assert "where the shell is seen less high" in page.text("#shell .legend")


def test_a_shell_seen_from_one_side(
    run: Runner, synth: Synth, browser: Any, tmp_path: Path
) -> None:
    """No circle can be told at a height: no map, no curves, and the reason."""
    scan = synth(scanners=1, near_datum=4)
    assert run(scan, "-o", tmp_path).returncode == 0
    datum = read_datum(tmp_path)
    assert datum["status"] == "partial" and datum["shell"]["roundness"] == []
    with opened(browser, tmp_path / "report.html") as page:
        assert page.slips() == []
        reason = "not seen round enough of the tank at any height"
        assert reason in page.text("#shell .absent") and reason in page.text("#summary li")
        assert page.page.locator("#shell-map, #roundness-chart").count() == 0
        assert page.page.locator("#elevation-chart rect.gap").count() == 1
