"""python -m tank_datum.farm is the command tank_datum_farm."""

import sys

from tank_datum.farm._main import main

sys.exit(main())
