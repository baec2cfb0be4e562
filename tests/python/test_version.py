"""There is one version number: that of CMakeLists.txt."""

from __future__ import annotations

import importlib.metadata
import re
import runpy
import subprocess
import tomllib

import pytest

from programs import ROOT, executable

PROGRAMS = [
    f"tank_datum{name}"
    for name in ("", "_bench", "_compare", "_convert", "_curves", "_rates", "_synth")
]


@pytest.fixture(scope="module")
def version() -> str:
    """That of CMake's project()."""
    text = (ROOT / "CMakeLists.txt").read_text()
    (found,) = re.findall(r"^project\(tank_datum VERSION (\d+\.\d+\.\d+) ", text, re.MULTILINE)
    return found


@pytest.mark.parametrize("program", PROGRAMS)
def test_programs(version: str, program: str) -> None:
    done = subprocess.run([executable(program), "--version"], capture_output=True, text=True)
    assert done.stdout == f"{program} {version}\n"


def test_python_package(version: str) -> None:
    """What is built, and what is installed."""
    project = tomllib.loads((ROOT / "scripts/pyproject.toml").read_text())
    assert "version" not in project["project"]
    taken = project["tool"]["scikit-build"]["metadata"]["version"]
    text = (ROOT / "scripts" / taken["input"]).read_text()
    assert re.search(taken["regex"], text)["value"] == version
    module = pytest.importorskip("tank_datum", reason="the module is not installed")
    assert module.__version__ == version
    assert importlib.metadata.version("tank_datum") == version


def test_documentation(version: str) -> None:
    assert runpy.run_path(str(ROOT / "src/doc/conf.py"))["release"] == version


def test_changes_begin_with_it(version: str) -> None:
    page = (ROOT / "src/doc/changes.md").read_text()
    headings = re.findall(r"^## (\S+)", page, re.MULTILINE)
    assert headings[0].rstrip(",") == version


def test_the_example_asks_for_it(version: str) -> None:
    page = (ROOT / "src/doc/pcl.md").read_text()
    assert re.findall(r"find_package\(tank_datum (\S+) ", page) == [version.rpartition(".")[0]]


def test_it_stands_nowhere_else(version: str) -> None:
    """In no source, script or page."""
    pages = [*(ROOT / "src").rglob("*"), *(ROOT / "apps").rglob("*"), *(ROOT / "scripts").glob("*")]
    pages += [ROOT / "README.md", *(ROOT / ".github").rglob("*")]
    texts = {".md", ".cpp", ".h", ".hpp", ".in", ".cmake", ".py", ".toml", ".txt", ".js", ""}
    named = re.compile(rf"version\W+{re.escape(version)}\b", re.IGNORECASE)
    for page in pages:
        if page.is_file() and page.suffix in texts:
            assert not named.search(page.read_text()), f"{page.relative_to(ROOT)} repeats {version}"
