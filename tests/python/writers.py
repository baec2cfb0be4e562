"""Programs that write into a folder, what stood there before, and calls that fail."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path

from programs import ROOT, executable
from results import Run

TABLE = ROOT / "tests" / "data" / "levelling" / "fourteen_stations.csv"
Snapshot = dict[str, object]


def snapshot(folder: Path) -> Snapshot:
    """Everything in a folder but what is under way: bytes of files, targets of links."""
    found: Snapshot = {}
    for path in sorted(folder.rglob("*")):
        name = str(path.relative_to(folder))
        if name.startswith(".tank_datum-"):
            continue
        if path.is_symlink():
            found[name] = ("link", os.readlink(path))
        elif path.is_file():
            found[name] = path.read_bytes()
        else:
            found[name] = "folder"
    return found


def under_way(folder: Path) -> list[str]:
    return sorted(p.name for p in folder.glob(".tank_datum-*")) if folder.exists() else []


@dataclass
class Writer:
    """A program run on a folder; {out} in its words is that folder."""

    name: str
    words: Sequence[object]
    before: Path
    counted: int = 0
    after: Snapshot = field(default_factory=dict)

    def run(self, out: Path, **fault: int) -> Run:
        environment = os.environ | {
            "LD_PRELOAD": str(executable("fail_at_call.so")),
            "TANK_DATUM_CALLS_BELOW": str(out),
            "TANK_DATUM_COUNT_FILE": str(out.parent / "count"),
            "ASAN_OPTIONS": "verify_asan_link_order=0:detect_leaks=0",
        }
        environment |= {f"TANK_DATUM_{k.upper()}": str(v) for k, v in fault.items()}
        words = [str(w).format(out=out) for w in self.words]
        words[0] = sys.executable if words[0] == "python" else str(executable(words[0]))
        return subprocess.run(
            words, env=environment, cwd=out.parent, capture_output=True, text=True, timeout=60
        )

    def fresh(self, out: Path) -> None:
        if out.exists():
            shutil.rmtree(out)
        if self.before.exists():
            shutil.copytree(self.before, out, symlinks=True)


def foreign(folder: Path) -> None:
    """Things of somebody else beside a result."""
    (folder / "tank_7.pcd").write_text("a scan")
    (folder / "tank_notes.txt").write_text("notes")
    (folder / ".hidden").write_text("hidden")
    (folder / "tank_archive").symlink_to("..")


def levelling(root: Path) -> Writer:
    words = ["tank_datum", "--stations-csv", TABLE, "--diameter", 42, "--quiet", "--no-report"]
    before = root / "levelling"
    base = Writer("", [*words, "-o", "{out}"], root / "none")
    assert base.run(before).returncode == 0
    foreign(before)
    return Writer("levelling", [*words, "-o", "{out}", "--height", 18], before)


def first(root: Path) -> Writer:
    words = ["tank_datum", "--stations-csv", TABLE, "--diameter", 42, "--quiet", "--no-report"]
    return Writer("first", [*words, "-o", "{out}"], root / "none")


def compare(root: Path) -> Writer:
    table = "tank_datum --diameter 42 --quiet --no-report --stations-csv".split()
    for name, rise in (("a", 0.0), ("b", 0.01), ("c", 0.03)):
        rows = "".join(f"{10 * i},{(i % 5) * rise},0.001\n" for i in range(36))
        (root / f"{name}.csv").write_text("azimuth_deg,elevation,sigma\n" + rows)
        run = Writer("", [*table, root / f"{name}.csv", "-o", "{out}"], root / "none")
        assert run.run(root / f"epoch_{name}").returncode == 0
    words = ["tank_datum_compare", root / "epoch_a", root / "epoch_b", "-o", "{out}"]
    before = root / "compare"
    assert Writer("", words, root / "none").run(before).returncode == 0
    foreign(before)
    (before / "report.html").write_text("edited by hand")
    return Writer("compare", [words[0], root / "epoch_a", root / "epoch_c", "-o", "{out}"], before)


def tanks(root: Path) -> Writer:
    """Three tanks' folders become two, one of them a link meanwhile; a file is edited."""
    before, names = root / "tanks", ("datum.json", "stations.csv")
    old = [f"tank_{i}/{n}=old {i}" for i in (1, 2, 3) for n in names]
    words = ["results_probe", "tank_datum", "{out}"]
    assert Writer("", [*words, *old], root / "none").run(before).returncode == 0
    foreign(before)
    (before / "tank_3" / "mine.txt").write_text("stays")
    (before / "tank_1" / "datum.json").write_text("edited by hand")
    shutil.move(before / "tank_2", before / "elsewhere")
    (before / "tank_2").symlink_to("elsewhere")
    new = [f"tank_{i}/{n}=new {i}" for i in (1, 2) for n in names]
    return Writer("tanks", [*words, *new], before)


def scan(root: Path) -> Writer:
    words = "tank_datum_synth --radius 2 --scanners 1 --step-deg 4 --quiet".split()
    before = root / "scan"
    before.mkdir()
    place = ["-o", "{out}/s.pcd"]
    assert Writer("", [*words, *place], root / "none").run(before).returncode == 0
    foreign(before)
    return Writer("scan", [*words, *place, "--seed", 2], before)


def pictures(root: Path) -> Writer:
    """What plot.py does with its pictures, without drawing any."""
    before = root / "pictures"
    words = ["python", "-S", "-E", ROOT / "tests" / "python" / "put_files.py", "{out}"]
    old = [*words, "cloud.png=1", "cloud.svg=1", "elevation.png=1"]
    assert Writer("", old, root / "none").run(before).returncode == 0
    foreign(before)
    (before / "cloud.svg").write_text("edited by hand")
    return Writer("pictures", [*words, "cloud.png=2", "cloud.svg=2"], before)


def saved(root: Path) -> Writer:
    """Datum.save from Python, on what the program wrote."""
    made = levelling(root)
    other = root / "other"
    made.fresh(other)
    assert Writer("", made.words, root / "none").run(other).returncode == 0
    words = ["python", ROOT / "tests" / "python" / "save_datum.py", other / "datum.json", "{out}"]
    return Writer("saved", words, made.before)


WRITERS = (levelling, first, compare, tanks, scan, pictures)
