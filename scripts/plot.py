"""Pictures of a result for documents: the paper's figures 5 to 8.

Exit status: 0; 1 the result holds no usable datum (then only the cloud is written); 2 wrong use;
3 a file could not be read or written.
"""

from __future__ import annotations

import argparse
import signal
import sys
from pathlib import Path

import plot_figures
from plot_result import PlotError, Result, read_cloud, read_result

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "src" / "python"))

from tank_datum_qa._result_folder import OutputIsInputError, ResultFolder, require_apart  # noqa: E402
from tank_datum_qa._result_journal import ResultError, settle_to_read  # noqa: E402

FORMATS = ("pdf", "svg", "png")
PICTURES = ("cloud", "datum_points", "residuals", "elevation")
RESULTS = ("datum.json", "stations.csv", "datum_points.pcd")
METADATA = {"pdf": {"CreationDate": None}, "svg": {"Date": None}, "png": {}}


def formats(text: str) -> list[str]:
    chosen = text.split(",")
    if not set(chosen) <= set(FORMATS):
        raise argparse.ArgumentTypeError(f"{text}, expected some of {','.join(FORMATS)}")
    return chosen


def arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="plot.py", description=__doc__)
    parser.add_argument("folder", type=Path, help="results of tank_datum")
    parser.add_argument("-o", "--output", type=Path, help="folder for the pictures (default: DIR)")
    parser.add_argument(
        "--formats", type=formats, default=list(FORMATS), help="some of pdf,svg,png"
    )
    parser.add_argument("--scan", type=Path, nargs="+", default=[], help="the scan when it moved")
    return parser.parse_args()


def say(text: str) -> None:
    print(f"plot.py: {text}", file=sys.stderr)


def figures_of(result: Result, folder: Path, scans: list[Path]) -> dict[str, plot_figures.Figure]:
    """By file name; without the cloud, and a line why, when the scan cannot be read."""
    pictures = {}
    try:
        cloud = read_cloud(result, folder, scans)
        pictures["cloud"] = plot_figures.cloud(result, cloud)
    except PlotError as error:
        if scans:
            raise
        say(f"the cloud is left out: {error}")
    if result.usable:
        pictures["datum_points"] = plot_figures.datum_points(result)
        pictures["residuals"] = plot_figures.residuals(result)
        pictures["elevation"] = plot_figures.elevation(result)
    return pictures


def require_untouched(args: argparse.Namespace, output: Path) -> None:
    """Refuses pictures in the place of what they are made of."""
    written = [output / f"{name}.{kind}" for name in PICTURES for kind in args.formats]
    read = [args.folder / name for name in RESULTS]
    require_apart([*args.scan, *read], [output, *written])


def draw(args: argparse.Namespace, output: Path) -> Result:
    """Reads the result, and writes all pictures or none."""
    settle_to_read(args.folder, "plot.py")
    result = read_result(args.folder)
    pictures = figures_of(result, args.folder, args.scan)
    with ResultFolder(output, "plot.py") as new:
        for name, figure in pictures.items():
            for kind in args.formats:
                figure.savefig(new / f"{name}.{kind}", metadata=METADATA[kind])
    return result


def main() -> int:
    args = arguments()
    output = args.output or args.folder
    signal.signal(signal.SIGTERM, lambda number, _: sys.exit(128 + number))
    try:
        require_untouched(args, output)
        result = draw(args, output)
    except OutputIsInputError as error:
        say(str(error))
        return 2
    except (PlotError, ResultError) as error:
        say(str(error))
        return 3
    except OSError as error:
        say(f"{error.filename}, {error.strerror}, expected a folder that can be written to")
        return 3
    if not result.usable:
        say(f"{result.datum['status']}: {result.datum['message']}")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
