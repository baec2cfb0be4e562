"""HTML and SVG from values; every text from outside is escaped here."""

from __future__ import annotations

import html
import re
from collections.abc import Iterable
from typing import Any

MINUS, DASH, NARROW = "\u2212", "\u2013", "\u00a0"


class Markup(str):
    """Text that is HTML already."""

    __slots__ = ()


def element(tag: str, *children: Any, **attributes: Any) -> Markup:
    """<tag name="value">children</tag>; names end in _ where Python reserves them, and _ stands
    for -. None and False leave an attribute out; children that are not Markup are escaped."""
    given = "".join(_attribute(name, value) for name, value in attributes.items())
    if (
        tag in {"meta", "link", "input", "line", "rect", "circle", "path"}
        and not children
    ):
        return Markup(f"<{tag}{given}/>")
    return Markup(f"<{tag}{given}>{joined(children)}</{tag}>")


def _attribute(name: str, value: Any) -> str:
    if value is None or value is False:
        return ""
    plain = name.rstrip("_").replace("_", "-")
    plain = "viewBox" if plain == "viewBox" else plain
    return f' {plain}="{html.escape("" if value is True else str(value))}"'


def joined(children: Iterable[Any]) -> Markup:
    return Markup("".join(_text(child) for child in children))


def _text(child: Any) -> str:
    if child is None:
        return ""
    if isinstance(child, Markup):
        return child
    if isinstance(child, list | tuple):
        return joined(child)
    return html.escape(str(child))


def figure(
    value: float | None, digits: int = 1, scale: float = 1.0, unit: str = ""
) -> str:
    """A number with its unit, a dash where it is unknown; no negative zero."""
    if value is None:
        return DASH
    text = f"{scale * value:.{digits}f}"
    text = text.lstrip("-") if float(text) == 0.0 else text
    return text.replace("-", MINUS) + (f"{NARROW}{unit}" if unit else "")


def typeset(words: str) -> str:
    """With the sign of minus before figures."""
    return re.sub(r"-(?=\d)", MINUS, words)


def table(heads: list[Any], rows: Iterable[list[Any]], caption: str) -> Markup:
    """A table in its own scrolling box; cells that are no td or th become one."""
    head = element("tr", [element("th", h, scope="col") for h in heads])
    body = [element("tr", [_cell(cell) for cell in row]) for row in rows]
    return scrolling(
        element(
            "table",
            element("caption", caption),
            element("thead", head),
            element("tbody", body),
        ),
        caption,
    )


def scrolling(content: Markup, label: str) -> Markup:
    return element(
        "div", content, class_="scroll", tabindex="0", role="region", aria_label=label
    )


def _cell(cell: Any) -> Markup:
    if isinstance(cell, Markup) and cell.startswith(("<td", "<th")):
        return cell
    return element("td", cell)


def page(title: str, styles: str, body: Markup, script: str) -> str:
    """A whole page. It asks for nothing from elsewhere."""
    policy = "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data:"
    head = element(
        "head",
        element("meta", charset="utf-8"),
        element("meta", name="viewport", content="width=device-width, initial-scale=1"),
        element("meta", name="color-scheme", content="light dark"),
        element("meta", http_equiv="Content-Security-Policy", content=policy),
        element("title", title),
        element("link", rel="icon", href="data:,"),
        element("style", Markup(styles)),
    )
    ending = element("script", Markup(f'"use strict";\n{script}')) if script else None
    return f"<!DOCTYPE html>\n{element('html', head, element('body', body, ending), lang='en')}\n"
