"""Seeds for scripts/fuzz: a small file of each kind that the readers know, most of them made by the
project's own writers.
Usage: python scripts/fuzz_seeds.py FOLDER     (TANK_DATUM_BIN names the folder of the programs)
"""

from __future__ import annotations

import json
import shutil
import sys
from pathlib import Path

import numpy as np
from format_writers import (
    SHIFT,
    Setups,
    in_floats,
    write_las,
    write_ply,
    write_pts,
    write_ptx,
    write_rows,
)
from results import write_pcd

from built import ROOT, call

KINDS = (
    "pcd las ply pts ptx xyz table origins limits json scene"
    " config about levelling baseline options campaign cases"
)
TABLES = {
    "origins": 'name,x,y,z\nscan_1,1.5,-2,3\n"scan, 2",1e3,0,.5\n',
    "table": 'azimuth_deg,z,flag\n0,1.5,measured\n1,,missing\n2,-1e-3,"measured"\n',
}


# What an option's value may be that somebody mistyped, or a script worked out wrongly.
NUMBERS = [
    "",
    "0",
    "-0.0",
    "-1",
    "1",
    "7",
    "1e-300",
    "1e9",
    "1e300",
    "99999999999999999999",
    "nan",
    "inf",
    "-inf",
]
KINDS_OF_NUMBERS = ("number", "integer", "length", "fact", "numbers", "integers")
CONFIGS = {
    "usual": "method = paper\nstations = 24\nclockwise = true\n# a note\nheights = 0.3,1\n",
    "strange": '[datum]\nk=1e300\nheight="26 ft"\ntank=[0,0,4]\nmark=stairs=75\n',
}
ABOUT = """tank = "T-1"
product = 'crude'
site = "Hafen Süd"
survey_date = 2026-11-03
inspector = \"\"\"A
B\"\"\"
report_number = 12
notes = "\\u00b5"
"""


def make_scans(folder: Path) -> None:
    random = np.random.default_rng(21)
    parts = [SHIFT + random.uniform(-5, 5, (40, 3)).round(4) for _ in range(3)]
    scan = Setups(parts, [np.zeros(3)] * 3)
    write_las(folder / "las/a.las", scan, "1.2", 1)
    write_las(folder / "las/b.las", scan, "1.4", 6)
    for order in "<", ">", "=":
        name = {"<": "little", ">": "big", "=": "text"}[order]
        write_ply(folder / f"ply/{name}.ply", in_floats(scan), order)
    write_pts(folder / "pts/a.pts", scan)
    write_ptx(folder / "ptx/a.ptx", scan)
    write_rows(folder / "xyz/a.xyz", scan, " ", "")
    write_rows(folder / "xyz/b.csv", scan, ",", "setup,x,y,z")
    columns = dict(zip("xyz", scan.all().T, strict=True))
    write_pcd(folder / "pcd/doubles.pcd", columns)
    for name, words in {"binary": [], "ascii": ["--ascii"], "setups": ["--label-setups"]}.items():
        tank = ["--radius", 2, "--height", 1, "--step-deg", 15, "--quiet"]
        call("tank_datum_synth", "-o", folder / f"pcd/{name}.pcd", *tank, *words)
        (folder / f"pcd/{name}.truth.json").unlink()


def make_compressed(folder: Path) -> None:
    """A binary PCD in literal runs of LZF, which any decompressor takes."""
    head, _, data = (folder / "pcd/doubles.pcd").read_bytes().partition(b"DATA binary\n")
    rows = np.frombuffer(data, dtype="<f8").reshape(-1, 3).T.tobytes()
    runs = [rows[i : i + 32] for i in range(0, len(rows), 32)]
    packed = b"".join(bytes([len(part) - 1]) + part for part in runs)
    sizes = np.array([len(packed), len(rows)], dtype="<u4").tobytes()
    (folder / "pcd/compressed.pcd").write_bytes(head + b"DATA binary_compressed\n" + sizes + packed)


def make_texts(folder: Path) -> None:
    for kind, text in TABLES.items():
        (folder / kind / "a.csv").write_text(text)
    (folder / "limits/a.csv").write_text(call("tank_datum", "--print-limits"))
    for scene in sorted((ROOT / "tests/scenes").glob("*.json")):
        shutil.copy(scene, folder / "scene" / scene.name)
    results = folder / "json/out"
    call("tank_datum", ROOT / "tests/data/sample.pcd", "-o", results, "--stations", 16, "--quiet")
    whole = json.loads((results / "datum.json").read_text())
    shutil.rmtree(results)
    (folder / "json/a.json").write_text(json.dumps(whole))


def option_lines() -> dict[str, list[str]]:
    """Words of command lines: each option with each value."""
    lines: dict[str, list[str]] = {}
    for option in json.loads(call("tank_datum", "--print-options")):
        flag = "--" + option["name"].replace("_", "-")
        values = NUMBERS if option["kind"] in KINDS_OF_NUMBERS else option.get("words", [])
        if option["kind"] == "circle":
            values = [f"0,0,{number}" for number in NUMBERS] + [
                f"{number},0,4" for number in NUMBERS
            ]
        for i, value in enumerate(values):
            lines[f"{option['name']}_{i}"] = [flag, value]
        if option["kind"] == "flag" and not option["name"].startswith("print"):
            lines[option["name"]] = [flag]
    return lines


def make_words(folder: Path) -> None:
    for name, text in CONFIGS.items():
        (folder / "config" / name).write_text(text)
    config = call("tank_datum", ROOT / "tests/data/sample.pcd", "--print-config")
    (folder / "config/all").write_text(config)
    (folder / "about/a.toml").write_text(ABOUT)
    for table in (ROOT / "tests/data/levelling").glob("*.csv"):
        shutil.copy(table, folder / "levelling" / table.name)
    shutil.copy(folder / "json/a.json", folder / "baseline/a.json")
    for name, words in option_lines().items():
        (folder / "options" / name).write_text("\n".join(words) + "\n")
    shutil.copy(ROOT / "scripts/farm_example.toml", folder / "campaign/a.toml")
    shutil.copy(ROOT / "tests/data/qa/cases.toml", folder / "cases/a.toml")


def main(folder: Path) -> None:
    shutil.rmtree(folder, ignore_errors=True)
    for kind in KINDS.split():
        (folder / kind).mkdir(parents=True)
    make_scans(folder)
    make_compressed(folder)
    make_texts(folder)
    make_words(folder)


if __name__ == "__main__":
    main(Path(sys.argv[1]))
