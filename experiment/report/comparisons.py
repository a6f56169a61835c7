# SPDX-License-Identifier: Apache-2.0
"""The statistics of a sweep: an estimate for each setting and quantity, and the comparisons of settings that differ in one factor."""

import itertools
from dataclasses import dataclass

from estimates import Estimate, median, proportion
from paired import (Difference, PairedTest, difference, holm, mcnemar, mean_difference, median_difference, wilcoxon)
from sweep_runs import YES_OR_NO, Cell, Sweep, SweepRun, Value


@dataclass(frozen=True)
class Summary:
    """One quantity in the runs of one setting."""

    cell: Cell
    quantity: str
    plain: tuple[float, ...]  # as they are in runs.csv, sorted; a censored time is the time limit
    used: int  # runs that the estimate uses
    censored: int
    missing: int  # runs without a result: failed, or not run
    estimate: Estimate


@dataclass(frozen=True)
class Contrast:
    """Two settings that differ in one factor only."""

    factor: str
    level: Cell
    reference: Cell
    where: str  # the settings of the other factors that are varied

    def names(self, factors: tuple[str, ...]) -> tuple[str, str]:
        place = factors.index(self.factor)
        return self.level[place], self.reference[place]


@dataclass(frozen=True)
class Comparison:
    contrast: Contrast
    quantity: str
    pairs: int
    unpaired: int  # seeds at which one of the two has no number
    equal: int  # pairs without a difference, or of which nothing says which one is larger
    censored: int  # pairs with a censored number
    difference: Estimate
    result: PairedTest
    p_holm: float | None = None  # over the comparisons of this quantity


def summarise(sweep: Sweep, cell: Cell, quantity: str) -> Summary:
    runs = sweep.of(cell)
    values = [value for run in runs if (value := run.value(quantity)) is not None]
    return Summary(cell, quantity, tuple(sorted(run.numbers[quantity] for run in runs if quantity in run.numbers)), len(values),
                   sum(not value.known for value in values), sum(not run.done for run in runs),
                   proportion(values) if quantity in YES_OR_NO else median(values))


def contrasts(sweep: Sweep) -> list[Contrast]:
    """Every two modes; each level of another factor and the first level of that factor."""
    cells = set(sweep.cells())
    varied = sweep.varied()
    found = []
    for factor in varied:
        place = sweep.factors.index(factor)
        levels = sweep.levels(factor)
        pairs = list(itertools.combinations(levels, 2)) if factor == "mode" else [(levels[0], one) for one in levels[1:]]
        for (reference, level), others in itertools.product(pairs, _others(sweep, place)):
            first, second = (others[:place] + (name,) + others[place:] for name in (reference, level))
            if first in cells and second in cells:
                where = " ".join(f"{name}={first[i]}" for i, name in enumerate(sweep.factors) if i != place and name in varied)
                found.append(Contrast(factor, second, first, where))
    return found


def _others(sweep: Sweep, place: int) -> list[Cell]:
    return list(dict.fromkeys(cell[:place] + cell[place + 1:] for cell in sweep.cells()))


def compare(sweep: Sweep, contrast: Contrast, quantity: str) -> Comparison:
    level, reference = (_by_seed(sweep.of(cell), quantity) for cell in (contrast.level, contrast.reference))
    seeds = sorted({run.seed for cell in (contrast.level, contrast.reference) for run in sweep.of(cell)})
    both = [seed for seed in seeds if seed in level and seed in reference]
    differences: list[Difference] = [difference(level[seed], reference[seed]) for seed in both]
    scores = [each.score for each in differences]
    yes_or_no = quantity in YES_OR_NO
    return Comparison(contrast, quantity, len(both), len(seeds) - len(both), sum(score == 0 for score in scores),
                      sum(not (level[seed].known and reference[seed].known) for seed in both),
                      mean_difference(differences) if yes_or_no else median_difference(differences),
                      mcnemar(scores) if yes_or_no else wilcoxon(scores))


def _by_seed(runs: list[SweepRun], quantity: str) -> dict[int, Value]:
    return {run.seed: value for run in runs if (value := run.value(quantity)) is not None}


def compare_all(sweep: Sweep, quantity: str) -> list[Comparison]:
    """Every contrast, with Holm's correction over them."""
    found = [compare(sweep, contrast, quantity) for contrast in contrasts(sweep)]
    corrected = holm([one.result.p_value for one in found])
    return [Comparison(one.contrast, one.quantity, one.pairs, one.unpaired, one.equal, one.censored, one.difference, one.result, p)
            for one, p in zip(found, corrected)]
