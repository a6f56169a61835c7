# SPDX-License-Identifier: Apache-2.0
"""Figures over simulated time: median and quartile band of the runs of each mode, one line for a single run."""

from collections.abc import Callable

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

import series
import style
from figures_map import robot_legend
from picture import ByMode, Picture
from quantities import typical
from records import Run

Series = Callable[[Run, np.ndarray], np.ndarray]


def last_end_s(runs: ByMode) -> float:
    return max(run.end_s for those in runs.values() for run in those)


def draw_band(axes: Axes, runs: ByMode, quantity: Series, steps: bool, **options) -> None:
    times = series.grid([run for those in runs.values() for run in those])
    for mode, those in runs.items():
        band = series.band(those, quantity, times)
        step = {"drawstyle": "steps-post"} if steps else {}
        looks = {"color": style.MODE_COLOURS[mode], "linestyle": style.MODE_DASHES[mode],
                 "label": style.MODE_NAMES[mode], **step, **options}
        axes.plot(times / 60, band.median, **looks)
        if len(those) > 1:
            axes.fill_between(times / 60, band.low, band.high, step="post" if steps else None, linewidth=0,
                              color=style.MODE_COLOURS[mode], alpha=0.22)


def mark_ends(axes: Axes, runs: ByMode) -> None:
    """A tick at the upper edge for the end of every run: filled if it delivered everything."""
    for row, (mode, those) in enumerate(runs.items()):
        for run in those:
            done = run.metrics["completed"]
            axes.plot(run.end_s / 60, 1.03 + 0.035 * row, "|" if done else "x", color=style.MODE_COLOURS[mode],
                      markersize=4, transform=axes.get_xaxis_transform(), clip_on=False)


def draw_items(runs: ByMode) -> Figure:
    fig, (axes,) = style.figure(style.COLUMN_IN * 1.35, 2.9)
    draw_band(axes, runs, series.items, steps=True)
    mark_ends(axes, runs)
    style.minutes_axis(axes, last_end_s(runs))
    axes.set_ylabel("items delivered")
    axes.set_ylim(bottom=0)
    axes.legend(loc="lower right")
    return fig


def draw_robots_with_path(runs: ByMode) -> Figure:
    fig, (axes,) = style.figure(style.COLUMN_IN * 1.35, 2.7)
    draw_band(axes, runs, series.robots_with_path, steps=True)
    everybody = max(run.robots for those in runs.values() for run in those)
    begins = {run.scenario.get("algorithm", {}).get("sharing_starts_s", 900.0)
              for mode, those in runs.items() if mode != "none" for run in those}
    if len(begins) == 1 and (begin := begins.pop() / 60) * 60 < last_end_s(runs):
        axes.axvline(begin, color="#777777", linewidth=0.8, linestyle=(0, (2, 2)))
        axes.annotate("exchanges\nbegin", (begin, 0.03 * everybody), xytext=(3, 0), textcoords="offset points",
                      fontsize=6.5, color="#555555")
    style.minutes_axis(axes, last_end_s(runs))
    axes.set_ylabel("robots with a path")
    axes.set_ylim(0, everybody * 1.04)
    axes.legend(loc="lower right")
    return fig


def draw_exchanges(runs: ByMode) -> Figure:
    fig, all_axes = style.figure(style.PAGE_IN, 2.5, columns=2)
    draw_band(all_axes[0], runs, lambda run, times: series.exchanges(run, times, completed=True), steps=True)
    draw_band(all_axes[1], runs, lambda run, times: series.exchanges(run, times, completed=False), steps=True)
    for axes, what in zip(all_axes, ("completed", "failed")):
        style.minutes_axis(axes, last_end_s(runs))
        axes.set_ylabel(f"exchanges {what}")
        axes.set_ylim(0, max(1.0, axes.get_ylim()[1]))
        axes.yaxis.set_major_locator(MaxNLocator(integer=True))
    all_axes[0].legend(loc="upper left")
    return fig


def draw_path_lengths(runs: ByMode) -> Figure:
    width = style.PAGE_IN if len(runs) > 1 else style.COLUMN_IN * 1.35
    fig, by_name = style.mosaic(width, 4.8, [list(runs), ["all"] * len(runs)])
    robots = 0
    for mode, those in runs.items():
        axes = by_name[mode]
        run = typical(those)
        robots = max(robots, run.robots)
        for robot, (changes, lengths) in enumerate(run.path_lengths, start=1):
            if len(changes):
                axes.plot(np.append(changes, run.end_s) / 60, np.append(lengths, lengths[-1]), linewidth=0.9,
                          color=style.robot_colour(robot), linestyle=style.robot_dash(robot), drawstyle="steps-post")
        axes.set_title(f"{style.MODE_NAMES[mode]}, seed {run.seed}")
        style.minutes_axis(axes, last_end_s(runs))
    share_y([by_name[mode] for mode in runs])
    by_name[next(iter(runs))].set_ylabel("path of each robot (m)")
    below = by_name["all"]
    draw_band(below, runs, series.mean_path_length, steps=False)
    style.minutes_axis(below, last_end_s(runs))
    below.set_ylabel("mean path of the robots\nthat have one (m)")
    below.legend(loc="upper right")
    robot_legend(fig, robots)
    return fig


def share_y(all_axes: list[Axes]) -> None:
    """A logarithmic scale, for lengths that differ tenfold."""
    for axes in all_axes:
        axes.set_yscale("log")
    low = min(axes.get_ylim()[0] for axes in all_axes)
    high = max(axes.get_ylim()[1] for axes in all_axes)
    marks = [mark for mark in (5, 10, 15, 20, 30, 40, 60, 80, 100, 150, 200, 300, 500, 1000) if low <= mark <= high]
    for number, axes in enumerate(all_axes):
        axes.set_ylim(low, high)
        axes.set_yticks(marks, [str(mark) if number == 0 else "" for mark in marks])
        axes.minorticks_off()


def spread(runs: ByMode) -> str:
    if all(len(those) == 1 for those in runs.values()):
        return ""
    return " Line: median of the runs; band: their quartiles. A run that has ended keeps its last value."


PICTURES = (
    Picture("robots_with_path", "Robots with a path over time",
            lambda runs: "Number of robots that knew a way, found or received." + spread(runs), draw_robots_with_path),
    Picture("items_over_time", "Items over time",
            lambda runs: "Total items delivered." + spread(runs) + " The marks above the frame are the ends of the "
            "single runs; a cross is a run that did not deliver everything.", draw_items),
    Picture("exchanges_over_time", "Exchanges over time",
            lambda runs: "Left: completed, right: failed; a session of a pair counts once." + spread(runs),
            draw_exchanges),
    Picture("path_length_over_time", "Path length over time",
            lambda runs: "Above: the path that each robot used, for the run with the median time. Below: mean over the "
            "robots that have a path." + spread(runs), draw_path_lengths,
            lambda runs: any(run.path_lengths for those in runs.values() for run in those)),
)
