"""The overview of a farm: table, map, and the state of the campaign."""

from __future__ import annotations

from typing import Any

from tank_datum.farm.index_map import choice, farm_map
from tank_datum.farm.index_rows import COLUMNS, Row, level_of, row_of
from tank_datum.farm.markup import Markup, element, joined, table
from tank_datum.farm.status import CampaignState
from tank_datum.farm.view import Plain

MEANINGS = (
    "Verdict, governing check and utilisation are of the codes' checks on the last survey. Alarm: a "
    "limit of movement is passed for certain. Watch: the limit lies within the error, or something "
    "moves that has no limit. Settlement is of the mean, positive downwards; ± is half of the 95 % "
    "interval. The error of a station is 1 sigma of its height."
)


def index_page(site: str, views: list[Plain], state: CampaignState) -> Markup:
    """The body of index.html."""
    rows = [row_of(view) for view in views]
    return joined(
        [
            element("a", "Skip to the tanks", class_="skip", href="#main"),
            element(
                "header",
                element("p", "tank_datum farm", class_="product"),
                element("h1", site),
                _contents(),
            ),
            element(
                "main",
                _summary(views, state),
                _overview(rows),
                farm_map(views, rows),
                _campaign(state),
                id="main",
                tabindex="-1",
            ),
            element(
                "footer",
                "Screening for a storage-tank engineer, not a code evaluation.",
            ),
        ]
    )


def _contents() -> Markup:
    places = (("overview", "Tanks"), ("map", "Map"), ("campaign", "Campaign"))
    links = [element("a", words, href=f"#{name}") for name, words in places]
    return element("nav", links, aria_label="Sections")


def _summary(views: list[Plain], state: CampaignState) -> Markup:
    alarms = sum(any(a["level"] == "alarm" for a in v["alarms"]) for v in views)
    watched = sum(level_of(v) == "watch" for v in views)
    failing = sum(row_of(v)["verdict"][0] == "FAIL" for v in views)
    facts = (
        ("Tanks", len(views)),
        ("Fail a code check", failing),
        ("Movement alarm", alarms),
        ("To watch", watched),
        ("Surveys done", f"{state.count('done')} of {len(state.surveys)}"),
    )
    boxes = [
        element("div", element("dt", name), element("dd", value))
        for name, value in facts
    ]
    return element("dl", boxes, class_="facts")


def _overview(rows: list[Row]) -> Markup:
    body = [
        element(
            "tr",
            [_cell(key, *row[key]) for key, _ in COLUMNS],
            data_tank=row["tank"][0],
        )
        for row in rows
    ]
    made = element(
        "table",
        element("caption", "The last survey of every tank. Press a heading to sort."),
        element("thead", element("tr", [_head(*column) for column in COLUMNS])),
        element("tbody", body),
        id="tanks",
    )
    box = element(
        "div",
        made,
        class_="scroll",
        tabindex="0",
        role="region",
        aria_label="Table of tanks",
    )
    return element(
        "section",
        element("h2", "Tanks"),
        _filters(rows),
        box,
        element("p", MEANINGS, class_="quiet"),
        id="overview",
        aria_label="Tanks",
    )


def _head(key: str, words: str) -> Markup:
    button = element("button", words, type="button", class_="sort")
    return element("th", button, scope="col", data_key=key, aria_sort="none")


def _cell(key: str, value: Any, shown: Any, kind: str) -> Markup:
    tag, extra = ("th", {"scope": "row"}) if key == "tank" else ("td", {})
    value = (
        None if value is None else repr(value) if isinstance(value, float) else value
    )
    return element(
        tag, shown, class_=kind or None, data_key=key, data_value=value, **extra
    )


def _filters(rows: list[Row]) -> Markup:
    verdicts = sorted({row["verdict"][0] for row in rows})
    levels = ("alarm", "watch", "none")
    return element(
        "div",
        element("label", "Search ", element("input", type="search", id="search")),
        choice("verdict-filter", "Verdict ", ["all", *verdicts]),
        choice("alarm-filter", "Alarm ", ["all", *levels]),
        element("span", id="shown", role="status"),
        class_="controls",
    )


def _campaign(state: CampaignState) -> Markup:
    open_ = [s for s in state.surveys if s.state != "done"]
    rows = [[s.job, s.date, s.state, s.reason] for s in open_]
    counts = [f"{state.count('done')} of {len(state.surveys)} surveys done"]
    for name in ("no datum", "failed", "missing", "to do"):
        counts += [f"{state.count(name)} {name}"] if state.count(name) else []
    content = [element("h2", "Campaign"), element("p", ", ".join(counts) + ".")]
    if state.last_run:
        content.append(element("p", f"Last run: {state.last_run}.", class_="quiet"))
    if rows:
        content.append(
            table(["Survey", "Date", "State", "Why"], rows, "Surveys that are not done")
        )
    return element("section", content, id="campaign", aria_label="Campaign")
