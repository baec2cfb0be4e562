"""Where --junit writes: through links, devices and pipes, none of which it replaces."""

from __future__ import annotations

import os
import subprocess
import sys
import threading
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import pytest

from programs import ROOT
from qa_command import fake, one_case, qa

WRONG_USE = 2


def run_with(folder: Path, junit: Path) -> subprocess.CompletedProcess[str]:
    """A run whose case fails, as its program writes nothing."""
    return qa(one_case(folder), "--command", fake(folder, ""), "--junit", junit, timeout=60)


def cases_in(text: str) -> int:
    return int(ElementTree.fromstring(text).get("tests", "0"))


def test_link_is_followed(tmp_path: Path) -> None:
    (tmp_path / "link.xml").symlink_to("there/junit.xml")
    (tmp_path / "there").mkdir()
    for _ in range(2):
        result = run_with(tmp_path, tmp_path / "link.xml")
        assert (result.returncode, result.stderr) == (1, "")
    assert (tmp_path / "link.xml").is_symlink()
    assert cases_in((tmp_path / "there/junit.xml").read_text()) == 1
    assert [p.name for p in (tmp_path / "there").iterdir()] == ["junit.xml"]


def test_pipe_is_written_to(tmp_path: Path) -> None:
    pipe, read = tmp_path / "pipe", []
    os.mkfifo(pipe)
    reader = threading.Thread(target=lambda: read.append(pipe.read_text()), daemon=True)
    reader.start()
    result = run_with(tmp_path, pipe)
    reader.join(10)
    assert (result.returncode, result.stderr) == (1, "")
    assert pipe.is_fifo() and cases_in(read[0]) == 1


@pytest.mark.parametrize("into", ["pipe", "file"])
def test_standard_output_is_written_to(tmp_path: Path, into: str) -> None:
    """Behind what is printed, also where it goes to a file."""
    (tmp_path / "out").symlink_to("/dev/stdout")
    words = [sys.executable, ROOT / "scripts/qa.py", one_case(tmp_path), "--junit"]
    words += [tmp_path / "out", "--command", fake(tmp_path, "")]
    if into == "file":
        with (tmp_path / "printed").open("w") as file:
            assert subprocess.run(words, stdout=file).returncode == 1
        text = (tmp_path / "printed").read_text()
    else:
        text = subprocess.run(words, capture_output=True, text=True).stdout
    end = "</testsuite>"
    xml = text[text.index("<?xml") : text.index(end) + len(end)]
    assert text.startswith("FAIL  a\n") and cases_in(xml) == 1
    assert not any("kept" in path.name for path in tmp_path.iterdir())


def test_device_is_written_to(tmp_path: Path) -> None:
    (tmp_path / "null").symlink_to("/dev/null")
    assert run_with(tmp_path, tmp_path / "null").returncode == 1
    assert not (tmp_path / "null").is_file() and (tmp_path / "null").is_symlink()


@pytest.mark.parametrize("kind", ["folder", "loop", "/dev/full", "long"])
def test_what_takes_no_file_is_said(tmp_path: Path, kind: str) -> None:
    (tmp_path / "folder").mkdir()
    (tmp_path / "loop").symlink_to("loop")
    place = tmp_path / ("x" * 300 if kind == "long" else kind)
    result = run_with(tmp_path, place)
    assert result.returncode == WRONG_USE
    assert result.stderr.count("\n") == 1 and f"qa: junit: {place}, " in result.stderr
    assert ", expected a writable file" in result.stderr
    assert os.path.isdir(place) == (kind == "folder") and not list(tmp_path.glob("*kept*"))
