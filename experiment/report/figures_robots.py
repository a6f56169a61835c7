# SPDX-License-Identifier: Apache-2.0
"""Figures about the work of the robots and how they spent their time."""

import numpy as np
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

import style
from picture import ByMode, Picture
from quantities import round_trip_s, typical, unfinished_trips
from trip_budget import PARTS, budget

ACTIVITIES = ("driving", "avoiding", "exchanging", "stuck", "idle")
PART_COLOURS = {"at cruise speed": "#56b4e9", "slower than cruise": "#cc79a7", "avoiding": "#e69f00",
                "exchanging": "#009e73"}


def draw_items_per_robot(runs: ByMode) -> Figure:
    several = any(len(those) > 1 for those in runs.values())
    width = style.PAGE_IN if len(runs) > 1 else style.COLUMN_IN
    fig, all_axes = style.figure(width, 3.9 if several else 2.2, columns=len(runs), rows=2 if several else 1,
                                 sharey="row")
    for column, (mode, those) in enumerate(runs.items()):
        run = typical(those)
        items = [robot["items"] for robot in run.metrics["per_robot"]]
        axes = all_axes[column]
        robots = range(1, run.robots + 1)
        axes.bar(robots, items, width=0.8, color=[style.robot_colour(robot) for robot in robots])
        for robot, got in zip(robots, run.got_path_s()):
            if got is None:
                axes.annotate("no path", (robot, 0.15), rotation=90, ha="center", va="bottom", fontsize=6)
        axes.set_title(f"{style.MODE_NAMES[mode]}, seed {run.seed}")
        axes.set_xlabel("robot")
        axes.set_xticks(ticks(run.robots))
        axes.yaxis.set_major_locator(MaxNLocator(integer=True))
        axes.grid(axis="x", visible=False)
        if several:
            draw_ranks(all_axes[len(runs) + column], those, mode)
    all_axes[0].set_ylabel("items delivered")
    if several:
        all_axes[len(runs)].set_ylabel("items delivered")
    return fig


def draw_ranks(axes, runs, mode: str) -> None:
    """Robots sorted by their items in each run: median and quartiles of every rank."""
    count = min(run.robots for run in runs)
    table = np.array([sorted(robot["items"] for robot in run.metrics["per_robot"])[-count:] for run in runs])
    low, middle, high = np.percentile(table, (25, 50, 75), axis=0)
    ranks = np.arange(1, count + 1)
    axes.bar(ranks, middle, width=0.8, color=style.MODE_COLOURS[mode], alpha=0.75)
    axes.errorbar(ranks, middle, yerr=(middle - low, high - middle), fmt="none", ecolor=style.INK, elinewidth=0.8,
                  capsize=1.5)
    axes.set_title(f"all {len(runs)} runs")
    axes.set_xlabel("rank of the robot, fewest items first")
    axes.set_xticks(ticks(count))
    axes.grid(axis="x", visible=False)


def ticks(robots: int) -> np.ndarray:
    return np.arange(1, robots + 1, 1 if robots <= 8 else 2 if robots <= 20 else robots // 8)


def draw_round_trips(runs: ByMode) -> Figure:
    fig, (axes,) = style.figure(style.COLUMN_IN * 1.35, 2.7)
    for mode, those in runs.items():
        minutes = np.sort([time / 60 for run in those for time in round_trip_s(run)])
        if not len(minutes):
            continue
        axes.plot(np.append(minutes, minutes[-1]), 100 * np.arange(len(minutes) + 1) / len(minutes),
                  drawstyle="steps-pre", color=style.MODE_COLOURS[mode], linestyle=style.MODE_DASHES[mode],
                  label=f"{style.MODE_NAMES[mode]}, {len(minutes)} trips")
        axes.plot(np.mean(minutes), 100 * np.searchsorted(minutes, np.mean(minutes)) / len(minutes), "o",
                  color=style.MODE_COLOURS[mode], markersize=4.5, markeredgecolor="white", markeredgewidth=0.8)
    axes.set_xscale("log")
    low, high = axes.get_xlim()
    marks = [mark for mark in (0.25, 0.5, 1, 1.5, 2, 3, 4, 6, 8, 12, 20, 30, 60, 120) if low <= mark <= high]
    axes.set_xticks(marks, [f"{mark:g}" for mark in marks])
    axes.minorticks_off()
    axes.set_xlabel("round trip, from a pick-up to the next (min)")
    axes.set_ylabel("trips that took less (%)")
    axes.set_ylim(0, 101)
    axes.legend(loc="lower right")
    return fig


def draw_time_budget(runs: ByMode) -> Figure:
    with_trips = {mode: found for mode, those in runs.items() if (found := budget(those)) is not None}
    fig, all_axes = style.figure(style.PAGE_IN, 0.55 * len(runs) + 1.35, columns=2 if with_trips else 1)
    shares = {mode: [np.mean([[robot[f"{activity}_s"] / max(run.end_s, 1e-9) for activity in ACTIVITIES]
                              for robot in run.metrics["per_robot"]], axis=0) for run in those]
              for mode, those in runs.items()}
    stack(all_axes[0], {mode: 100 * np.mean(each, axis=0) for mode, each in shares.items()}, ACTIVITIES,
          style.ACTIVITY_COLOURS, least_label=4.0)
    all_axes[0].set_xlabel("share of all robots' time (%)")
    all_axes[0].set_xlim(0, 100)
    if with_trips:
        stack(all_axes[1], {mode: found.parts_s for mode, found in with_trips.items()}, PARTS, PART_COLOURS,
              least_label=8.0)
        all_axes[1].set_xlabel("mean round trip (s)")
    return fig


def stack(axes, rows: dict[str, np.ndarray], names, colours: dict[str, str], least_label: float) -> None:
    """One bar for each mode, its parts side by side; parts from `least_label` on are labelled with their value."""
    places = np.arange(len(rows))[::-1]
    begins = np.zeros(len(rows))
    for index, name in enumerate(names):
        lengths = np.maximum(0.0, [parts[index] for parts in rows.values()])
        axes.barh(places, lengths, left=begins, height=0.62, color=colours[name], label=name, edgecolor="white",
                  linewidth=0.4)
        for place, begin, length in zip(places, begins, lengths):
            if length >= least_label:
                axes.annotate(f"{length:.0f}", (begin + length / 2, place), ha="center", va="center", fontsize=6.5)
        begins += lengths
    axes.set_yticks(places, list(rows))
    axes.set_ylabel("mode")
    axes.grid(axis="y", visible=False)
    axes.legend(loc="lower left", bbox_to_anchor=(-0.03, 1.0), ncol=5, handlelength=0.9, columnspacing=0.8,
                handletextpad=0.4, borderpad=0.0)


def budget_caption(runs: ByMode) -> str:
    text = ("Left: what the robots did, from start to end, mean over runs and robots; time without "
            "progress for a minute counts as stuck, whatever the robot did.")
    if any(budget(those) for those in runs.values()):
        text += (" Right: how the time of a round trip was spent. At cruise speed: the time for its path without slowing "
                 "down. Slower than cruise: the rest of its driving, such as turning, keeping distance, detours.")
    return text


PICTURES = (
    Picture("items_per_robot", "Items of each robot",
            lambda runs: "Above: the run with the median time in each mode. Below: all runs, robots sorted by their items; "
            "bar: median, whisker: quartiles." if any(len(those) > 1 for those in runs.values())
            else "Items delivered by each robot.", draw_items_per_robot),
    Picture("round_trips", "Round-trip times",
            lambda runs: "Share of the round trips that took less than a time; dot: their mean. "
            + str(sum(len(unfinished_trips(run)) for those in runs.values() for run in those))
            + " trips were unfinished when their runs ended and are not included.", draw_round_trips,
            lambda runs: any(round_trip_s(run) for those in runs.values() for run in those)),
    Picture("time_budget", "How the robots spent their time", budget_caption, draw_time_budget),
)
