"""Man pages and completions: every flag that --help lists, and what a shell makes of them."""

from __future__ import annotations

import os
import re
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from conftest import ROOT, executable, run_program

NAMES = (
    "tank_datum",
    "tank_datum_compare",
    "tank_datum_convert",
    "tank_datum_report",
    "tank_datum_synth",
)


@pytest.fixture(scope="module")
def pages(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """What the build makes, from the same programs."""
    folder = tmp_path_factory.mktemp("pages")
    maker = [sys.executable, ROOT / "src/cmake/command_pages.py", folder]
    words = [*maker, *map(executable, NAMES), f"{sys.executable} -m tank_datum_qa"]
    environment = os.environ | {"PYTHONPATH": str(ROOT / "src/python")}
    subprocess.run([str(word) for word in words], env=environment, check=True)
    return folder


def flags_of_help(name: str) -> set[str]:
    text = run_program(name, ["--help"]).stdout.partition("Options:")[2]
    heads = re.findall(r"^ {2}(-\S+)", text, re.M)
    return {flag.partition("{")[0] for head in heads for flag in head.split(",")}


def completed(pages: Path, name: str, *words: str) -> set[str]:
    """What bash offers after these words."""
    line = " ".join(shlex.quote(word) for word in (name, *words))
    script = f"source {pages / 'bash' / name}; COMP_WORDS=({line}); COMP_CWORD={len(words)}; "
    script += f'_{name}; printf "%s\\n" "${{COMPREPLY[@]}}"'
    run = subprocess.run(
        ["bash", "-c", script], capture_output=True, text=True, check=True, cwd=pages
    )
    return set(run.stdout.split())


@pytest.mark.parametrize("name", NAMES)
def test_every_flag_has_its_place(pages: Path, name: str) -> None:
    flags = flags_of_help(name)
    assert {"--help", "--version"} <= flags and len(flags) > 4
    page = (pages / "man1" / f"{name}.1").read_text().replace("\\-", "-")
    assert {flag for flag in flags if f"\\fB{flag}\\fR" not in page} == set()
    assert completed(pages, name, "-") == flags
    zsh = (pages / "zsh" / f"_{name}").read_text()
    assert {flag for flag in flags if f"'{flag}[" not in zsh} == set()


def test_values_are_completed(pages: Path) -> None:
    assert completed(pages, "tank_datum", "--method", "") == {"refined", "paper"}
    assert completed(pages, "tank_datum", "--method", "p") == {"paper"}
    assert completed(pages, "tank_datum", "--k", "") == set()
    assert completed(pages, "tank_datum", "--up", "-") == {"-x", "-y", "-z"}
    assert {"man1", "bash"} <= completed(pages, "tank_datum", "--baseline", "")
    assert {"man1", "bash"} <= completed(pages, "tank_datum", "")
    assert "--update" in completed(pages, "tank_datum_qa", "--u")


@pytest.mark.skipif(shutil.which("groff") is None, reason="groff is not installed")
@pytest.mark.parametrize("name", [*NAMES, "tank_datum_qa"])
def test_man_pages_are_set_without_a_warning(pages: Path, name: str) -> None:
    page = pages / "man1" / f"{name}.1"
    words = ["groff", "-man", "-Tascii", "-ww", "-P-c", page]
    run = subprocess.run(words, capture_output=True, text=True, check=True)
    assert run.stderr == ""
    text = re.sub(".\b", "", run.stdout)
    assert f"NAME {name} - " in " ".join(text.split())
    for heading in ("NAME", "SYNOPSIS", "OPTIONS", "EXIT STATUS", "SEE ALSO"):
        assert f"\n{heading}\n" in text
