# SPDX-License-Identifier: Apache-2.0
"""Quantities over time: step functions of single runs, and their combination over several runs."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from records import Run

GRID_S = 5.0


@dataclass
class Band:
    """Median and quartiles over runs at the times of a grid; NaN where no run has a value."""

    times_s: np.ndarray
    low: np.ndarray
    median: np.ndarray
    high: np.ndarray


def grid(runs: list[Run]) -> np.ndarray:
    return np.arange(0.0, max(run.end_s for run in runs) + GRID_S, GRID_S)


def count_until(event_times: np.ndarray, times: np.ndarray) -> np.ndarray:
    """The number of events up to each time."""
    return np.searchsorted(np.sort(event_times), times, side="right").astype(float)


def value_at(changes: np.ndarray, values: np.ndarray, times: np.ndarray) -> np.ndarray:
    """A step function that has `values` from `changes` on, NaN before the first."""
    if len(changes) == 0:
        return np.full(len(times), np.nan)
    index = np.searchsorted(changes, times, side="right") - 1
    return np.where(index >= 0, values[np.maximum(index, 0)], np.nan)


def band(runs: list[Run], series: Callable[[Run, np.ndarray], np.ndarray], times: np.ndarray) -> Band:
    """A run that has ended keeps its last value."""
    table = np.array([series(run, np.minimum(times, run.end_s)) for run in runs])
    empty = np.all(np.isnan(table), axis=0)
    filled = np.where(empty, 0.0, table)
    low, median, high = np.nanpercentile(filled, (25, 50, 75), axis=0)
    for line in (low, median, high):
        line[empty] = np.nan
    return Band(times, low, median, high)


def items(run: Run, times: np.ndarray) -> np.ndarray:
    return count_until(run.deliveries, times)


def robots_with_path(run: Run, times: np.ndarray) -> np.ndarray:
    return count_until(np.array([time for time in run.got_path_s() if time is not None]), times)


def exchanges(run: Run, times: np.ndarray, completed: bool) -> np.ndarray:
    chosen = run.exchanges[:, 1] == float(completed)
    return count_until(run.exchanges[chosen, 0], times)


def mean_path_length(run: Run, times: np.ndarray) -> np.ndarray:
    """Mean over the robots that have a path."""
    lengths = np.array([value_at(changes, values, times) for changes, values in run.path_lengths])
    if len(lengths) == 0:
        return np.full(len(times), np.nan)
    with_path = np.sum(~np.isnan(lengths), axis=0)
    return np.where(with_path > 0, np.nansum(lengths, axis=0) / np.maximum(with_path, 1), np.nan)
