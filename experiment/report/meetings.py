# SPDX-License-Identifier: Apache-2.0
"""How often searching robots meet robots that know a way, in the first minutes in which exchanges are allowed."""

from dataclasses import dataclass

import numpy as np

from records import Run
from traffic import radio_range_m

AFTER_S = (60.0, 360.0)  # the time span, counted from the start of exchanges
CELL_M = 2.0


@dataclass
class Meetings:
    """Numbers of several runs together."""

    floor_m2: list[float]  # by run: cells in which a robot with a path was
    searching_min: float  # sum over robots without a path
    meetings: int  # how often one of these came into radio range of a robot with a path
    got_path: int


def span_s(run: Run) -> tuple[float, float]:
    begins = run.scenario.get("algorithm", {}).get("sharing_starts_s", 900.0)
    return begins + AFTER_S[0], begins + AFTER_S[1]


def floor_with_path_m2(places: np.ndarray) -> float:
    return len(np.unique(np.floor(places / CELL_M), axis=0)) * CELL_M**2


def meetings(runs: list[Run]) -> Meetings:
    total = Meetings([], 0.0, 0, 0)
    for run in runs:
        begin, end = span_s(run)
        chosen = (run.track_times >= begin) & (run.track_times < end)
        times, tracks = run.track_times[chosen], run.tracks[chosen]
        got = np.array([np.inf if time is None else time for time in run.got_path_s()])
        knows = times[:, None] >= got[None, :]
        total.floor_m2.append(floor_with_path_m2(tracks[knows]))
        total.searching_min += np.count_nonzero(~knows) * _step_s(times) / 60
        total.got_path += np.count_nonzero((got >= begin) & (got < end))
        near = np.zeros_like(knows)
        for robot in range(run.robots):
            apart = np.hypot(*np.moveaxis(tracks - tracks[:, robot:robot + 1], -1, 0))
            near[:, robot] = ~knows[:, robot] & np.any(knows & (apart <= radio_range_m(run)), axis=1)
        total.meetings += np.count_nonzero(near[1:] & ~near[:-1])
    return total


def _step_s(times: np.ndarray) -> float:
    return float(np.median(np.diff(times))) if len(times) > 1 else 0.0
