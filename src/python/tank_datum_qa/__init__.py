"""Runs the commands of tank_datum on scans and compares their results with fixtures.

    tank_datum_qa CASES.toml [-k WORD] [--list] [--update] [--junit FILE] [--jobs N] [--command PATH]

CASES.toml lists cases; paths in it are relative to it, and runs start in its folder. Fixtures and
files stay below it, and `options` name no outputs:

    [tolerance]                     # of every case; absolute, in the value's unit
    "*sigma*" = 1e-6
    "input.files.*.path" = "ignore"

    [[case]]
    name = "tank 7, spring"
    command = "extract"             # or "compare": inputs are results or datum.json;
                                    # or "levelling": one table, --diameter among the options
    inputs = ["north.pcd", "south.pcd"]
    options = ["--stations", "180"]
    fixture = "tank7"               # folder with what is compared; default: the name
    status = 0                      # the exit status expected, 0 or 1
    files = ["datum.json", "stations.csv"]      # of a comparison: movement.json, movement.csv
    [case.tolerance]                # looked at before the common ones
    "stations.csv:z" = 0.00005

A pattern of a tolerance is a column or a key, a.b.0.c, where * stands for anything; one that is for
no value is refused. What moved is printed, a row a column or array: how many values, the furthest
beyond what it may, where, and how much is allowed. Exit status: 0 all within tolerance; 1 a case
failed; 2 wrong use, or a file that cannot be written.
With --update the fixtures are rewritten after the differences have been shown; what stands there
that tank_datum did not write is kept under another name.

In pytest the same cases run with `pytest --tank-datum-cases CASES.toml`, and the fixture
`tank_datum_qa` runs one by name.
"""

from collections.abc import Callable
from pathlib import Path

from tank_datum_qa._run import Outcome

__all__ = ["Outcome", "RunCase"]

RunCase = Callable[[str | Path, str], Outcome]  # the fixture of pytest: file, name
