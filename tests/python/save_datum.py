"""Saves a result as Datum.save does: save_datum.py DATUM_JSON FOLDER."""

from __future__ import annotations

import signal
import sys

import tank_datum


def main() -> int:
    signal.signal(signal.SIGINT, signal.default_int_handler)  # ignored in background jobs
    signal.signal(signal.SIGHUP, signal.SIG_DFL)
    datum = tank_datum.load(sys.argv[1])
    try:
        datum.save(sys.argv[2])
    except tank_datum.FileError as error:
        print(error, file=sys.stderr)
        return 3
    return 0


if __name__ == "__main__":
    sys.exit(main())
