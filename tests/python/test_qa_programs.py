"""What the programs that tank_datum_qa runs may do: say anything at any length, and not end."""

from __future__ import annotations

import contextlib
import os
import signal
import subprocess
import sys
import time
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import pytest

from programs import ROOT
from qa_command import fake, one_case, qa


def test_stderr_is_any_bytes(tmp_path: Path) -> None:
    command = fake(tmp_path, r"printf 'caf\351 \001\n' >&2; exit 3")
    result = qa(one_case(tmp_path), "--command", command, "--junit", tmp_path / "j.xml")
    assert result.returncode == 1 and "Traceback" not in result.stderr, result.stderr
    assert "exit status 3, expected 0: caf\\xe9" in result.stdout
    failure = ElementTree.parse(tmp_path / "j.xml").find("testcase/failure")
    assert failure is not None and "caf\\xe9 \\x01" in failure.get("message", "")


def test_long_stderr_is_cut_in_the_middle(tmp_path: Path) -> None:
    lines = 'i=0; while [ $i -lt 30000 ]; do echo "line $i."; i=$((i+1)); done >&2; exit 3'
    result = qa(one_case(tmp_path), "--command", fake(tmp_path, lines))
    assert result.returncode == 1
    assert "line 0." in result.stdout and "line 29999." in result.stdout
    assert "line 15000." not in result.stdout and len(result.stdout) < 20000
    assert " bytes left out ..." in result.stdout


def test_long_line_of_stderr_is_cut_too(tmp_path: Path) -> None:
    line = "head -c 3000000 /dev/zero | tr '\\0' x >&2; exit 3"
    result = qa(one_case(tmp_path), "--command", fake(tmp_path, line))
    assert "... 2991808 bytes left out ..." in result.stdout and len(result.stdout) < 20000


def test_what_ignores_the_end_is_killed(tmp_path: Path) -> None:
    """Also what it has started itself, which holds its stderr open."""
    command = fake(tmp_path, "trap '' TERM INT; echo $$ > pid; sleep 300 & wait; sleep 300")
    words = [sys.executable, ROOT / "scripts/qa.py", one_case(tmp_path), "--command", command]
    with subprocess.Popen(
        words,
        stderr=subprocess.PIPE,
        text=True,
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.default_int_handler),
    ) as running:  # a test run in the background may ignore SIGINT, and its children with it
        until = time.monotonic() + 20
        while not (tmp_path / "pid").exists() and time.monotonic() < until:
            time.sleep(0.05)
        running.send_signal(signal.SIGINT)
        said = running.communicate(timeout=20)[1]
    assert running.returncode == 128 + signal.SIGINT
    assert said == "qa: stopped by Interrupt\n"
    pid = (tmp_path / "pid").read_text().strip()
    assert pid not in living_groups()


def test_names_that_the_terminal_cannot_show(tmp_path: Path) -> None:
    cases = one_case(tmp_path, "Behälter ü")
    words = [sys.executable, ROOT / "scripts/qa.py", cases, "--list"]
    environment = os.environ | {"LC_ALL": "C", "PYTHONIOENCODING": "ascii"}
    result = subprocess.run(words, capture_output=True, text=True, env=environment)
    assert (result.returncode, result.stderr) == (0, "")
    assert result.stdout == "Beh\\xe4lter \\xfc: extract x\n"


def living_groups() -> set[str]:
    """The process groups, as Linux tells of each process that has not ended."""
    groups = set()
    for path in Path("/proc").glob("[0-9]*/stat"):
        with contextlib.suppress(OSError):
            state, _, group = path.read_text().split(")")[-1].split()[:3]
            groups |= {group} if state != "Z" else set()
    return groups


@pytest.mark.parametrize("name", ["datum.json", "stations.csv", "report.html"])
@pytest.mark.parametrize("kind", ["mkfifo", "mkdir"])
def test_results_that_are_no_files_are_a_difference(tmp_path: Path, kind: str, name: str) -> None:
    """Nothing is waited for, in the comparison and in the search for what tolerances are for."""
    (tmp_path / "a").mkdir()
    (tmp_path / "a" / name).write_text("{}")
    words = ["--command", fake(tmp_path, f'{kind} "$out/{name}"')]
    result = qa(one_case(tmp_path, more=f'files = ["{name}"]'), *words, timeout=20)
    assert result.returncode == 1 and "is no regular file" in result.stdout, result.stdout


@pytest.mark.parametrize("what", ["/dev/full", "closed pipe"])
def test_what_has_no_room_is_said_in_a_line(tmp_path: Path, what: str) -> None:
    command = fake(tmp_path, 'echo "{}" > "$out/datum.json"')
    words = [sys.executable, ROOT / "scripts/qa.py", one_case(tmp_path), "--command", command]
    read, write = os.pipe()
    os.close(read)
    with open("/dev/full", "wb") as full, os.fdopen(write, "wb") as pipe:
        into = full if what == "/dev/full" else pipe
        done = subprocess.run(words, stdout=into, stderr=subprocess.PIPE, text=True)
    assert done.returncode == 2 and done.stderr.count("\n") == 1, done.stderr
    assert done.stderr.startswith("qa: standard output, ")
