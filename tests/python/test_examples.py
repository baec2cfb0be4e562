"""The Python block of src/doc/python.md, run as it stands."""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from conftest import ROOT

pytest.importorskip("tank_datum", reason="the module is not installed")


def test_documented_lines_run(tmp_path: Path) -> None:
    page = (ROOT / "src" / "doc" / "python.md").read_text()
    block = re.search(r"```python\n(.*?)```", page, re.DOTALL)
    assert block is not None
    for name in ("scan.pcd", "scan2.pcd"):
        shutil.copyfile(ROOT / "tests" / "data" / "sample.pcd", tmp_path / name)
    (tmp_path / "example.py").write_text(block[1])
    run = subprocess.run(
        [sys.executable, "example.py"], cwd=tmp_path, capture_output=True, text=True, timeout=600
    )
    assert run.returncode == 0, run.stderr
    assert run.stdout.startswith("ok Verdict(word='INCOMPLETE'"), run.stdout
    assert (tmp_path / "2024" / "report.html").is_file()
    rates = re.findall(r"-?\d+\.?\d*(?:e-?\d+)?", run.stdout[run.stdout.rindex("[") :])
    assert rates and all(float(rate) == 0.0 for rate in rates)  # of a scan and its copy
