"""How often what is said of the shape is right, on simulated surveys of one made tank.

Each row is a call of tank_datum_rates shape: the share of 95 % intervals that hold the truth
(tilt, waves n = 2 to 6, largest curvature, largest |U|, largest S_i, level within 9 m), the
verdicts on one figure, and surveys in which any rule fails that the truth does not. Seeds are
0, 1, 2 ...
"""

from __future__ import annotations

import argparse
import re
import sys
import time
from dataclasses import dataclass

from built import call


@dataclass(frozen=True)
class Row:
    name: str
    options: str
    most_fails: float | None = None  # of the verdicts on the figure [%]
    most_passes: float | None = None


ROWS = (
    Row("waves 8 mm (2/n)^2 all round", ""),
    *(Row(f"the same, {gap} degrees missing", f"--gap-deg {gap}") for gap in (40, 60, 90)),
    Row("waves 2, 3 and 9 alone", "--waves few"),
    Row("the same, 60 degrees missing", "--waves few --gap-deg 60"),
    Row("errors shared over 5 degrees", "--correlated-deg 5"),
    Row("errors shared over 20 degrees", "--correlated-deg 20"),
    Row("sigma claimed half", "--claimed 0.5"),
    Row("no sigma", "--claimed 0"),
    *(
        Row(
            f"{figure} at {share} of its limit, errors 2 mm",
            f"--of-limit {share} --figure {figure} --sigma 0.002",
            5 if share == 1 else None,
            5 if share > 1 else None,
        )
        for figure in ("curvature", "second_difference", "settlement_arc", "slope_10m")
        for share in (1, 1.25)
    ),
    *(
        Row(
            f"wave n = {n} alone at twice the limit",
            f"--waves one --wave {n} --of-limit 2",
            None,
            0,
        )
        for n in (6, 7, 8, 12)
    ),
)


def figures(options: str, seeds: int) -> tuple[str, float, float]:
    """The line of a row, and the shares of fails and passes [%]."""
    line = call("tank_datum_rates", "shape", "--runs", seeds, *options.split()).strip()
    found = re.search(r"pass +([\d.]+) fail +([\d.]+)", line)
    assert found is not None, line
    return line, float(found[2]), float(found[1])


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else None)
    parser.add_argument("--seeds", type=int, default=400)
    parser.add_argument("--only", default="", help="rows whose name holds this")
    typed = parser.parse_args()
    begun, good = time.monotonic(), True
    print(f"R 30 m, H 16 m, 360 stations, errors 1 mm if not said, {typed.seeds} seeds")
    for row in ROWS:
        if typed.only not in row.name:
            continue
        line, fails, passes = figures(row.options, typed.seeds)
        print(f"{row.name}\n  {line}", flush=True)
        good = good and (row.most_fails is None or fails <= row.most_fails)
        good = good and (row.most_passes is None or passes <= row.most_passes)
    print(f"{(time.monotonic() - begun) / 60:.1f} minutes")
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
