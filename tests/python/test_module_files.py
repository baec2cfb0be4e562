"""What the Python module writes: whole or not at all, and beside the files of others."""

from __future__ import annotations

import errno
import signal
from pathlib import Path
from typing import Any

import pytest

from writers import saved, snapshot, under_way

tank_datum = pytest.importorskip("tank_datum", reason="the module is not installed")


def test_a_page_is_whole_and_other_files_are_kept(
    datum: Any, command: Path, tmp_path: Path
) -> None:
    page, theirs = (command / "report.html").read_bytes(), tmp_path / "theirs.html"
    theirs.write_text("mine")
    for _ in range(2):
        datum.report(theirs)
        assert theirs.read_bytes() == page
    assert sorted(path.read_bytes() for path in tmp_path.iterdir()) == sorted([page, b"mine"])
    for place, number in ((tmp_path / "none" / "x.html", errno.ENOENT), (tmp_path, None)):
        with pytest.raises(tank_datum.FileError) as caught:
            datum.report(place)
        assert (caught.value.errno, caught.value.filename) == (number, str(place))
    with pytest.raises(tank_datum.FileError) as caught:
        datum.save(theirs / "below")
    assert str(caught.value).count("expected") == 1
    assert caught.value.errno == errno.ENOTDIR


@pytest.mark.parametrize("name", ["SIGTERM", "SIGINT", "SIGHUP"])
def test_saving_from_python_goes_on_to_its_end(tmp_path: Path, name: str) -> None:
    """A signal that comes while Datum.save writes is heard when the new result stands."""
    writer, out, number = saved(tmp_path), tmp_path / "out", signal.Signals[name]
    writer.fresh(out)
    assert writer.run(out).returncode == 0
    writer.after, writer.counted = snapshot(out), int((tmp_path / "count").read_text())
    assert writer.after != snapshot(writer.before) and writer.counted > 20
    for call in {1, 2, *range(3, writer.counted, 5), writer.counted}:
        writer.fresh(out)
        done = writer.run(out, stop_at=call, stop_with=number)
        assert done.returncode == -number, f"call {call}: {done.stderr}"
        assert (under_way(out), snapshot(out)) == ([], writer.after), f"call {call}"
