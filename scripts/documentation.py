"""Builds the documentation into build/docs; called by scripts/docs.

The pages are those of the repository, in the same folders, so that their links hold in both. Added
are a page a room with the reference of its public headers, a page for the Python package, and the
order of the pages: that of README's table.
"""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
OUT = ROOT / "build/docs"
PAGES = OUT / "source"
SECTIONS = (
    "briefdescription detaileddescription innernamespace innerclass enum typedef var func "
    "user-defined public-type public-func public-static-func public-attrib public-static-attrib "
    "protected-func"
)
PYTHON = """Python package
==============

.. automodule:: tank_datum
   :members: Datum, Comparison, Simulation, FoundTank, OptionError, FileError, extract_datum,
      extract_datums, find_tanks, read_levelling, load, compare, compare_curves, limits,
      limits_text, simulate, defaults
   :inherited-members: dict, ValueError, OSError

.. automodule:: tank_datum.stages
   :members:
"""


def contents(title: str, pages: list[str]) -> str:
    """A hidden table of contents, for the side of every page."""
    return "\n".join(["", "```{toctree}", ":hidden:", f":caption: {title}", "", *pages, "```", ""])


def rooms() -> list[str]:
    """The rooms that have public headers, bottom up; "." holds those of the whole chain."""
    listed = re.search(r"foreach\(room ([^)]*)\)", (ROOT / "src/CMakeLists.txt").read_text())[
        1
    ].split()
    return [room for room in listed if headers(room)]


def headers(room: str) -> list[Path]:
    return sorted((ROOT / "include/tank_datum" / room).glob("*.h"))


def reference(room: str) -> str:
    """The page of a room's headers."""
    title = "The chain" if room == "." else room
    lines = [title, "=" * len(title), ""]
    for header in headers(room):
        name = str(header.relative_to(ROOT / "include"))
        lines += [name, "-" * len(name), "", f".. doxygenfile:: {header.name}"]
        lines += [f"   :sections: {SECTIONS}", ""]
    return "\n".join(lines)


def copied(name: str) -> Path:
    target = PAGES / name
    target.parent.mkdir(parents=True, exist_ok=True)
    shutil.copy(ROOT / name, target)
    return target


def copy_pictures(page: Path) -> None:
    """Those that a page shows, at the places it names."""
    for picture in re.findall(r"!\[[^]]*\]\(([^)]+)\)", page.read_text()):
        copied(str((page.parent / picture).resolve().relative_to(PAGES.resolve())))


def lay_out() -> None:
    """The pages, as they stand in the repository, and those that are made."""
    shutil.rmtree(OUT, ignore_errors=True)
    readme = copied("README.md")
    for page in [
        *(ROOT / "src/doc").glob("*.md"),
        ROOT / "src/README.md",
        ROOT / ".github/CONTRIBUTING.md",
    ]:
        copy_pictures(copied(str(page.relative_to(ROOT))))
    for notebook in (ROOT / "scripts/notebooks").glob("*.ipynb"):  # taken along as they are
        copied(str(notebook.relative_to(ROOT)))
    copy_pictures(readme)
    made = PAGES / "reference"
    made.mkdir()
    (made / "python.rst").write_text(PYTHON)
    names = {room: "datum" if room == "." else room for room in rooms()}
    for room, name in names.items():
        (made / f"{name}.rst").write_text(reference(room))
    table = readme.read_text().partition("## Where to read on")[2]
    pages = list(dict.fromkeys(re.findall(r"\]\(([\w./]+)\.md\)", table)))
    library = [f"reference/{name}" for name in reversed(names.values())]
    with readme.open("a") as file:
        file.write(contents("Pages", [*pages, "src/README"]))
        file.write(contents("Reference", ["reference/python", *library]))


def main() -> int:
    lay_out()
    for command in (
        ["doxygen", "src/doc/Doxyfile"],
        [
            *(sys.executable, "-m", "sphinx", "-q", "-W", "--keep-going", "-b", "html"),
            *("-c", "src/doc", "-d", str(OUT / "doctrees"), str(PAGES), str(OUT / "html")),
        ],
    ):
        if subprocess.run(command, cwd=ROOT).returncode != 0:
            return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
