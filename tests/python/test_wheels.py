"""What becomes the sdist and the wheels: the layout and what pyproject.toml names."""

from __future__ import annotations

import ast
import subprocess
import sys
import tomllib
from pathlib import Path
from typing import Any

import pytest

from conftest import ROOT


@pytest.fixture(scope="module")
def project(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("project") / "laid_out"
    subprocess.run([sys.executable, ROOT / "scripts/python_project.py", folder], check=True)
    return folder


@pytest.fixture(scope="module")
def described(project: Path) -> dict[str, Any]:
    return tomllib.loads((project / "pyproject.toml").read_text())


def test_sources_are_whole(project: Path, described: dict[str, Any]) -> None:
    """Every C++ file and header, and what pyproject.toml names, at their places below the root."""
    assert described["tool"]["scikit-build"]["cmake"]["source-dir"] == "."
    for folder in ("src", "include", "apps"):
        suffixes = {".cpp", ".h", ".hpp", ".py", ".pyi", ".csv", ".js", ".txt", ".cmake"}
        wanted = {p.relative_to(ROOT) for p in (ROOT / folder).rglob("*") if p.suffix in suffixes}
        missing = [p for p in wanted if not (project / p).exists() and "__pycache__" not in p.parts]
        assert wanted and not missing, missing
    names = [described["project"]["readme"], *described["project"]["license-files"]]
    for name in ("CMakeLists.txt", "scripts/wheels_image.sh", *names):
        assert (project / name).is_file(), name
    assert not (project / "tests").exists()


def test_commands_are_functions(project: Path, described: dict[str, Any]) -> None:
    scripts = described["project"]["scripts"]
    wanted = {
        "tank_datum",
        "tank_datum_compare",
        "tank_datum_convert",
        "tank_datum_report",
        "tank_datum_qa",
        "tank_datum_synth",
    }
    assert wanted <= scripts.keys()
    for place in scripts.values():
        module, _, function = place.partition(":")
        source = (project / "src/python" / module.replace(".", "/")).with_suffix(".py").read_text()
        names = [node.name for node in ast.parse(source).body if isinstance(node, ast.FunctionDef)]
        assert function in names, place


def test_one_build_folder_an_interpreter(described: dict[str, Any]) -> None:
    assert described["tool"]["scikit-build"]["build-dir"].endswith("-{wheel_tag}")
    versions = described["tool"]["cibuildwheel"]["build"]
    assert all(f"cp3{minor}-" in versions for minor in (11, 12, 13, 14))
