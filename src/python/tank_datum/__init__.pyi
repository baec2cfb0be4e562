from collections.abc import Sequence
from os import PathLike
from typing import Any, Literal, TypeAlias

import numpy as np
from numpy.typing import NDArray

from tank_datum import stages as stages
from tank_datum._compare import Comparison as Comparison
from tank_datum._compare import compare as compare
from tank_datum._core import __version__ as __version__
from tank_datum._datum import Datum as Datum
from tank_datum._errors import FileError as FileError
from tank_datum._errors import OptionError as OptionError
from tank_datum._files import load as load
from tank_datum._points import Points
from tank_datum._record import Record as Record
from tank_datum._records import Antipodal as Antipodal
from tank_datum._records import Check as Check
from tank_datum._records import Foundation as Foundation
from tank_datum._records import Harmonic as Harmonic
from tank_datum._records import Levels as Levels
from tank_datum._records import LocalSettlement as LocalSettlement
from tank_datum._records import OutOfPlane as OutOfPlane
from tank_datum._records import SecondDifferences as SecondDifferences
from tank_datum._records import Spline as Spline
from tank_datum._records import Tilt as Tilt
from tank_datum._records import Verdict as Verdict
from tank_datum._records import WorstPlace as WorstPlace
from tank_datum._run import Progress
from tank_datum._run import defaults as defaults
from tank_datum._run import extract_datums as extract_datums
from tank_datum._run import find_tanks as find_tanks
from tank_datum._run import read_levelling as read_levelling
from tank_datum._studies import Curve as Curve
from tank_datum._studies import Limit as Limit
from tank_datum._studies import Simulation as Simulation
from tank_datum._studies import Truth as Truth
from tank_datum._studies import compare_curves as compare_curves
from tank_datum._studies import limits as limits
from tank_datum._studies import limits_text as limits_text
from tank_datum._studies import simulate as simulate
from tank_datum._survey_records import Agreement as Agreement
from tank_datum._survey_records import Input as Input
from tank_datum._survey_records import InputFile as InputFile
from tank_datum._survey_records import Lean as Lean
from tank_datum._survey_records import LimitRate as LimitRate
from tank_datum._survey_records import LimitRates as LimitRates
from tank_datum._survey_records import MeanMovement as MeanMovement
from tank_datum._survey_records import Movement as Movement
from tank_datum._survey_records import RestMovement as RestMovement
from tank_datum._survey_records import Setup as Setup
from tank_datum._survey_records import StationMovement as StationMovement
from tank_datum._survey_records import TankTest as TankTest
from tank_datum._survey_records import TiltChange as TiltChange
from tank_datum._tank_records import FoundTank as FoundTank
from tank_datum._tank_records import Mark as Mark
from tank_datum._tank_records import Plumbness as Plumbness
from tank_datum._tank_records import Roundness as Roundness
from tank_datum._tank_records import Shell as Shell
from tank_datum._tank_records import ShellLean as ShellLean
from tank_datum._tank_records import SurveyPoint as SurveyPoint
from tank_datum._tank_records import Tank as Tank

_Path: TypeAlias = str | PathLike[str]

def extract_datum(
    points: Points,
    *,
    progress: Progress | None = ...,
    # options, by scripts/option_docs.py
    # what z is: two surfaces intersected, or the paper's curve
    method: Literal["refined", "paper"] = "refined",
    # neighbours of a point, itself included (>= 3)
    k: int = 20,
    # theta: normals further apart than this mark a crease (> 0 and < 90 deg)
    angle_deg: float = 45.0,
    # distance from the circle within which edge points are kept [m]; 0: 0.1 m or a
    # tenth of the radius (>= 0 m)
    centre_tolerance: float = 0.0,
    # control points of the B-spline; 0: the data choose (0 or 4 to 1000)
    control_points: int = 0,
    # kNN engine: pcl::KdTreeFLANN, or the own tree, which finds the same faster
    search: Literal["flann", "buckets"] = "flann",
    # stations round the tank (8 to 36000)
    stations: int = 360,
    # where station 0 is, counter-clockwise from +x (-360 to 360 deg)
    zero_azimuth_deg: float = 0.0,
    # stations run clockwise seen from above
    clockwise: bool = False,
    # arc not seen that is bridged by the curve where it is seen on both sides; 0:
    # none is (>= 0 and < 360 deg)
    longest_bridge_deg: float = 10.0,
    # H,H,... above the datum at which the shell is surveyed [m]; none: 0.3 and
    # every step above (> 0 and <= 100 m and above the one before)
    heights: Sequence[float] | NDArray[np.floating[Any]] = ...,
    # between the heights of the shell [m]; with the courses' own all are 0.3 m
    # above a seam (>= 0.1 m)
    height_step: float = 0.5,
    # X,Y,R of the tank [m]: do not search for it (X,Y,R, of which R > 0 m)
    tank: tuple[float, float, float] | None = None,
    # which of the tanks found, the longest seen arc first (>= 1)
    pick: int = 1,
    # thin the ring to this many points for the edge search (>= 1000)
    search_points: int = 1000000,
    # of more points in the ring an even share is kept for the fits (>= 1000)
    fit_points: int = 4000000,
    # how well setups are registered in height and plan, 1 sigma [m]; 0: estimated
    # from their overlaps (0 to 1000 m)
    setup_error: float = 0.0,
    # how well they are levelled, 1 sigma about each axis; 0: estimated from their
    # overlaps (0 to 324000 arcsec)
    setup_tilt_arcsec: float = 0.0,
    # CSV file name,x,y,z: where setups stood, by file stem or label
    setup_origins: _Path | dict[str, tuple[float, float, float]] | None = None,
    # a setup far off the others: free of priors, dropped where others see the foot
    # too, or kept
    bad_setups: Literal["free", "drop", "keep"] = "free",
    # the smallest tank to look for [m] (> 0 m)
    min_radius: float = 2.0,
    # take a doubtful tank for one: message says which test it fails
    accept: bool = False,
    # the axis of the scan that is up; results are in the frame turned so
    up: Literal["x", "y", "z", "-x", "-y", "-z"] = "z",
    # turn the scan so that the shell stands upright; results are in that frame
    level: bool = False,
    # units of the input
    units: Literal["ft", "in", "m", "mm", "us-ft"] = "m",
    # classes of the points of LAS files that are read; none: all; points marked as
    # withheld never are (0 to 255 and above the one before)
    las_classes: Sequence[int] | NDArray[np.integer[Any]] = ...,
    # A,B,... setups of the scanner that are read, by their labels or files; none:
    # all
    setups: Sequence[str] = ...,
    # datum.json of an earlier survey: movement since then
    baseline: Datum | _Path | None = None,
    # what is taken from the movement: nothing, the mean, mean and tilt; auto:
    # nothing, but between levelling and scan the mean, since the rod does not stand
    # where the scan's datum is
    remove: Literal["auto", "none", "mean", "tilt"] = "auto",
    # 1 sigma of the height left between the surveys [m] (0 to 1000 m)
    registration_error: float = 0.0,
    # 1 sigma of the tilt left between them, about either level axis (0 to 324000
    # arcsec)
    registration_tilt_arcsec: float = 0.0,
    # turn of the later survey's frame, counter-clockwise (-360 to 360 deg)
    azimuth_offset_deg: float = 0.0,
    # find that turn by the datum's shape out of plane
    estimate_azimuth_offset: bool = False,
    # arc within which stations share errors; 0: as the surveys say themselves (0 to
    # 360 deg)
    correlation_deg: float = 0.0,
    # surveys whose radii differ by more are of different tanks [m] (> 0 m)
    radius_difference: float = 0.05,
    # the same of their centres [m] (> 0 m)
    centre_distance: float = 0.25,
    # threads; 0: all cores; the result does not depend on it (0 to 1024)
    threads: int = 0,
    # hash of the scans in datum.json: XXH3-128, which xxhsum -H2 prints; SHA-256,
    # which of a large scan takes longer than all the rest; none
    checksum: Literal["xxh3", "sha256", "none"] = "xxh3",
    # the same as option checksum none
    no_checksum: bool = False,
    # shell height H for the code checks, as 8, 8m, 26.25ft, 315in; a number alone
    # is metres (> 0 and <= 100 m)
    height: float | str | None = None,
    # yield strength Y of the shell's steel [MPa] (> 50 and <= 2000 MPa)
    yield_mpa: float | None = None,
    # its elastic modulus E [MPa] (> 50000 and <= 500000 MPa)
    modulus_mpa: float | None = None,
    # open (floating) or fixed
    roof: Literal["open", "fixed"] | None = None,
    # ringwall or earth
    foundation: Literal["ringwall", "earth"] | None = None,
    # whose rules are judged by: of a new, rebuilt or in-service tank
    service: Literal["new", "rebuilt", "in-service"] = "in-service",
    # survey points for the classic out-of-plane rule; 0: every 20 ft, or the
    # stations typed in (>= 0)
    classic_points: int = 0,
    # file of limits to judge by, as option print_limits writes it
    limits: _Path | None = None,
    # TOML file with tank, product, site, client, company, logo, survey_date,
    # instrument, inspector, report_number, revision, notes
    about: _Path | None = None,
    # NAME=DEG,... places at the shell that readers know, by their azimuths
    mark: Sequence[str] = ...,
    # where north is, counter-clockwise from +x (-360 to 360 deg)
    north_deg: float | None = None,
    # points listed with their elevations, numbered clockwise from north (not given:
    # from +y); 0: none (0 or 4 to 360)
    survey_points: int = 0,
    # lengths in report and summary: mm and m, inches and feet, feet; files hold
    # metres
    display_units: Literal["mm", "in", "ft"] = "mm",
    # of the report
    language: Literal["en", "de", "es", "zh", "ru"] = "en",
    # end of options
) -> Datum: ...
