"""README is short, links of the documentation lead somewhere, options.md is what --help prints."""

from __future__ import annotations

import json
import re
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from results import Run

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "scripts"))

import option_docs  # noqa: E402

OPTIONS = ROOT / "src/doc/options.md"
PAGES = [
    ROOT / "README.md",
    ROOT / "src/README.md",
    ROOT / ".github/CONTRIBUTING.md",
    *sorted((ROOT / "src/doc").glob("*.md")),
]
MOST_WORDS = 1500
LONG_OPTION = r"--[a-z][a-z-]*"


def without_code(text: str) -> str:
    """Without blocks of code and words of code: no links stand there, nor headings."""
    text = re.sub(r"^```.*?^```$", "", text, flags=re.MULTILINE | re.DOTALL)
    text = re.sub(r"^    .*$", "", text, flags=re.MULTILINE)
    return re.sub(r"`[^`\n]*`", lambda word: word[0].replace("[", "").replace("]", ""), text)


def anchors(text: str) -> set[str]:
    """What the headings of a page are linked by."""
    headings = re.findall(r"^#+ (.+)$", without_code(text), re.MULTILINE)
    return {re.sub(r"[^\w -]", "", heading.lower()).replace(" ", "-") for heading in headings}


def broken_links(text: str, page: Path) -> list[str]:
    """A line for each link of the page's text to a file or a heading that is not there."""
    broken = []
    for link in re.findall(r"\[[^\]]*\]\(([^)\s]+)\)", without_code(text)):
        if re.match(r"[a-z]+:", link):
            continue  # of another site
        path, _, anchor = link.partition("#")
        target = page.parent / path if path else page
        if not target.exists():
            broken.append(f"{page.name}: {link}: there is no such file")
        elif anchor and anchor not in anchors(target.read_text()):
            broken.append(f"{page.name}: {link}: there is no such heading")
    return broken


def options_of_help(text: str) -> set[str]:
    """Long options that --help lists: the first words of its lines."""
    names = re.findall(r"^ {2}(-\S+)", text, re.MULTILINE)
    return {option for name in names for option in re.findall(LONG_OPTION, name)}


def options_of_page(text: str) -> set[str]:
    """Long options in the first column of a page's tables."""
    cells = re.findall(r"^\| (`-(?:[^|\\]|\\.)*)\|", text, re.MULTILINE)
    return {option for cell in cells for option in re.findall(LONG_OPTION, cell)}


def test_readme_is_short() -> None:
    words = len((ROOT / "README.md").read_text().split())
    assert words <= MOST_WORDS


@pytest.mark.parametrize("page", PAGES, ids=lambda page: str(page.relative_to(ROOT)))
def test_links_lead_somewhere(page: Path) -> None:
    broken = broken_links(page.read_text(), page)
    assert not broken, "\n".join(broken)


def test_readme_leads_to_every_page() -> None:
    text = (ROOT / "README.md").read_text()
    for page in sorted((ROOT / "src/doc").glob("*.md")):
        assert f"](src/doc/{page.name})" in text, f"README.md has no link to {page.name}"


def test_a_broken_link_is_named() -> None:
    page = ROOT / "README.md"
    assert broken_links("[a](src/doc/none.md)", page) == [
        "README.md: src/doc/none.md: there is no such file"
    ]
    assert broken_links("[a](src/doc/options.md#none)", page) == [
        "README.md: src/doc/options.md#none: there is no such heading"
    ]
    assert broken_links("[a](src/doc/options.md#code-checks) `[b](none.md)`", page) == []


def test_options_are_what_help_prints(run: Callable[..., Run]) -> None:
    result = run("--help")
    assert result.returncode == 0
    printed = options_of_help(result.stdout)
    documented = options_of_page(OPTIONS.read_text())
    assert {"--k", "--output", "--no-clockwise"} <= printed  # so that no empty sets are compared
    assert sorted(printed - documented) == [], "not in src/doc/options.md"
    assert sorted(documented - printed) == [], "not printed by tank_datum --help"


@pytest.fixture(scope="module")
def options(run: Callable[..., Run]) -> list[dict[str, Any]]:
    """What the command lists of its options."""
    found: list[dict[str, Any]] = json.loads(run("--print-options").stdout)
    return found


def test_options_page_and_stub_are_what_the_source_says(options: list[dict[str, Any]]) -> None:
    """Else: python scripts/option_docs.py writes them."""
    assert option_docs.PAGE.read_text() == option_docs.page_of(
        option_docs.PAGE.read_text(), options
    )
    assert option_docs.STUB.read_text() == option_docs.stub_of(
        option_docs.STUB.read_text(), options
    )


def test_every_option_has_its_place_on_the_page(options: list[dict[str, Any]]) -> None:
    topics = re.findall(r"<!-- options: (.+) -->", OPTIONS.read_text())
    assert sorted(topics) == sorted({option["topic"] for option in options})


def test_a_changed_option_is_seen_in_page_and_stub(options: list[dict[str, Any]]) -> None:
    changed = [option | {"help": "another | help"} for option in options if option["name"] == "k"]
    page, stub = option_docs.PAGE.read_text(), option_docs.STUB.read_text()
    row = "| `--k N` | another \\| help | >= 3 | 20 |"
    assert row in option_docs.page_of(page, changed) and row not in page
    lines = "    # another | help (>= 3)\n    k: int = 20,\n"
    assert lines in option_docs.stub_of(stub, changed) and lines not in stub
