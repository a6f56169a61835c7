# SPDX-License-Identifier: Apache-2.0
"""Tables in Markdown: our numbers compared with the paper's, and the tests of its central claim."""

from collections.abc import Callable

import numpy as np

from meetings import meetings
from paper import ITEMS, PAPER, ROUND_TRIP_S, TIME_MIN
from picture import ByMode
from quantities import QUANTITIES, Quantity, last_items_per_minute, round_trip_s, summary
from records import MODES, Run
from trip_budget import PARTS, budget

STEADY_ITEMS = 200  # this many deliveries at the end of a long run are its steady state


def markdown(rows: list[list[str]]) -> str:
    """The first row is the heading."""
    lines = ["| " + " | ".join(row) + " |" for row in rows]
    return "\n".join([lines[0], "|" + "---|" * len(rows[0]), *lines[1:]]) + "\n"


def comparison(runs: ByMode) -> str:
    """Every quantity: the paper's one run and the median (minimum to maximum) of ours, mode by mode."""
    heading = ["quantity"]
    for mode, those in runs.items():
        heading += [f"{mode}: paper", f"{mode}: {len(those)} runs"]
    rows = [heading]
    for quantity in QUANTITIES:
        row = [quantity.name]
        for mode, those in runs.items():
            row += [PAPER.get(quantity.name, {}).get(mode, "-"), summary(quantity, those)]
        rows.append(row)
    return markdown(rows)


def trip_budgets(runs: ByMode) -> str:
    """Mean duration of a round trip, in seconds, by activity."""
    rows = [["mode", "round trips", *(f"{part}, s" for part in PARTS), "in all, s"]]
    for mode, those in runs.items():
        if (found := budget(those)) is not None:
            parts = [f"{part:.1f}" for part in (*found.parts_s, np.sum(found.parts_s))]
            rows.append([mode, str(found.trips), *parts])
    return markdown(rows)


def searching(runs: ByMode) -> str:
    """How often robots without a path meet those with one, once exchanges are allowed."""
    rows = [["mode", "floor on which robots with a path drive, m2", "robot minutes of search",
             "meetings with one that has a path, a minute", "paths got, an hour of search"]]
    for mode, those in runs.items():
        found = meetings(those)
        if found.searching_min > 0:
            rows.append([mode, f"{np.median(found.floor_m2):.0f}", f"{found.searching_min:.0f}",
                         f"{found.meetings / found.searching_min:.2f}",
                         f"{60 * found.got_path / found.searching_min:.0f}"])
    return markdown(rows)


def pairs(runs: ByMode) -> str:
    """Runs of the same seed, equal until exchanges begin, in two modes: which took longer."""
    rows = [["time to the last item", "seeds", "later in", "difference, min: median (least to most)"]]
    times = {mode: {run.seed: run.end_s / 60 for run in those if run.metrics["completed"]}
             for mode, those in runs.items()}
    for later, earlier in (("full", "none"), ("full", "partial"), ("none", "partial")):
        if later not in times or earlier not in times:
            continue
        both = sorted(times[later].keys() & times[earlier].keys())
        if not both:
            continue
        more = np.array([times[later][seed] - times[earlier][seed] for seed in both])
        rows.append([f"{later} against {earlier}", str(len(both)), f"{np.count_nonzero(more > 0)} of {len(both)}",
                     f"{np.median(more):+.1f} ({np.min(more):+.1f} to {np.max(more):+.1f})"])
    return markdown(rows)


def needed_min(got_path_s: list[float], trip_s: float, items: int) -> float:
    """Time to carry `items` items if every robot carried one per `trip_s` once it had its path."""
    started = np.sort(got_path_s)
    for count in range(1, len(started) + 1):
        end = (items * trip_s + np.sum(started[:count])) / count  # with the first `count` robots working
        if count == len(started) or end <= started[count]:
            return float(end / 60)
    return float("inf")


def with_papers_trips(runs: ByMode) -> str:
    """The time to the last item if robots got their paths when ours did and carried at the paper's rate."""
    rows = [["mode", "the paper, min", "ours, min", "ours with our mean round trip, min", "ours with the paper's, min"]]
    for mode, those in runs.items():
        known = [run for run in those if round_trip_s(run)]
        got = [[time for time in run.got_path_s() if time is not None] for run in known]
        own = [needed_min(times, float(np.mean(round_trip_s(run))), ITEMS) for run, times in zip(known, got)]
        papers = [needed_min(times, ROUND_TRIP_S[mode], ITEMS) for times in got]
        rows.append([mode, f"{TIME_MIN[mode]:.0f}", f"{np.median([run.end_s / 60 for run in known]):.1f}",
                     *(f"{np.median(each):.1f} ({min(each):.1f} to {max(each):.1f})" for each in (own, papers))])
    return markdown(rows)


def variants(runs: dict[str, ByMode], chosen: list[Quantity]) -> str:
    """The same quantities for several variants of a scenario, over the seeds that they all have."""
    seeds = {mode: set.intersection(*({run.seed for run in one[mode]} for one in runs.values() if mode in one))
             for mode in MODES if any(mode in one for one in runs.values())}
    rows = [["variant", "quantity", *(f"{mode}: {len(known)} seeds" for mode, known in seeds.items())]]
    for name, of_variant in runs.items():
        same = {mode: [run for run in of_variant.get(mode, []) if run.seed in known] for mode, known in seeds.items()}
        for quantity in chosen:
            rows.append([name, quantity.name, *(summary(quantity, those) if those else "-" for those in same.values())])
    return markdown(rows)


def steady(run_of: Callable[[Run], float | None] = lambda run: last_items_per_minute(run, STEADY_ITEMS)) -> Quantity:
    return Quantity(f"items a minute over the last {STEADY_ITEMS}", run_of, 2)


ABLATED = tuple(quantity for quantity in QUANTITIES
                if quantity.name in ("time to the last item, min", "mean round trip, s", "exchanges completed",
                                     "time exchanging, %", "time with a path lost near another robot, %",
                                     "contacts of robots"))
