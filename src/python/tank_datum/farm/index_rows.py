"""What the overview says of a tank, column by column."""

from __future__ import annotations

from typing import Any

from tank_datum.farm.markup import DASH, Markup, element, figure, typeset
from tank_datum.farm.view import Plain

Cell = tuple[Any, Any, str]  # its value, what is shown, its class
Row = dict[str, Cell]
WORDS = {"FAIL": "fail", "UNDECIDED": "undecided", "PASS": "pass"}
COLUMNS = (  # key, heading; the map is coloured by any but the first
    ("tank", "Tank"),
    ("alarm", "Alarm"),
    ("verdict", "Verdict"),
    ("governing", "Governing check"),
    ("utilisation", "Utilisation [%]"),
    ("tilt", "Tilt [mm/m]"),
    ("change", "Settled since last epoch [mm]"),
    ("rate", "Settlement rate [mm/year]"),
    ("quality", "Stations seen [%]"),
    ("sigma", "Error of a station [mm]"),
    ("age", "Last survey"),
)


def level_of(view: Plain) -> str:
    """alarm, watch or none."""
    levels = [alarm["level"] for alarm in view["alarms"]]
    return "alarm" if "alarm" in levels else "watch" if levels else "none"


def row_of(view: Plain) -> Row:
    """By column: what it is sorted and coloured by, what is shown, and its class."""
    last = view["epochs"][-1] if view["epochs"] else {}
    change, half = last_change(view)
    word = last.get("verdict") or (last.get("status") or "no survey").replace("_", " ")
    seen = None
    if last.get("measured") is not None:
        seen = last["measured"] / max(1, stations_of(last))
    level = level_of(view)
    words = typeset(
        "; ".join(a["words"] for a in view["alarms"] if a["level"] == level)
    )
    return {
        "tank": (view["name"], _link(view), ""),
        "alarm": (
            {"alarm": 2, "watch": 1}.get(level, 0),
            [level, under(words)],
            f"{level}-word",
        ),
        "verdict": (word, word, f"verdict-word {WORDS.get(word, 'not_evaluated')}"),
        "governing": (last.get("governing") or "", last.get("governing") or DASH, ""),
        "utilisation": _number(last.get("utilisation"), 0, 100.0),
        "tilt": _number(last.get("tilt_slope"), 2, 1e3),
        "change": _with_half(change, half, 1),
        "rate": _with_half(*_rate(view["trends"].get("settlement")), 2),
        "quality": _number(seen, 0, 100.0),
        "sigma": _number(last.get("sigma_z"), 2, 1e3),
        "age": (last.get("date") or "", last.get("date") or DASH, "age"),
    }


def _number(value: float | None, digits: int, scale: float) -> Cell:
    return value, figure(value, digits, scale), "number"


def _with_half(value: float | None, half: float | None, digits: int) -> Cell:
    """A figure of metres in millimetres, with half of its 95 % interval."""
    if value is None:
        return None, DASH, "number"
    words = f"{figure(value, digits, 1e3)} ± {figure(half, digits, 1e3)}"
    return value, words, "number"


def _rate(trend: Plain | None) -> tuple[float | None, float | None]:
    if trend is None:
        return None, None
    return trend["rate"], (trend["high"] - trend["low"]) / 2.0


def stations_of(epoch: Plain) -> int:
    """Seen, bridged or missing."""
    return sum(epoch[name] or 0 for name in ("measured", "interpolated", "missing"))


def under(words: str) -> Markup | None:
    return element("span", words, class_="under") if words else None


def _link(view: Plain) -> Markup:
    return element("a", view["name"], href=f"tanks/{view['slug']}.html")


def last_change(view: Plain) -> tuple[float | None, float | None]:
    """Settlement since the epoch before, and half of its 95 % interval [m].

    Both differences from the first epoch share its error; the sum of their variances is too large
    rather than too small.
    """
    known = [c for c in view["changes"] if c["settlement"] is not None]
    if not known:
        return None, None
    last = known[-1]
    if len(known) == 1:
        return last["settlement"], 1.96 * last["sigma_settlement"]
    before = known[-2]
    variance = last["sigma_settlement"] ** 2 + before["sigma_settlement"] ** 2
    return last["settlement"] - before["settlement"], 1.96 * variance**0.5
