"""The command tank_datum_qa from the source tree, without installing it: see its --help."""

from __future__ import annotations

import os
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / "src" / "python"))

from tank_datum_qa._main import main  # noqa: E402

if __name__ == "__main__":
    os.environ.setdefault("TANK_DATUM_BIN", str(ROOT / "build" / "bin"))
    sys.exit(main())
