# SPDX-License-Identifier: Apache-2.0
"""The numbers of a run that are compared between modes, and with the paper."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from records import MODES, Run, Trip
from traffic import losses


@dataclass(frozen=True)
class Quantity:
    name: str
    of: Callable[[Run], float | None]  # None: this run has no such number
    decimals: int = 0


def by_mode(runs: list[Run]) -> dict[str, list[Run]]:
    """Modes without a run are left out; seeds ascend."""
    sorted_runs = sorted(runs, key=lambda run: (run.seed, str(run.folder)))
    chosen = {mode: [run for run in sorted_runs if run.mode == mode] for mode in MODES}
    return {mode: those for mode, those in chosen.items() if those}


def typical(runs: list[Run]) -> Run:
    """The run with the median time among those that delivered everything; among all runs if there are none."""
    done = [run for run in runs if run.metrics["completed"]] or runs
    return sorted(done, key=lambda run: (run.end_s, run.seed))[(len(done) - 1) // 2]


def round_trip_s(run: Run) -> list[float]:
    """Mean over the trips that a next pick-up has ended."""
    return [trip.next_pick_up_s - trip.picked_up_s for trip in run.trips if trip.next_pick_up_s is not None]


def unfinished_trips(run: Run) -> list[Trip]:
    return [trip for trip in run.trips if trip.next_pick_up_s is None]


def _robots(run: Run, key: str) -> int:
    return sum(robot[key] is not None for robot in run.metrics["per_robot"])


def robots_with_path_at(run: Run, time_s: float) -> int:
    return sum(got is not None and got <= time_s for got in run.got_path_s())


def nth_path_s(run: Run, nth: int) -> float | None:
    """Time at which that many robots had a path."""
    times = sorted(got for got in run.got_path_s() if got is not None)
    return times[nth - 1] if len(times) >= nth else None


def _minutes(time_s: float | None) -> float | None:
    return None if time_s is None else time_s / 60


def _path_lengths(run: Run) -> list[float]:
    return [robot["path_length_m"] for robot in run.metrics["per_robot"] if robot["path_length_m"] is not None]


def share_of_time(run: Run, activity: str) -> float:
    """Percentage of all robots' time; activity as in metrics.json without _s."""
    spent = sum(robot[f"{activity}_s"] for robot in run.metrics["per_robot"])
    return 100 * spent / max(run.robots * run.end_s, 1e-9)


def lost_to_traffic(run: Run) -> float | None:
    """Time lost to traffic (traffic.py) as a percentage of the time in which robots had a path."""
    with_path_s = sum(run.end_s - got for got in run.got_path_s() if got is not None)
    found = losses(run)
    return 100 * float(np.sum(found.lost_s[found.beside])) / with_path_s if with_path_s > 0 else None


def last_items_per_minute(run: Run, items: int) -> float | None:
    """Rate over the last deliveries; None unless there were twice as many, so that the start is excluded."""
    if len(run.deliveries) < 2 * items:
        return None
    times = np.sort(run.deliveries)
    return 60 * items / (times[-1] - times[-1 - items])


def exchanges_per_minute(run: Run) -> float | None:
    """Completed and failed exchanges, divided by the time in which they were allowed."""
    allowed_s = run.end_s - run.scenario.get("algorithm", {}).get("sharing_starts_s", 900.0)
    return 60 * len(run.exchanges) / allowed_s if run.mode != "none" and allowed_s > 0 else None


QUANTITIES = (
    Quantity("time to the last item, min", lambda run: run.end_s / 60 if run.metrics["completed"] else None, 1),
    Quantity("items delivered", lambda run: run.metrics["items_delivered"]),
    Quantity("robots that found a path themselves", lambda run: _robots(run, "found_s")),
    Quantity("robots that received their path", lambda run: _robots(run, "received_s")),
    Quantity("robots that never had a path",
             lambda run: run.robots - _robots(run, "found_s") - _robots(run, "received_s")),
    Quantity("robots with a path at 15 min", lambda run: robots_with_path_at(run, 900.0)),
    Quantity("robots with a path at 18 min", lambda run: robots_with_path_at(run, 1080.0)),
    Quantity("last but one robot got a path at, min", lambda run: _minutes(nth_path_s(run, run.robots - 1)), 1),
    Quantity("all robots had a path at, min", lambda run: _minutes(nth_path_s(run, run.robots)), 1),
    Quantity("mean round trip, s", lambda run: float(np.mean(round_trip_s(run))) if round_trip_s(run) else None, 0),
    Quantity("routes at the end", lambda run: run.metrics["routes"]),
    Quantity("shortest path at the end, m", lambda run: min(_path_lengths(run), default=None), 1),
    Quantity("longest path at the end, m", lambda run: max(_path_lengths(run), default=None), 1),
    Quantity("fewest items of a robot", lambda run: min(robot["items"] for robot in run.metrics["per_robot"])),
    Quantity("most items of a robot", lambda run: max(robot["items"] for robot in run.metrics["per_robot"])),
    Quantity("exchanges completed", lambda run: run.metrics["exchanges"]["completed"]),
    Quantity("exchanges failed", lambda run: run.metrics["exchanges"]["failed"]),
    Quantity("exchanges a minute once allowed", exchanges_per_minute, 1),
    Quantity("mean duration of an exchange, s",
             lambda run: run.metrics["exchanges"]["mean_duration_s"] if len(run.reports) else None, 2),
    Quantity("contacts of robots", lambda run: run.metrics["contacts"]["robot_robot"]),
    Quantity("contacts with something static", lambda run: run.metrics["contacts"]["robot_static"]),
    Quantity("time with a path lost near another robot, %", lost_to_traffic, 1),
    Quantity("time driving, %", lambda run: share_of_time(run, "driving"), 1),
    Quantity("time exchanging, %", lambda run: share_of_time(run, "exchanging"), 2),
    Quantity("time avoiding, %", lambda run: share_of_time(run, "avoiding"), 1),
    Quantity("time stuck, %", lambda run: share_of_time(run, "stuck"), 2),
    Quantity("time idle, %", lambda run: share_of_time(run, "idle"), 2),
)


def values(quantity: Quantity, runs: list[Run]) -> list[float]:
    return [float(value) for run in runs if (value := quantity.of(run)) is not None]


def summary(quantity: Quantity, runs: list[Run]) -> str:
    """Median (minimum to maximum) of the runs that have the number, and how many do not."""
    known = values(quantity, runs)
    if not known:
        return f"-; {len(runs)} of {len(runs)} without"
    least, most = (f"{value:.{quantity.decimals}f}" for value in (min(known), max(known)))
    counts = all(value.is_integer() for value in known)
    half = 1 if counts and not float(np.median(known)).is_integer() else quantity.decimals
    middle = f"{np.median(known):.{half}f}"
    text = middle if len(known) == 1 else f"{middle} ({least} to {most})"
    return text if len(known) == len(runs) else f"{text}; {len(runs) - len(known)} of {len(runs)} without"
