"""The result on paper: A4, at most 6 pages."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.backends.backend_pdf import PdfPages
from matplotlib.figure import Figure

from plot_result import Result

A4 = (8.27, 11.69)  # inch
A4_WIDE = (11.69, 8.27)
MM = 1e3
TABLE_ROWS = 36
MOST_CHECKS = 16


def value(number: float | None, unit: str, decimals: int, scale: float = 1.0) -> str:
    return "not known" if number is None else f"{scale * number:.{decimals}f} {unit}"


def hash_of(file: dict[str, Any]) -> tuple[str, str]:
    """The name of the hash of a scan, and its digits; of results of earlier versions SHA-256."""
    known = file.get("hash") or {"algorithm": "sha256", "value": file["sha256"]}
    name = {"xxh3_128": "XXH3-128", "sha256": "SHA-256"}[known["algorithm"]]
    return (name, known["value"]) if known["value"] else ("hash", "not taken")


def inputs(datum: dict[str, Any]) -> list[tuple[str, str]]:
    rows = [("tank_datum", f"version {datum['version']}, method {datum['options']['method']}")]
    for file in datum["input"]["files"]:
        rows.append(("scan", f"{file['path']}, {file['points']} points"))
        rows.append(hash_of(file))
    rows.append(("status", datum["status"]))
    if datum["message"]:
        rows.append(("", datum["message"]))
    return rows


def figures(datum: dict[str, Any]) -> list[tuple[str, str]]:
    tank, level = datum["tank"], datum["datum"]
    tilt, ends = datum["tilt"], datum["antipodal"]
    rows = [
        ("radius", value(tank["radius"], "m", 4)),
        ("centre", ", ".join(f"{c:.3f}" for c in tank["center"]) + " m"),
        ("shell seen over", value(tank["coverage_deg"], "deg", 0)),
        (
            "stations",
            f"{level['measured']} measured, {level['interpolated']} interpolated, "
            f"{level['missing']} missing",
        ),
        ("mean elevation", value(level["mean"], "m", 4)),
        ("lowest", f"{level['min']:.4f} m at {level['min_azimuth_deg']:.0f} deg"),
        ("highest", f"{level['max']:.4f} m at {level['max_azimuth_deg']:.0f} deg"),
        ("range", value(level["range"], "mm", 1, MM)),
    ]
    if tilt is not None:
        direction = value(tilt["direction_deg"], "deg", 0)
        rows.append(("tilt", f"{tilt['angle_arcsec']:.1f} arc-seconds towards {direction}"))
    rows.append(("antipodal height", value(ends["max_h"], "mm", 1, MM)))
    rows.append(("antipodal inclination", value(ends["angle_arcsec"], "arc-seconds", 1)))
    return rows


def checks(datum: dict[str, Any]) -> list[tuple[str, str]]:
    listed = datum.get("checks", [])
    rows = [
        (c["verdict"], f"{c['code']} {c['clause']}: {c['name']} ({c['source']})")
        for c in listed[:MOST_CHECKS]
    ]
    if len(listed) > MOST_CHECKS:
        rows.append(("", f"{len(listed) - MOST_CHECKS} more in datum.json"))
    return rows


def front_page(result: Result) -> Figure:
    page = Figure(figsize=A4)
    page.text(0.1, 0.93, "Datum of a storage tank", size=18, weight="bold")
    y = 0.88
    datum = result.datum
    sections = [("Source", inputs(datum))]
    if result.usable:
        sections += [("Result", figures(datum)), ("Checks (a screening)", checks(datum))]
    for title, rows in sections:
        if not rows:
            continue
        page.text(0.1, y, title, size=12, weight="bold")
        y -= 0.025
        for name, text in rows:
            page.text(0.1, y, name, size=9, color="0.35")
            shown = page.text(0.32, y, text, size=9 if len(text) < 75 else 7)
            shown.set_parse_math(False)
            y -= 0.02
        y -= 0.02
    return page


def table_page(result: Result) -> Figure:
    """Every n-th station, so that they fit."""
    page = Figure(figsize=A4)
    c, count = result.columns, len(result.flags)
    step = -(-count // TABLE_ROWS)
    page.text(0.1, 0.93, f"Every {step}. station of {count}", size=12, weight="bold")

    def cell(name: str, i: int, decimals: int, scale: float = 1.0) -> str:
        number = c[name][i]
        return f"{scale * number:.{decimals}f}" if np.isfinite(number) else ""

    rows = [
        [str(i), cell("azimuth_deg", i, 1), cell("x", i, 3), cell("y", i, 3), cell("z", i, 4)]
        + [cell("sigma_z", i, 2, MM), cell("u", i, 1, MM), result.flags[i]]
        for i in range(0, count, step)
    ]
    names = ["station", "azimuth [deg]", "x [m]", "y [m]", "z [m]"]
    names += ["sigma z [mm]", "u [mm]", "flag"]
    axes = page.add_axes((0.08, 0.08, 0.84, 0.83))
    axes.axis("off")
    table = axes.table(rows, colLabels=names, loc="upper center", edges="horizontal")
    table.auto_set_font_size(False)
    table.set_fontsize(7)
    table.scale(1, 1.25)
    return page


def write_report(path: Path, result: Result, pictures: list[Figure]) -> None:
    """The front page, a page for each picture, the stations."""
    for picture in pictures:
        picture.set_size_inches(A4_WIDE)
    with PdfPages(path, metadata={"CreationDate": None, "Title": "Datum of a storage tank"}) as pdf:
        pages = [front_page(result), *pictures]
        if result.usable:
            pages.append(table_page(result))
        for page in pages:
            pdf.savefig(page)
