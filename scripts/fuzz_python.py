"""Feeds what Python reads with damaged files: campaigns and cases files. They may be refused in the
reader's own way; anything else that is raised, and a file that takes long, is kept as a finding.
Usage: python scripts/fuzz_python.py campaign|cases SEEDS FINDINGS [--minutes N] [--seed N]
"""

from __future__ import annotations

import argparse
import hashlib
import random
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

from tank_datum.farm.campaign_file import read_campaign
from tank_datum.farm.errors import CampaignError
from tank_datum_qa._cases import CasesError, read_cases

READERS: dict[str, tuple[Callable[[Path], object], type[Exception]]] = {
    "campaign": (read_campaign, CampaignError),
    "cases": (read_cases, CasesError),
}
SLOW = 10.0  # s
VALUES = [
    *["nan", "inf", "-inf", "0", "-1", "1e300", "-0.0", "9" * 25, "0x7f", "true", '""', "[]", "{}"],
    *['"\\u0000"', '"\\ud800"', '"../../etc"', "2026-02-30", "0001-01-01", "07:32:00", "[[]]"],
    *[
        "[nan, nan]",
        '"' + "a" * 5000 + '"',
        "'''\n\n'''",
        "{a = {b = {}}}",
        '"file:///"',
        '"\u202e"',
    ],
]
DEEP = ["[" * 3000, "x = " + "[" * 2000 + "]" * 2000, ".".join(["a"] * 3000) + " = 1"]


def cut(text: bytes, dice: random.Random) -> bytes:
    start = dice.randrange(len(text) + 1)
    return text[:start] + text[start + dice.choice((1, 2, 8, 64, len(text))) :]


def flip(text: bytes, dice: random.Random) -> bytes:
    damaged = bytearray(text or b" ")
    for _ in range(dice.choice((1, 2, 8))):
        damaged[dice.randrange(len(damaged))] = dice.randrange(256)
    return bytes(damaged)


def revalue(text: bytes, dice: random.Random) -> bytes:
    """A key's value, replaced."""
    lines = text.split(b"\n")
    with_values = [i for i, line in enumerate(lines) if b"=" in line]
    if with_values:
        i = dice.choice(with_values)
        lines[i] = (
            lines[i].partition(b"=")[0] + b"= " + dice.choice(VALUES).encode("utf-8", "replace")
        )
    return b"\n".join(lines)


def repeat(text: bytes, dice: random.Random) -> bytes:
    """A line, elsewhere and again."""
    lines = text.split(b"\n")
    line = dice.choice(lines)
    for _ in range(dice.choice((1, 1, 1, 300))):
        lines.insert(dice.randrange(len(lines) + 1), line)
    return b"\n".join(lines)


def nest(text: bytes, dice: random.Random) -> bytes:
    return text + b"\n" + dice.choice(DEEP).encode()


def damaged(seeds: list[bytes], dice: random.Random) -> bytes:
    text = dice.choice(seeds)
    for _ in range(dice.choice((1, 1, 2, 4))):
        ways = (cut, flip, revalue, revalue, revalue, repeat, repeat)
        text = dice.choice((*ways, nest) if dice.random() < 0.05 else ways)(text, dice)
    return text


def complaint(reader: str, path: Path) -> str:
    """What is wrong with how a file is read; empty: nothing."""
    read, refusal = READERS[reader]
    began = time.process_time()
    try:
        read(path)
    except refusal:
        pass
    except Exception as error:
        return f"{type(error).__name__}: {str(error)[:200]}"
    took = time.process_time() - began
    return f"{took:.1f} s" if took > SLOW else ""


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("reader", choices=sorted(READERS))
    parser.add_argument("seeds", type=Path)
    parser.add_argument("findings", type=Path)
    parser.add_argument("--minutes", type=float, default=1.0)
    parser.add_argument("--seed", type=int, default=21)
    asked = parser.parse_args()
    dice = random.Random(asked.seed)
    seeds = [path.read_bytes() for path in sorted(asked.seeds.iterdir())]
    found: dict[str, str] = {}
    tried, end = 0, time.process_time() + 60 * asked.minutes
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "a.toml"
        while time.process_time() < end:
            path.write_bytes(damaged(seeds, dice))
            tried += 1
            why = complaint(asked.reader, path)
            kind = why.partition(":")[0]
            if why and kind not in found:
                digest = hashlib.sha1(path.read_bytes()).hexdigest()
                kept = asked.findings / f"{asked.reader}-{digest}"
                kept.write_bytes(path.read_bytes())
                found[kind] = why
                print(f"ERROR: {kept.name}: {why}")
    print(f"number_of_executed_units: {tried}")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
