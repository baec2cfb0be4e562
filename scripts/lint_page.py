"""Lints the scripts of report and farm as their pages run them: joined, in the order of names.

lint_page.py OXLINT: the linter. Only joined do names that one script declares and another uses
have a meaning. What is found is printed with the script's own name and line; status 1 if anything.
"""

from __future__ import annotations

import json
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
PAGES = (ROOT / "src/report/page/js", ROOT / "src/python/tank_datum/farm/page")


def joined(scripts: list[Path]) -> tuple[str, list[tuple[str, int]]]:
    """The text, and for each of its lines the script and the line there."""
    text, places = "", []
    for script in scripts:
        lines = script.read_text().splitlines()
        text += "".join(f"{line}\n" for line in lines)
        places += [(str(script.relative_to(ROOT)), number) for number in range(1, len(lines) + 1)]
    return text, places


def findings(oxlint: str, text: str, places: list[tuple[str, int]]) -> list[str]:
    """A line for each finding."""
    with tempfile.TemporaryDirectory() as folder:
        page = Path(folder) / "page.js"
        page.write_text(text)
        done = subprocess.run(
            [oxlint, "-c", ROOT / ".oxlintrc.json", "--format=json", page],
            capture_output=True,
            text=True,
        )
    found = []
    for each in json.loads(done.stdout)["diagnostics"]:
        line = each["labels"][0]["span"]["line"] if each["labels"] else 1
        name, number = places[line - 1]
        found.append(f"{name}:{number}: {each['message']} ({each.get('code', 'syntax')})")
    return found


def main() -> int:
    found = []
    for folder in PAGES:
        text, places = joined(sorted(folder.glob("*.js")))
        found += findings(sys.argv[1], text, places)
    print("\n".join(found), end="\n" if found else "")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
