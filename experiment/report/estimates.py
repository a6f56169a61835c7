# SPDX-License-Identifier: Apache-2.0
"""Medians and proportions with 95 % intervals. Censored numbers are kept: their true number is larger. docs/statistics.md
gives the reasons and the sources."""

import math
import warnings
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from scipy import stats

from sweep_runs import Value

CONFIDENCE = 0.95
RESAMPLES = 9999
SEED = 1  # of every bootstrap: the same numbers give the same interval
FEWEST = 6  # the range of five numbers covers their median with 94 % only (1 - 2 / 2^5)
CLOSE = 1e-9  # rounding of a product of fractions


@dataclass(frozen=True)
class Estimate:
    statistic: str  # "median", "median (Kaplan-Meier)", "proportion"; empty: there is no number
    number: float | None
    relation: str = "="  # ">" or "<": `number` is only a bound
    low: float | None = None  # 95 % interval; None: too few numbers; infinite: no bound on this side
    high: float | None = None


NOTHING = Estimate("", None, "")


def kaplan_meier_half(times: np.ndarray, known: np.ndarray, beyond: float) -> tuple[np.ndarray, np.ndarray]:
    """The times, along the last axis, at which the Kaplan-Meier curve reaches one half and falls below it; `beyond` where it never
    does. Their mean is the median: without censored times, the ordinary one. Of equal times, the known ones come first."""
    order = np.lexsort((~known, times), axis=-1)
    times = np.take_along_axis(times, order, axis=-1)
    known = np.take_along_axis(known, order, axis=-1)
    at_risk = times.shape[-1] - np.arange(times.shape[-1])
    running = np.cumprod(1 - known / at_risk, axis=-1)

    def first(there: np.ndarray) -> np.ndarray:
        place = np.argmax(there, axis=-1)[..., None]
        return np.where(np.any(there, axis=-1), np.take_along_axis(times, place, axis=-1)[..., 0], beyond)

    return first(running <= 0.5 + CLOSE), first(running < 0.5 - CLOSE)


def bootstrap_interval(data: tuple[np.ndarray, ...], statistic: Callable[..., np.ndarray], censored: bool) -> tuple[float, float]:
    """Bias-corrected and accelerated; the percentile interval of the same resamples where the corrections are not defined: with
    censored numbers, whose rank is known but not their place, and where leaving out any one number changes nothing.

    @param data  equally long; element i of all of them is one observation"""
    if all(np.all(each == each[0]) for each in data):
        only = float(statistic(*data))
        return only, only
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # the case that is treated below
        result = stats.bootstrap(data, statistic, paired=True, vectorized=True, n_resamples=RESAMPLES, confidence_level=CONFIDENCE,
                                 method="percentile" if censored else "BCa", random_state=np.random.default_rng(SEED))
    low, high = (float(end) for end in result.confidence_interval)
    if math.isnan(low) or math.isnan(high):
        tail = (1 - CONFIDENCE) / 2
        low, high = (float(end) for end in np.quantile(result.bootstrap_distribution, (tail, 1 - tail)))
    return low, high


def plain_median(numbers: np.ndarray, axis: int = -1) -> np.ndarray:
    return np.median(numbers, axis=axis)


def median(values: Sequence[Value]) -> Estimate:
    """Censored numbers count as larger than every known one. If there is a known one above a censored one, the median is that of the
    Kaplan-Meier curve."""
    if not values:
        return NOTHING
    numbers = np.array([value.number for value in values])
    known = np.array([value.known for value in values])
    largest = float(np.max(numbers))
    highest_known = float(np.max(numbers[known])) if np.any(known) else -math.inf
    beyond = largest + 1000 * (1 + float(np.ptp(numbers)))  # stands for "larger than every known number"
    if np.all(numbers[~known] >= highest_known):
        name, data, of = "median", (np.where(known, numbers, beyond),), plain_median
        reached = float(np.sort(data[0])[(len(values) - 1) // 2])
    else:
        name, data = "median (Kaplan-Meier)", (numbers, known)
        reached = float(kaplan_meier_half(numbers, known, beyond)[0])

        def of(numbers: np.ndarray, known: np.ndarray, axis: int = -1) -> np.ndarray:
            return np.mean(kaplan_meier_half(numbers, known, beyond), axis=0)

    number, relation = float(of(*data)), "="
    if number > highest_known:
        number, relation = min(largest, reached), ">"
    if len(values) < FEWEST:
        return Estimate(name, number, relation)
    low, high = bootstrap_interval(data, of, censored=not np.all(known))
    return Estimate(name, number, relation, min(low, largest), math.inf if high > highest_known else high)


def proportion(values: Sequence[Value]) -> Estimate:
    """Of the ones among zeros and ones, with Wilson's interval."""
    if not values:
        return NOTHING
    ones = sum(value.number == 1 for value in values)
    interval = stats.binomtest(ones, len(values)).proportion_ci(CONFIDENCE, method="wilson")
    return Estimate("proportion", ones / len(values), "=", float(interval.low), float(interval.high))
