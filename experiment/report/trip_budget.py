# SPDX-License-Identifier: Apache-2.0
"""How the time of a round trip was spent."""

from dataclasses import dataclass

import numpy as np

from records import Run
from series import value_at
from traffic import cruise_mps

PARTS = ("at cruise speed", "slower than cruise", "avoiding", "exchanging")


@dataclass
class TripBudget:
    """Mean seconds of a round trip by PARTS; they add up to the mean round trip."""

    parts_s: np.ndarray
    trips: int


def time_in(run: Run, robot: int, activity: str, begin_s: float, end_s: float) -> float:
    """Seconds of [begin, end) in which the robot reported this activity."""
    changes, names = run.activities[robot - 1]
    borders = np.append(changes, max(end_s, changes[-1] if len(changes) else 0.0))
    chosen = np.array([name == activity for name in names], dtype=bool)
    lengths = np.clip(borders[1:], begin_s, end_s) - np.clip(borders[:-1], begin_s, end_s)
    return float(np.sum(lengths[chosen]))


def budget(runs: list[Run]) -> TripBudget | None:
    """Over all ended trips of the runs; None when no run recorded activities and path lengths, or no trip ended."""
    rows = []
    for run in runs:
        if not run.activities or not run.path_lengths:
            continue
        for trip in run.trips:
            if trip.next_pick_up_s is None:
                continue
            whole = trip.next_pick_up_s - trip.picked_up_s
            avoiding, exchanging = (time_in(run, trip.robot, name, trip.picked_up_s, trip.next_pick_up_s)
                                    for name in ("avoiding", "exchanging"))
            ends = np.array([trip.picked_up_s, trip.next_pick_up_s])
            length = float(np.nanmean(value_at(*run.path_lengths[trip.robot - 1], ends)))
            cruising = 2 * length / cruise_mps(run)
            rows.append((cruising, whole - cruising - avoiding - exchanging, avoiding, exchanging))
    return TripBudget(np.mean(rows, axis=0), len(rows)) if rows else None
