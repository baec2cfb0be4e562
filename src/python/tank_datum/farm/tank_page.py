"""The page of one tank: its epochs, trends and hydrotests."""

from __future__ import annotations

from tank_datum.farm.index_rows import WORDS, stations_of, under
from tank_datum.farm.markup import DASH, Markup, element, figure, joined, table, typeset
from tank_datum.farm.tank_trends import (
    hydrotest_section,
    levels_section,
    section,
    trends_section,
    with_half,
)
from tank_datum.farm.view import Plain

FACTS = {
    "height": ("Height", "m"),
    "radius": ("Radius", "m"),
    "yield_mpa": ("Yield strength", "MPa"),
    "modulus_mpa": ("Elastic modulus", "MPa"),
    "roof": ("Roof", ""),
    "service": ("Service", ""),
    "foundation": ("Foundation", ""),
    "height_reference": ("Heights compared by", ""),
}
REFERENCES = {
    "common": "common benchmarks",
    "marks": "measured benchmarks",
    "stable": "stable stations",
    "mean": "nothing: mean taken out",
    "tilt": "nothing: mean and tilt taken out",
}
EPOCHS = [
    "Epoch",
    "Date",
    "Liquid level",
    "Verdict",
    "Governing check",
    "Utilisation",
    "Tilt",
    "Settlement",
    "Worst station",
    "Out of plane",
    "Stations seen",
]


def tank_page(site: str, view: Plain) -> Markup:
    """The body of a tank's page."""
    sections = [
        _alarms(view),
        _facts(view),
        _epochs(view),
        trends_section(view),
        levels_section(view),
    ]
    sections += [hydrotest_section(test, view) for test in view["hydrotests"]]
    return joined(
        [
            element("a", "Skip to the results", class_="skip", href="#main"),
            element(
                "header",
                element(
                    "p", element("a", site, href="../index.html"), class_="product"
                ),
                element("h1", view["name"]),
            ),
            element("main", sections, id="main", tabindex="-1"),
            element(
                "footer",
                "Screening for a storage-tank engineer, not a code evaluation.",
            ),
        ]
    )


def _alarms(view: Plain) -> Markup:
    """What is passed, in the box that a report has for its verdict."""
    level = (
        "fail" if any(a["level"] == "alarm" for a in view["alarms"]) else "undecided"
    )
    if not view["alarms"]:
        words = "No limit is passed, and nothing moves beyond the errors."
        if len(view["changes"]) < 2:
            tests = (
                "the hydrotest stands below" if view["hydrotests"] else "no movement"
            )
            words = f"Fewer than two epochs to compare over the years: {tests}."
        return element("div", element("p", words), class_="verdict none", role="status")
    lines = [
        element("p", element("strong", a["level"]), ": ", typeset(a["words"]))
        for a in view["alarms"]
    ]
    return element("div", lines, class_=f"verdict {level}", role="status")


def _facts(view: Plain) -> Markup:
    boxes = []
    for name, (words, unit) in FACTS.items():
        value = view["facts"].get(name)
        if value is not None:
            shown = f"{value:g} {unit}" if isinstance(value, float) else value
            shown = REFERENCES.get(str(shown), shown)
            boxes.append(element("div", element("dt", words), element("dd", shown)))
    return element("dl", boxes, class_="facts")


def _epochs(view: Plain) -> Markup:
    changes = {change["epoch"]: change for change in view["changes"]}
    rows = []
    for epoch in view["epochs"]:
        change = changes.get(epoch["epoch"], {})
        word = epoch["verdict"] or epoch["status"].replace("_", " ")
        rows.append(
            [
                [_report_link(epoch), under(_kind(epoch))],
                element("td", epoch["date"], class_="day"),
                figure(epoch["fill_level"], 2, 1.0, "m"),
                element(
                    "td",
                    word,
                    class_=f"verdict-word {WORDS.get(word, 'not_evaluated')}",
                ),
                epoch["governing"] or epoch["message"] or DASH,
                figure(epoch["utilisation"], 0, 100.0, "%"),
                figure(epoch["tilt_slope"], 2, 1e3, "mm/m"),
                with_half(change, "settlement", 1e3, "mm"),
                figure(change.get("station"), 1, 1e3, "mm"),
                figure(change.get("out_of_plane"), 1, 1e3, "mm"),
                f"{epoch['measured'] or 0} of {stations_of(epoch)}",
            ]
        )
    caption = (
        "Every epoch, with its report. Settlement and movement are since the first: settlement "
        "of the mean, positive downwards; movement of a station, positive upwards."
    )
    notes = [
        element("p", note, class_="absent") for note in view["notes"] + _undone(view)
    ]
    return section("epochs", "Epochs", table(EPOCHS, rows, caption), notes)


def _report_link(epoch: Plain) -> Markup | str:
    """To its report.html, where that is still in the store."""
    label = str(epoch["epoch"])
    return element("a", label, href=epoch["report"]) if epoch.get("report") else label


def _kind(epoch: Plain) -> str:
    return "" if epoch["kind"] == "scan" else " levelling"


def _undone(view: Plain) -> list[str]:
    """Surveys that are not done, those of one reason together."""
    epochs: dict[tuple[str, str], list[str]] = {}
    for survey in view["undone"]:
        why = (survey["state"], survey["reason"])
        epochs.setdefault(why, []).append(survey["epoch"])
    return [
        f"{state}: {', '.join(some)}. {reason}".strip()
        for (state, reason), some in epochs.items()
    ]
