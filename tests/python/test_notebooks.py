"""The notebooks run from top to bottom, by themselves."""

from __future__ import annotations

import ast
import json
from pathlib import Path
from typing import Any

import pytest

from conftest import ROOT

pytest.importorskip("tank_datum", reason="the module is not installed")
matplotlib = pytest.importorskip("matplotlib")

NOTEBOOKS = sorted((ROOT / "scripts/notebooks").glob("*.ipynb"))


def run_cell(source: str, names: dict[str, Any]) -> Any:
    """Runs a cell; what its last line gives, which a notebook shows."""
    body = ast.parse(source).body
    last = ast.Expression(body.pop().value) if isinstance(body[-1], ast.Expr) else None
    exec(compile(ast.Module(body, []), "cell", "exec"), names)
    return eval(compile(last, "cell", "eval"), names) if last else None


def test_there_are_three() -> None:
    assert [path.stem for path in NOTEBOOKS] == ["first_datum", "scanner_distance", "two_surveys"]


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_notebook_runs(
    path: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    matplotlib.use("Agg")
    monkeypatch.chdir(tmp_path)  # no file from elsewhere
    book = json.loads(path.read_text())
    assert all(cell["cell_type"] != "code" or not cell["outputs"] for cell in book["cells"])
    names: dict[str, Any] = {}
    shown = [
        run_cell("".join(cell["source"]), names)
        for cell in book["cells"]
        if cell["cell_type"] == "code"
    ]
    printed = capsys.readouterr().out
    if path.stem == "first_datum":
        assert "<svg" in shown[1]._repr_html_()
        assert 85 <= float(printed.split(" mm, ")[1].split()[0]) <= 100
    elif path.stem == "two_surveys":
        assert names["moved"].significant > 10 and shown[-1] == 0
    else:
        assert printed.count("standard error") == 3
