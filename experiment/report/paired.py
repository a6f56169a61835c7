# SPDX-License-Identifier: Apache-2.0
"""Comparison of runs with the same seeds: paired differences, Wilcoxon's signed-rank test, effect size, Holm's correction.
docs/statistics.md gives the reasons and the sources."""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy import stats

from estimates import FEWEST, NOTHING, Estimate, bootstrap_interval, plain_median
from sweep_runs import Value

DECIMALS = 9  # differences are rounded, so that equal ones are equal
EXACT_UP_TO = 50  # pairs; above, the normal approximation


@dataclass(frozen=True)
class Difference:
    """Of one seed: the level's number minus the reference's. Infinite: only one of the two is censored, and it is larger, whatever it is. 0
    with bounds: nothing says which one is larger."""

    score: float
    least: float  # what the true difference is at least, and at most
    most: float


@dataclass(frozen=True)
class PairedTest:
    test: str  # "wilcoxon exact", "wilcoxon normal", "mcnemar"; empty: no pair
    p_value: float | None
    rank_biserial: float | None  # from -1, the level is always smaller, to 1; 0 when all differences are 0


def difference(level: Value, reference: Value) -> Difference:
    gap = round(level.number - reference.number, DECIMALS)
    if level.known and reference.known:
        return Difference(gap, gap, gap)
    if reference.known:
        return Difference(math.inf if gap >= 0 else 0.0, gap, math.inf)
    if level.known:
        return Difference(-math.inf if gap <= 0 else 0.0, -math.inf, gap)
    return Difference(0.0, -math.inf, math.inf)


def signed_ranks(scores: Sequence[float]) -> np.ndarray:
    """Without zeros; all infinite ones share the highest ranks."""
    numbers = np.array([score for score in scores if score != 0])
    return np.sign(numbers) * stats.rankdata(np.abs(numbers))


def rank_biserial(scores: Sequence[float]) -> float | None:
    """Matched-pairs rank-biserial correlation: the part of the rank sum that is positive, less the part that is negative."""
    if len(scores) == 0:
        return None
    ranks = signed_ranks(scores)
    return float(np.sum(ranks) / np.sum(np.abs(ranks))) if len(ranks) > 0 else 0.0


def wilcoxon(scores: Sequence[float]) -> PairedTest:
    """Two-sided; zeros are left out, as Wilcoxon did."""
    effect = rank_biserial(scores)
    if effect is None:
        return PairedTest("", None, None)
    ranks = signed_ranks(scores)
    if len(ranks) == 0:
        return PairedTest("wilcoxon exact", 1.0, effect)
    if len(ranks) > EXACT_UP_TO:
        # Without a method, because SciPy has renamed this one; every version chooses it above this number.
        return PairedTest("wilcoxon normal", float(stats.wilcoxon(ranks).pvalue), effect)
    if len(np.unique(np.abs(ranks))) == len(ranks):
        return PairedTest("wilcoxon exact", float(stats.wilcoxon(ranks, method="exact").pvalue), effect)
    return PairedTest("wilcoxon exact", exact_p_value(ranks), effect)


def exact_p_value(ranks: np.ndarray) -> float:
    """Over all signs of these ranks, which may have ties: SciPy's exact distribution supposes that there are none."""
    doubled = np.rint(2 * np.abs(ranks)).astype(int)  # ties have half ranks
    chance = np.ones(1)  # of each sum of the positive ones
    for rank in doubled:
        longer = np.zeros(len(chance) + rank)
        longer[:len(chance)] += chance / 2
        longer[rank:] += chance / 2
        chance = longer
    positive = int(np.sum(doubled[ranks > 0]))
    tail = min(np.sum(chance[:positive + 1]), np.sum(chance[positive:]))
    return float(min(1.0, 2 * tail))


def mcnemar(scores: Sequence[float]) -> PairedTest:
    """Exact, for yes or no: of the pairs that differ, how many differ in each direction."""
    effect = rank_biserial(scores)
    if effect is None:
        return PairedTest("", None, None)
    more, fewer = sum(score > 0 for score in scores), sum(score < 0 for score in scores)
    p_value = float(stats.binomtest(more, more + fewer).pvalue) if more + fewer > 0 else 1.0
    return PairedTest("mcnemar", p_value, effect)


def median_difference(differences: Sequence[Difference]) -> Estimate:
    """Infinite differences count as larger, or smaller, than every finite one."""
    if not differences:
        return NOTHING
    scores = np.array([each.score for each in differences])
    finite = scores[np.isfinite(scores)]
    least, most = (float(np.min(finite)), float(np.max(finite))) if len(finite) > 0 else (0.0, 0.0)
    beyond = 1000 * (1 + max(abs(least), abs(most)))
    stand_in = np.clip(scores, -beyond, beyond)
    number, relation = float(np.median(stand_in)), "="
    if number > most:
        number, relation = float(np.median([each.least for each in differences])), ">"
    elif number < least:
        number, relation = float(np.median([each.most for each in differences])), "<"
    if len(differences) < FEWEST:
        return Estimate("median", number, relation)
    low, high = bootstrap_interval((stand_in,), plain_median, censored=len(finite) < len(scores))
    return Estimate("median", number, relation, *(_unbounded(end, least, most) for end in (low, high)))


def _unbounded(end: float, least: float, most: float) -> float:
    return math.inf if end > most else -math.inf if end < least else end


def mean_difference(differences: Sequence[Difference]) -> Estimate:
    """Of yes or no: the difference of the two proportions."""
    if not differences:
        return NOTHING
    return Estimate("difference of proportions", float(np.mean([each.score for each in differences])))


def holm(p_values: Sequence[float | None]) -> list[float | None]:
    """Holm's step-down correction over those that are there: the chance of any false finding among them stays below the level."""
    known = sorted((p_value, place) for place, p_value in enumerate(p_values) if p_value is not None)
    corrected: list[float | None] = [None] * len(p_values)
    largest = 0.0
    for rank, (p_value, place) in enumerate(known):
        largest = max(largest, min(1.0, (len(known) - rank) * p_value))
        corrected[place] = largest
    return corrected
