"""The paper's figures 5 to 8 of any result: cloud, points, residuals, elevation; 170 mm wide."""

from __future__ import annotations

import matplotlib as mpl
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from plot_result import Array, Result

MM = 1e3
SIZE = (6.7, 3.6)  # inch
BLUE, RED, GREEN, GREY = "#2b5fb3", "#c0392b", "#1e8449", "#7f8c8d"
FOOT_REACH = 0.3
"""of the section about the datum [m]"""

mpl.rcParams.update(
    {
        "font.size": 8,
        "axes.titlesize": 9,
        "axes.spines.top": False,
        "axes.spines.right": False,
        "axes.grid": True,
        "grid.linewidth": 0.3,
        "legend.frameon": False,
        "legend.fontsize": 7,
        "pdf.fonttype": 42,
        "svg.hashsalt": "tank_datum",
        "savefig.dpi": 300,
    }
)


def panels(rows: int, columns: int, **options: object) -> tuple[Figure, list[Axes]]:
    figure = Figure(figsize=SIZE, layout="constrained")
    axes = figure.subplots(rows, columns, squeeze=False, **options)
    return figure, list(axes.ravel())


def plan(axes: Axes, title: str) -> None:
    axes.set(aspect="equal", xlabel="x from the centre [m]", ylabel="y from the centre [m]")
    axes.set_title(title)


def round_the_tank(axes: Axes, ylabel: str) -> None:
    axes.set(xlim=(0, 360), xlabel="azimuth [deg]", ylabel=ylabel)
    axes.set_xticks(range(0, 361, 60))


def shade_gaps(axes: Axes, result: Result) -> None:
    """Grey where stations are missing."""
    half, first = 180.0 / len(result.flags), True
    for azimuth, flag in zip(result.columns["azimuth_deg"], result.flags, strict=True):
        if flag == "missing":
            label = "not seen" if first else None
            first = False
            axes.axvspan(azimuth - half, azimuth + half, color="0.88", lw=0, zorder=0, label=label)


def cloud(result: Result, points: Array) -> Figure:
    """Figure 5: the scan from above, and its section at the foot stacked over all azimuths."""
    if not result.usable:
        figure, [above] = panels(1, 1)
        middle = np.median(points, axis=0) if len(points) else np.zeros(3)
        local = points - middle
        dots = above.scatter(local[:, 0], local[:, 1], 0.3, local[:, 2], lw=0, rasterized=True)
        above.set(aspect="equal", xlabel="x from the median [m]", ylabel="y from the median [m]")
        above.set_title("Scan from above")
        figure.colorbar(dots, ax=above, label="height from the median [m]", shrink=0.8)
        return figure
    figure, [above, section] = panels(1, 2)
    mean, tank = result.datum["datum"]["mean"], result.datum["tank"]
    height = points[:, 2] - mean
    local = points[:, :2] - tank["center"]
    wide = np.hypot(*local.T) < 1.5 * tank["radius"]
    low, high = np.percentile(height[wide], [1, 99]) if wide.any() else (0.0, 1.0)
    dots = above.scatter(
        *local[wide].T,
        0.3,
        height[wide],
        lw=0,
        cmap="viridis",
        vmin=low,
        vmax=high,
        rasterized=True,
    )
    figure.colorbar(dots, ax=above, label="height above the datum's mean [m]", shrink=0.7)
    plan(above, "Scan from above")
    radial, rise = result.radial(points), points[:, 2] - result.at("z", result.azimuth(points))
    near = (np.abs(radial) < FOOT_REACH) & (np.abs(rise) < FOOT_REACH)
    section.scatter(radial[near], rise[near], 0.3, GREY, lw=0, rasterized=True)
    section.plot(0, 0, "+", color=RED, ms=10, label="datum")
    section.set(xlabel="distance from the shell's circle [m]", ylabel="height above the datum [m]")
    section.set_title("Section of the foot, all azimuths")
    section.legend(loc="upper right")
    return figure


def datum_points(result: Result) -> Figure:
    """Figure 6: the edge points from above, and their heights beside the two curves."""
    figure, [above, side] = panels(1, 2)
    edge, mean = result.edge_points, result.datum["datum"]["mean"]
    local = edge[:, :2] - result.datum["tank"]["center"]
    height = MM * (edge[:, 2] - mean)
    dots = above.scatter(*local.T, 1, height, lw=0, cmap="viridis", rasterized=True)
    figure.colorbar(dots, ax=above, label="height above the datum's mean [mm]", shrink=0.7)
    plan(above, f"{len(edge)} edge points")
    side.scatter(result.azimuth(edge), height, 1, GREY, lw=0, label="edge points", rasterized=True)
    for name, colour, label in (("z_paper", RED, "paper's curve"), ("z", BLUE, "datum")):
        heights = MM * (result.columns[name] - mean)
        side.plot(result.columns["azimuth_deg"], heights, color=colour, lw=1, label=label)
    shade_gaps(side, result)
    round_the_tank(side, "height above the datum's mean [mm]")
    side.set_title("Heights")
    side.legend(loc="upper right")
    return figure


def curve_residuals(result: Result) -> Array:
    """Heights of the edge points above the paper's curve; NaN in gaps [m]."""
    edge = result.edge_points
    return edge[:, 2] - result.at("z_paper", result.azimuth(edge))


def residuals(result: Result) -> Figure:
    """Figure 7: heights of the edge points about the paper's curve."""
    figure, [along, histogram] = panels(1, 2, width_ratios=[2.4, 1], sharey=True)
    heights = MM * curve_residuals(result)
    along.scatter(result.azimuth(result.edge_points), heights, 1.5, BLUE, lw=0, rasterized=True)
    along.axhline(0, color="black", lw=0.6)
    shade_gaps(along, result)
    round_the_tank(along, "height above the paper's curve [mm]")
    known = heights[np.isfinite(heights)]
    histogram.hist(known, 40, orientation="horizontal", color=BLUE)
    histogram.set(xlabel="edge points")
    curve = result.datum["datum"]["curve"]
    if curve["rms"] is not None:
        rms, most = MM * curve["rms"], MM * curve["max_residual"]
        along.set_title(
            f"{curve['check_points']} check points in space: RMS {rms:.1f} mm, worst {most:.1f} mm"
        )
    return figure


def elevation(result: Result) -> Figure:
    """Figure 8: the datum's elevation with its tilt, and what remains without the tilt."""
    figure, [above, below] = panels(2, 1, sharex=True)
    c, mean = result.columns, result.datum["datum"]["mean"]
    azimuth, z = c["azimuth_deg"], MM * (c["z"] - mean)
    sigma = MM * c["sigma_z"]
    above.fill_between(azimuth, z - 2 * sigma, z + 2 * sigma, color=BLUE, alpha=0.3, lw=0)
    above.plot(azimuth, z, color=BLUE, lw=1, label="datum, band of 2 sigma")
    above.plot(azimuth, MM * (c["z_tilt"] - mean), color=RED, lw=0.8, ls="--", label="tilt plane")
    between = np.array([flag == "interpolated" for flag in result.flags])
    if between.any():
        above.plot(azimuth[between], z[between], "o", mfc="white", mec=BLUE, ms=3, label="bridged")
    above.set_title(f"Elevation about the mean of {mean:.4f} m")
    below.plot(azimuth, MM * c["u"], color=GREEN, lw=1)
    below.axhline(0, color="black", lw=0.6)
    for axes, label in ((above, "elevation [mm]"), (below, "out of plane [mm]")):
        shade_gaps(axes, result)
        round_the_tank(axes, label)
    above.set_xlabel("")
    above.legend(loc="best", ncols=2)
    return figure
