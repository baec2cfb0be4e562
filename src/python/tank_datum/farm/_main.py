"""The command tank_datum_farm."""

from __future__ import annotations

import argparse
import contextlib
import os
import sys
from collections.abc import Callable
from typing import Any

from tank_datum.farm.arguments import parsed
from tank_datum.farm.interrupts import interruptible

USABLE, NOT_ALL, WRONG_USE, NOT_DONE, STOPPED = 0, 1, 2, 3, 130
EXTRA = "tank_datum_farm: {}, expected the extra: pip install 'tank_datum[farm]'"


def printable(text: str, encoding: str | None = None) -> str:
    """Names from outside cannot steer the terminal, and any terminal takes them."""
    plain = "".join(c if c.isprintable() or c == "\n" else repr(c)[1:-1] for c in text)
    encoding = encoding or "utf-8"
    return plain.encode(encoding, "backslashreplace").decode(encoding)


def say(text: str) -> None:
    """Whoever reads it may go away before the end: a run goes on."""
    tell(text, sys.stdout)


def fail(text: str, status: int) -> int:
    tell(f"tank_datum_farm: {text}", sys.stderr)
    return status


def tell(text: str, stream: Any) -> None:
    if stream is not None:
        with contextlib.suppress(BrokenPipeError):
            print(printable(text, stream.encoding), file=stream, flush=True)


def check(options: argparse.Namespace) -> int:
    from tank_datum.farm.campaign_file import read_campaign
    from tank_datum.farm.plan import tasks_of

    campaign = read_campaign(options.file)
    tasks, missing = tasks_of(campaign)
    for survey, row in missing:
        say(f"{options.file}:{survey.line}: {row.reason}")
    size = sum(source.size for _, task in tasks for source in task.sources)
    say(
        f"{campaign.site}: {len(campaign.tanks)} tanks, {len(campaign.surveys)} surveys, "
        f"{len(missing)} missing, {size / 1e6:.1f} MB"
    )
    return NOT_ALL if missing else USABLE


def run(options: argparse.Namespace) -> int:
    from tank_datum.farm.campaign_file import read_campaign
    from tank_datum.farm.plan import STOPPED as INTERRUPTED

    alone = [name for name in ALONE if getattr(options, name)]
    if len(alone) > 1:
        words = " and ".join(f"--{name}" for name in alone)
        return fail(f"{words}, expected one of them", WRONG_USE)

    campaign = read_campaign(options.file)
    told: Callable[[str], None] = (lambda text: None) if options.quiet else say
    if options.shard:
        from tank_datum.farm.shard import run_shard

        number, of = options.shard
        ending = run_shard(campaign, number, of, told)
    else:
        from tank_datum.farm.run import Waits, run_campaign
        from tank_datum.farm.workers import Workers

        workers = Workers(options.scheduler, options.workers, options.memory)
        waits = Waits(options.database_wait, options.scheduler_wait)
        ending = run_campaign(campaign, workers, told, waits, collect=options.collect)
    for line in ending.lines():
        say(line)
    return STOPPED if ending.trouble == INTERRUPTED else ending.status


def status(options: argparse.Namespace) -> int:
    from tank_datum.farm.campaign_file import read_campaign
    from tank_datum.farm.history import open_history
    from tank_datum.farm.status import state_of

    campaign = read_campaign(options.file)
    history = open_history(campaign)
    try:
        state = state_of(campaign, history)
    finally:
        history.close()
    for line in state.lines():
        say(line)
    return USABLE if state.count("done") == len(state.surveys) else NOT_ALL


def report(options: argparse.Namespace) -> int:
    from tank_datum.farm.campaign_file import read_campaign
    from tank_datum.farm.site import write_site

    say(str(write_site(read_campaign(options.file))))
    return USABLE


def export(options: argparse.Namespace) -> int:
    from tank_datum.farm.campaign_file import read_campaign
    from tank_datum.farm.export import export_all

    for path in export_all(read_campaign(options.file), options.output):
        say(str(path))
    return USABLE


ALONE = ("shard", "collect", "scheduler")  # options that say where results come from
COMMANDS = {
    "check": check,
    "run": run,
    "status": status,
    "report": report,
    "export": export,
}


def main(arguments: list[str] | None = None) -> int:
    """The exit status: 0 all is well, 1 not every scan gave a datum, 2 wrong use or campaign, 3 a
    file, the database or the scheduler could not be reached, 130 stopped."""
    options = parsed(sys.argv[1:] if arguments is None else arguments)
    with interruptible():
        try:
            status = _main(options)
        except KeyboardInterrupt:
            status = fail("interrupted", STOPPED)
    _let_go()
    scheduler: str = getattr(options, "scheduler", "")
    if status == STOPPED and scheduler:
        # a client interrupted while it joins waits for its own loop when the interpreter ends
        os._exit(status)
    return status


def _let_go() -> None:
    """What the reader of the output did not take is no trouble at the end."""
    out: Any = sys.stdout
    if out is None:
        return
    try:
        out.flush()
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), out.fileno())


def _main(options: argparse.Namespace) -> int:
    try:
        from sqlalchemy.exc import SQLAlchemyError

        from tank_datum.farm.errors import CampaignError, FarmError
        from tank_datum.farm.history import cause
    except ImportError as error:
        print(EXTRA.format(error), file=sys.stderr)
        return WRONG_USE
    try:
        return COMMANDS[options.command](options)
    except CampaignError as error:
        for problem in error.problems:
            tell(str(problem), sys.stderr)
        return WRONG_USE
    except SQLAlchemyError as error:
        return fail(f"database: {cause(error)}", NOT_DONE)
    except (FarmError, OSError) as error:
        return fail(" ".join(str(error).split()), NOT_DONE)
    except ImportError as error:
        print(EXTRA.format(error), file=sys.stderr)
        return WRONG_USE


if __name__ == "__main__":
    sys.exit(main())
