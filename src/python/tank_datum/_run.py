"""Runs on scans: one datum, all of them, the tanks alone; and on levelling surveys."""

from __future__ import annotations

import inspect
import os
from collections.abc import Callable, Iterable
from typing import Any, cast

from tank_datum import _core
from tank_datum._arguments import path_bytes, real
from tank_datum._datum import Datum
from tank_datum._errors import FileError, short
from tank_datum._options import Options, Unpack
from tank_datum._points import Points, sources_of, split, tell_setups
from tank_datum._stream import Stream
from tank_datum._tank_records import FoundTank

Progress = Callable[[str], object] | Callable[[str, int, int], object]


def defaults() -> dict[str, Any]:
    """The options of extract_datum and their defaults, which are the C++ library's."""
    return _core.defaults()


def extract_datum(
    points: Points,
    *,
    progress: Progress | None = None,
    **options: Any,
) -> Datum:
    """The datum of the best seen tank in a scan, or of the one picked.

    points:
        an array of shape (n, 3) of numbers of any type and stride, vertical z, in `units`; the
        path of a scan of any format, of which E57, LAZ and COPC need the extra `formats`; a list of
        paths, which are stations of one tank; a list or an iterator of blocks of points, which are
        kept in memory; or a function that returns a fresh iterator of blocks for each of the few
        passes over a scan, of which one block at a time is held. A block is an array, or a tuple
        of an array and its setup: a number, or one for each point. Points that are not
        finite, and masked rows, are dropped. float32 and float64 are not copied.
    progress:
        called with the name of each stage as it begins; when it takes three arguments with stage,
        rows read in this pass over the scan, and rows of the scan (0: not known), at most ten
        times a second. What it raises ends the run.
    options:
        those of the command line with underscores; help() lists them, defaults() their values.
        `baseline` may be a Datum too.

    Raises OptionError (a ValueError) for a refused option, FileError (an OSError) for a file that
    cannot be read, TypeError for points or options of the wrong type. What the scan lacks is no
    exception but the result's status. Ctrl-C is heard within a second, and the interpreter's lock
    is free while it works.
    """
    return Datum._of(_run("extract_datum", points, progress, options)[0])


def extract_datums(
    points: Points, *, progress: Progress | None = None, **options: Unpack[Options]
) -> list[Datum]:
    """The datum of every tank in a scan, the best seen first; as the command's --all.

    Without a tank one result, whose status says so. Arguments and errors are extract_datum's.
    """
    return [
        Datum._of(made)
        for made in _run("extract_datums", points, progress, dict(options))
    ]


def find_tanks(
    points: Points, *, progress: Progress | None = None, **options: Unpack[Options]
) -> list[FoundTank]:
    """The tanks that stand in a scan, the best seen first, to the accuracy of a thinned sample.

    Arguments and errors are extract_datum's; `tank=found.circle` then extracts one of them.
    """
    return [
        FoundTank(made) for made in _run("find_tanks", points, progress, dict(options))
    ]


def read_levelling(
    path: str | os.PathLike[str], diameter: float, **options: Unpack[Options]
) -> Datum:
    """The datum of a levelling survey: a table with azimuth_deg, elevation and, where known, sigma.

    diameter: of the tank [m]. options: `units` of elevation and sigma, what the checks need, and a
    `baseline`. Raises OptionError naming file and line, FileError.
    """
    given = {
        "levelling": path_bytes("levelling", "path", path),
        "diameter": real("diameter", diameter),
    }
    keywords, more = _with_baseline(dict(options))
    return Datum._of(
        _core.run("read_levelling", [], [], keywords, {**given, **more}, None)[0]
    )


def _run(
    function: str, points: Any, progress: Progress | None, options: dict[str, Any]
) -> list[Any]:
    stream = _stream_of(points)
    sources = [] if stream else sources_of(points)
    if tell_setups(sources):
        stream = Stream(lambda: sources)
    paths, arrays = ([], []) if stream else split(sources)
    keywords, given = _with_baseline(options)
    if stream:
        given["blocks"] = stream
    try:
        return _core.run(function, paths, arrays, keywords, given, _teller(progress))
    except FileError:
        if stream and stream.raised:
            raise stream.raised from None
        raise


def _stream_of(points: Any) -> Stream | None:
    if not callable(points) or hasattr(points, "__array__"):
        return None
    return Stream(cast("Callable[[], Iterable[Any]]", points))


def _with_baseline(options: dict[str, Any]) -> tuple[dict[str, Any], dict[str, Any]]:
    """Keywords for the compiled part, and the baseline's text when it is a Datum."""
    baseline = options.get("baseline")
    if not isinstance(baseline, Datum):
        return options, {}
    return {**options, "baseline": os.fsencode(baseline.source)}, {
        "baseline_json": baseline.to_json()
    }


def _teller(
    progress: Progress | None,
) -> Callable[[str, int, int, bool], object] | None:
    """What the compiled part calls: with stage, rows and total, or where that is all, the stage."""
    if progress is None:
        return None
    if not callable(progress):
        raise TypeError(f"progress = {short(progress)}, expected a function, or None")
    told: Callable[..., object] = progress
    try:
        inspect.signature(told).bind("", 0, 0)
    except (TypeError, ValueError):
        return lambda stage, rows, total, begins: told(stage) if begins else None
    return lambda stage, rows, total, begins: told(stage, rows, total)


def _describe() -> None:
    """Lists the options in the documentation of extract_datum, and in its signature."""
    keywords = _core.keyword_help()
    if not isinstance(
        keywords, str
    ):  # the documentation is made without the compiled part
        return
    extract_datum.__doc__ = f"{extract_datum.__doc__}\n    Options:\n{keywords}"
    given = inspect.signature(extract_datum)
    kept = [p for p in given.parameters.values() if p.kind != p.VAR_KEYWORD]
    named = [
        inspect.Parameter(name, inspect.Parameter.KEYWORD_ONLY, default=value)
        for name, value in _core.defaults().items()
    ]
    extract_datum.__signature__ = given.replace(parameters=[*kept, *named])  # type: ignore[attr-defined]


_describe()
