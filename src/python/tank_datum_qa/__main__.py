"""python -m tank_datum_qa"""

import sys

from tank_datum_qa._main import main

sys.exit(main())
