"""Puts files into a folder as plot.py does: put_files.py FOLDER NAME=CONTENT..."""

from __future__ import annotations

import signal
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "src" / "python"))
from tank_datum_qa._result_folder import ResultFolder  # noqa: E402
from tank_datum_qa._result_journal import ResultError  # noqa: E402


def main() -> int:
    signal.signal(signal.SIGTERM, lambda number, _: sys.exit(128 + number))
    try:
        with ResultFolder(Path(sys.argv[1]), "plot.py") as new:
            for given in sys.argv[2:]:
                name, content = given.split("=")
                (new / name).write_text(content)
    except (OSError, ResultError) as error:
        print(f"put_files.py: {error}, expected a folder that can be written to", file=sys.stderr)
        return 3
    return 0


if __name__ == "__main__":
    sys.exit(main())
