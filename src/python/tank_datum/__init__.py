"""The datum of a storage tank, the line where its shell meets the foundation, from a laser scan::

    import tank_datum
    datum = tank_datum.extract_datum("scan.pcd", stations=360)
    datum.stations["z"], datum.tilt.angle_arcsec, datum.status

Lengths are metres, angles degrees, coordinates the scan's own. The single stages on arrays are in
tank_datum.stages.
"""

from tank_datum import stages
from tank_datum._compare import Comparison, compare
from tank_datum._core import __version__
from tank_datum._datum import Datum
from tank_datum._errors import FileError, OptionError
from tank_datum._files import load
from tank_datum._record import Record
from tank_datum._records import (
    Antipodal,
    Check,
    Foundation,
    Harmonic,
    Levels,
    LocalSettlement,
    OutOfPlane,
    SecondDifferences,
    Spline,
    Tilt,
    Verdict,
    WorstPlace,
)
from tank_datum._run import (
    defaults,
    extract_datum,
    extract_datums,
    find_tanks,
    read_levelling,
)
from tank_datum._studies import (
    Curve,
    Limit,
    Simulation,
    Truth,
    compare_curves,
    limits,
    limits_text,
    simulate,
)
from tank_datum._survey_records import (
    Agreement,
    Input,
    InputFile,
    Lean,
    LimitRate,
    LimitRates,
    MeanMovement,
    Movement,
    RestMovement,
    Setup,
    StationMovement,
    TankTest,
    TiltChange,
)
from tank_datum._tank_records import (
    FoundTank,
    Mark,
    Plumbness,
    Roundness,
    Shell,
    ShellLean,
    SurveyPoint,
    Tank,
)

__all__ = [
    "Agreement",
    "Antipodal",
    "Check",
    "Comparison",
    "Curve",
    "Datum",
    "FileError",
    "FoundTank",
    "Foundation",
    "Harmonic",
    "Input",
    "InputFile",
    "Lean",
    "Levels",
    "Limit",
    "LimitRate",
    "LimitRates",
    "LocalSettlement",
    "Mark",
    "MeanMovement",
    "Movement",
    "OptionError",
    "OutOfPlane",
    "Plumbness",
    "Record",
    "RestMovement",
    "Roundness",
    "SecondDifferences",
    "Setup",
    "Shell",
    "ShellLean",
    "Simulation",
    "Spline",
    "StationMovement",
    "SurveyPoint",
    "Tank",
    "TankTest",
    "Tilt",
    "TiltChange",
    "Truth",
    "Verdict",
    "WorstPlace",
    "__version__",
    "compare",
    "compare_curves",
    "defaults",
    "extract_datum",
    "extract_datums",
    "find_tanks",
    "limits",
    "limits_text",
    "load",
    "read_levelling",
    "simulate",
    "stages",
]
