"""Writes what src/doc/options.md, the Python stub and its dicts of keywords say of the options.

That is what tank_datum --print-options lists.
Usage: python scripts/option_docs.py [--check]     (--check writes nothing; status 1: out of date)
"""

from __future__ import annotations

import argparse
import json
import re
import sys
import textwrap
from typing import Any

from built import ROOT, call

PAGE = ROOT / "src/doc/options.md"
STUB = ROOT / "src/python/tank_datum/__init__.pyi"
KEYWORDS = ROOT / "src/python/tank_datum/_options.py"
WIDEST = 84  # columns of a comment in the stub

Option = dict[str, Any]

# What stands for a value on the command line, and the type of a keyword.
SHOWN = {
    "flag": "",
    "integer": "N",
    "number": "X",
    "numbers": "X,X,...",
    "integers": "N,N,...",
    "names": "A,B,...",
    "circle": "X,Y,R",
    "length": "LENGTH",
    "fact": "X",
    "file": "FILE",
    "folder": "DIR",
    "places": "FILE",
}
TYPES = {
    "flag": "bool",
    "integer": "int",
    "number": "float",
    "numbers": "Sequence[float] | NDArray[np.floating[Any]]",
    "integers": "Sequence[int] | NDArray[np.integer[Any]]",
    "names": "Sequence[str]",
    "circle": "tuple[float, float, float] | None",
    "length": "float | str | None",
    "fact": "float | None",
    "file": "_Path | None",
    "places": "_Path | dict[str, tuple[float, float, float]] | None",
}
OF_EVERY_COMMAND = "| `--version`, `-h`, `--help` | print it and stop | | |"


def read_options() -> list[Option]:
    """The options as the command built from this source lists them."""
    options: list[Option] = json.loads(call("tank_datum", "--print-options"))
    return options


def flag(name: str) -> str:
    return "--" + name.replace("_", "-")


def shown(value: Any) -> str:
    """A default on the page."""
    if value is None or value is False or value in ([], {}):
        return ""
    return f"{value:g}" if isinstance(value, float) else str(value)


def row(option: Option, names: set[str]) -> str:
    """One row of the page's tables."""
    value = "|".join(option["words"]) if "words" in option else SHOWN[option["kind"]]
    first = f"`-{option['letter']}`, " if "letter" in option else ""
    first += f"`{flag(option['name'])}{' ' if value else ''}{value}`"
    if option["negatable"]:
        first += f", `{flag('no_' + option['name'])}`"
    help_text = re.sub(
        r"\boption ([a-z_]+)\b",
        lambda word: f"`{flag(word[1])}`" if word[1] in names else word[0],
        option["help"],
    )
    bounds = "" if "words" in option else option["expected"] or ""
    cells = [first, help_text, bounds, shown(option["default"])]
    return "|" + "|".join(f" {cell} ".replace("|", "\\|") if cell else " " for cell in cells) + "|"


def table(options: list[Option], topic: str) -> str:
    names = {option["name"] for option in options}
    rows = [row(option, names) for option in options if option["topic"] == topic]
    if topic == options[0]["topic"]:  # results and the run
        rows.append(OF_EVERY_COMMAND)
    return "\n".join(["| option | meaning | may be | default |", "|---|---|---|---|", *rows])


def page_of(text: str, options: list[Option]) -> str:
    """The page with its tables as they should be; each stands between two marks."""

    def filled(block: re.Match[str]) -> str:
        return f"<!-- options: {block[1]} -->\n\n{table(options, block[1])}\n\n<!-- end -->"

    return re.sub(r"<!-- options: ([^\n]+) -->\n.*?<!-- end -->", filled, text, flags=re.DOTALL)


def type_of(option: Option) -> str:
    """The type of a keyword."""
    if option["name"] == "baseline":
        return "Datum | _Path | None"
    if "words" not in option:
        return TYPES.get(option["kind"], "")
    words = ", ".join(json.dumps(word) for word in option["words"])
    return f"Literal[{words}]" + (" | None" if option["default"] is None else "")


def keyword(option: Option) -> str:
    """A keyword of the stub with its comment."""
    default, kind = option["default"], type_of(option)
    value = "..." if default == [] else "None" if default in (None, {}) else repr(default)
    if isinstance(default, str):
        value = json.dumps(default)
    expected = "" if "words" in option else option["expected"]
    bounds = f" ({expected})" if expected else ""
    comment = textwrap.fill(
        option["help"] + bounds, WIDEST, initial_indent="    # ", subsequent_indent="    # "
    )
    return f"{comment}\n    {option['name']}: {kind} = {value},\n"


def stub_of(text: str, options: list[Option]) -> str:
    """The stub with its keywords as they should be."""
    keywords = "".join(keyword(option) for option in options if not option["command_only"])
    marks = r"(    # options, by scripts/option_docs\.py\n).*?(    # end of options\n)"
    return re.sub(marks, lambda mark: mark[1] + keywords + mark[2], text, flags=re.DOTALL)


def typed_dicts_of(text: str, options: list[Option]) -> str:
    """The dicts of keywords, of a comparison and of what a run has beside, as they should be."""
    parts: dict[str, list[Option]] = {"a run": [], "a comparison": []}
    for option in options:
        if option["command_only"]:
            continue
        moved = (
            option["topic"] == "Movement since an earlier survey" and option["name"] != "baseline"
        )
        parts["a comparison" if moved else "a run"].append(option)
    for mark, listed in parts.items():
        lines = "".join(f"    {option['name']}: {type_of(option)}\n" for option in listed)
        marks = rf"(    # options of {mark}\n).*?(    # end of options\n)"
        text = re.sub(marks, lambda m, body=lines: m[1] + body + m[2], text, flags=re.DOTALL)
    return text


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--check", action="store_true", help="write nothing")
    check = parser.parse_args().check
    options = read_options()
    stale = []
    for path, made in ((PAGE, page_of), (STUB, stub_of), (KEYWORDS, typed_dicts_of)):
        old = path.read_text()
        new = made(old, options)
        if new == old:
            continue
        stale.append(path)
        if not check:
            path.write_text(new)
        print(f"{path.relative_to(ROOT)}: {'out of date' if check else 'written'}")
    return 1 if check and stale else 0


if __name__ == "__main__":
    sys.exit(main())
