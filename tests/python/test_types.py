"""What mypy --strict and pyright say of the installed package and of the examples in the pages."""

from __future__ import annotations

import importlib.util
import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from conftest import ROOT
from results import Run

STUBS = ROOT / "src" / "python" / "stubs"  # of packages that have no types
PACKAGES = ("tank_datum", "tank_datum_qa")
FARM = ("distributed", "sqlalchemy", "alembic")  # what the types of tank_datum.farm need
PAGES = (ROOT / "README.md", *sorted((ROOT / "src" / "doc").glob("*.md")))


def examples() -> dict[str, str]:
    """The Python blocks of the documentation, by the name of a module."""
    found = {}
    for page in PAGES:
        for i, block in enumerate(
            re.findall(r"^```python\n(.*?)^```", page.read_text(), re.M | re.S)
        ):
            found[f"example_{page.stem}_{i}.py".replace("-", "_")] = block
    return found


@pytest.fixture(scope="module")
def project(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A project that holds the packages as they are installed, and the examples."""
    folder = tmp_path_factory.mktemp("typed")
    for package in PACKAGES:
        found = importlib.util.find_spec(package)
        if found is None or found.origin is None:
            pytest.skip("the module is not installed")
        installed = Path(found.origin).parent
        assert (installed / "py.typed").is_file()
        keep = [p.name for p in installed.iterdir() if p.suffix in (".py", ".pyi", ".typed")]
        (folder / package).mkdir()
        for name in keep:
            shutil.copyfile(installed / name, folder / package / name)
        if (installed / "farm").is_dir():
            ignored = shutil.ignore_patterns("__pycache__")
            shutil.copytree(installed / "farm", folder / package / "farm", ignore=ignored)
    for name, text in examples().items():
        (folder / name).write_text(text)
    shutil.copytree(STUBS, folder / "typings")
    environment = Path(sys.prefix)
    config = {"venvPath": str(environment.parent), "venv": environment.name}
    config |= {"pythonVersion": "3.11", "exclude": ["typings"]}
    (folder / "pyrightconfig.json").write_text(json.dumps(config))
    return folder


def mypy(folder: Path, *names: str) -> Run:
    words = [sys.executable, "-m", "mypy", "--strict", "--cache-dir", str(folder / ".mypy")]
    environment = os.environ | {"MYPYPATH": "typings"}
    return subprocess.run(
        [*words, *names], cwd=folder, env=environment, capture_output=True, text=True
    )


def pyright(folder: Path, *names: str) -> Run:
    words = [sys.executable, "-m", "pyright", "--pythonpath", sys.executable, *names]
    return subprocess.run(words, cwd=folder, capture_output=True, text=True)


def test_there_are_examples() -> None:
    assert {"example_python_0.py", "example_qa_0.py"} <= examples().keys()


def test_mypy_is_content(project: Path) -> None:
    result = mypy(project, *PACKAGES, *examples())
    assert result.returncode == 0, result.stdout + result.stderr
    assert "Success: no issues found" in result.stdout


@pytest.mark.parametrize("module", ["engine", "history", "_main"])
def test_the_farm_is_checked_too(project: Path, module: str) -> None:
    """A wrong type in it is seen."""
    for name in FARM:
        pytest.importorskip(name, reason="the extra farm is not installed")
    path = project / "tank_datum" / "farm" / f"{module}.py"
    text = path.read_text()
    path.write_text(f"{text}\nWRONG: int = 'text'\n")
    result = mypy(project, "tank_datum")
    path.write_text(text)
    line = text.count("\n") + 2
    assert result.returncode == 1 and f"farm/{module}.py:{line}: error" in result.stdout


def test_pyright_is_content(project: Path) -> None:
    result = pyright(project)
    assert result.returncode == 0, result.stdout + result.stderr
    assert "0 errors, 0 warnings" in result.stdout


RIGHT = """
import numpy as np
import tank_datum

one, other = np.zeros((9, 3), np.float32), np.zeros((9, 3))
setups = np.zeros(9, np.int64)
tank_datum.extract_datum([one, other])
tank_datum.extract_datums((one, other))
tank_datum.find_tanks([one, (other, 2), (one, setups)])
tank_datum.extract_datum(block for block in (one, other))
tank_datum.extract_datum(["north.pcd", "south.pcd"]).plot("covariance")
"""


@pytest.mark.parametrize("checker", [mypy, pyright])
def test_lists_of_arrays_of_two_types_are_right(project: Path, checker: object) -> None:
    (project / "right.py").write_text(RIGHT)
    assert callable(checker)
    result = checker(project, "right.py")
    (project / "right.py").unlink()
    assert result.returncode == 0, result.stdout


WRONG = """
import tank_datum

tank_datum.extract_datum("scan.pcd", stations="many")
tank_datum.extract_datums("scan.pcd", search="octree")
tank_datum.find_tanks("scan.pcd", colour="red")
tank_datum.extract_datum("scan.pcd").tilt.colour
tank_datum.extract_datum("scan.pcd").plot("pie")
tank_datum.extract_datum([1, 2])
"""


@pytest.mark.parametrize("checker", [mypy, pyright])
def test_a_wrong_option_is_seen(project: Path, checker: object) -> None:
    (project / "wrong.py").write_text(WRONG)
    assert callable(checker)
    result = checker(project, "wrong.py")
    (project / "wrong.py").unlink()
    assert result.returncode == 1
    for line in (4, 5, 6, 7, 8, 9):
        assert f"wrong.py:{line}:" in result.stdout, result.stdout
