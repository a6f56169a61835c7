# SPDX-License-Identifier: Apache-2.0
"""Time that robots lose near other robots.

A robot that has a path could drive at cruise speed all the time. In each recorded second it loses the part by which its
displacement falls short of that. The loss counts as traffic if another robot is within the radio's range. A robot that
turns around at source or destination also loses time; this counts too if another robot is near."""

from dataclasses import dataclass

import numpy as np

from records import Run

CHUNK = 4_000_000  # number of distances computed at a time


@dataclass
class Losses:
    """One row for each robot with a path and recorded second."""

    places: np.ndarray  # (rows, 2)
    lost_s: np.ndarray
    beside: np.ndarray  # bool: another robot was within the radio's range


def cruise_mps(run: Run) -> float:
    return run.scenario.get("algorithm", {}).get("cruise_mps", 0.975)


def radio_range_m(run: Run) -> float:
    return run.scenario.get("radio", {}).get("range_m", 2.0)


def nearest_m(tracks: np.ndarray) -> np.ndarray:
    """(steps, robots): distance to the nearest other robot."""
    steps, robots, _ = tracks.shape
    nearest = np.full((steps, robots), np.inf)
    if robots < 2:
        return nearest
    at_once = max(1, CHUNK // (robots * robots))
    for begin in range(0, steps, at_once):
        part = tracks[begin:begin + at_once]
        apart = np.hypot(*np.moveaxis(part[:, :, None, :] - part[:, None, :, :], -1, 0))
        apart[:, np.arange(robots), np.arange(robots)] = np.inf
        nearest[begin:begin + at_once] = apart.min(axis=2)
    return nearest


def losses(run: Run) -> Losses:
    durations = np.diff(run.track_times)
    if len(durations) == 0:
        return Losses(np.empty((0, 2)), np.empty(0), np.empty(0, dtype=bool))
    moved = np.hypot(*np.moveaxis(np.diff(run.tracks, axis=0), -1, 0))
    lost = np.maximum(0.0, durations[:, None] - moved / cruise_mps(run))
    beside = nearest_m(run.tracks)[:-1] <= radio_range_m(run)
    got = np.array([np.inf if time is None else time for time in run.got_path_s()])
    with_path = run.track_times[:-1, None] >= got[None, :]
    return Losses(run.tracks[:-1][with_path], lost[with_path], beside[with_path])


def lost_to_traffic_map(runs: list[Run], edges_x: np.ndarray, edges_y: np.ndarray) -> np.ndarray:
    """(y, x): robot seconds lost near another robot in each cell, mean over the runs."""
    total = np.zeros((len(edges_y) - 1, len(edges_x) - 1))
    for run in runs:
        found = losses(run)
        places, lost = found.places[found.beside], found.lost_s[found.beside]
        total += np.histogram2d(places[:, 1], places[:, 0], bins=(edges_y, edges_x), weights=lost)[0]
    return total / len(runs)
