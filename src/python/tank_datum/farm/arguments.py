"""The words after tank_datum_farm."""

from __future__ import annotations

import argparse
import math
from pathlib import Path
from typing import Any

MOST_WORKERS = 1000  # processes on this machine


def parsed(arguments: list[str]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="tank_datum_farm",
        description="The datums of a tank farm, survey after survey: src/doc/farm.md says how.",
    )
    commands = parser.add_subparsers(dest="command", required=True, metavar="COMMAND")
    _add(
        commands,
        "check",
        "read the whole campaign, scans not opened; say what is wrong",
    )
    _run_options(_add(commands, "run", "extract what is missing or changed"))
    _add(commands, "status", "what is done, what failed and why")
    _add(commands, "report", "write the pages of the farm")
    export = _add(commands, "export", "write the history as CSV, Parquet and JSON")
    export.add_argument(
        "-o", "--output", type=Path, default=Path("export"), metavar="DIR"
    )
    return parser.parse_args(arguments)


def _add(commands: Any, name: str, text: str) -> argparse.ArgumentParser:
    command: argparse.ArgumentParser = commands.add_parser(
        name, help=text, description=text
    )
    command.add_argument("file", metavar="FILE", help="the campaign (TOML)")
    return command


def _run_options(run: argparse.ArgumentParser) -> None:
    run.add_argument(
        "--workers", type=_whole, default=0, metavar="N", help="processes; one a core"
    )
    run.add_argument(
        "--memory",
        type=_bytes,
        default=0,
        metavar="SIZE",
        help="of all workers, as 16G",
    )
    run.add_argument(
        "--scheduler",
        type=_scheduler,
        default="",
        metavar="ADDRESS|FILE",
        help="a Dask scheduler that exists",
    )
    run.add_argument(
        "--shard",
        type=_shard,
        metavar="I/N",
        help="the I-th of N parts, here, without a scheduler",
    )
    run.add_argument(
        "--collect", action="store_true", help="only record what the shards have stored"
    )
    for name, default in (("--database-wait", 120.0), ("--scheduler-wait", 60.0)):
        text = "while it is away [s]"
        run.add_argument(name, type=_seconds, default=default, metavar="S", help=text)
    run.add_argument("--quiet", action="store_true", help="the last lines only")


def _whole(text: str) -> int:
    if not (text.isdecimal() and 1 <= int(text) <= MOST_WORKERS):
        raise argparse.ArgumentTypeError(f"{text}, expected 1 to {MOST_WORKERS}")
    return int(text)


def _seconds(text: str) -> float:
    value = _number(text)
    if not 0.0 <= value < 1e6:
        raise argparse.ArgumentTypeError(f"{text}, expected seconds, 0 or more")
    return value


def _bytes(text: str) -> int:
    scale = {"k": 1e3, "m": 1e6, "g": 1e9, "t": 1e12}.get(text[-1:].lower(), 0.0)
    value = _number(text[:-1]) * scale if scale else _number(text)
    if not 1e6 <= value < 1e18:
        raise argparse.ArgumentTypeError(f"{text}, expected bytes as 16G, 1M at least")
    return int(value)


def _number(text: str) -> float:
    """Not a number where the text is none."""
    try:
        return float(text)
    except ValueError:
        return math.nan


def _scheduler(text: str) -> str:
    """Empty, which is the default: none."""
    _, _, port = text.rpartition(":")
    if text and not (Path(text).is_file() or port.isdecimal()):
        raise argparse.ArgumentTypeError(
            f"{text}, expected HOST:PORT or a scheduler file that exists"
        )
    return text


def _shard(text: str) -> tuple[int, int]:
    number, _, of = text.partition("/")
    if not (number.isdecimal() and of.isdecimal() and 1 <= int(number) <= int(of)):
        raise argparse.ArgumentTypeError(f"{text}, expected I/N with 1 <= I <= N")
    return int(number), int(of)
