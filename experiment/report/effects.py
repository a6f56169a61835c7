# SPDX-License-Identifier: Apache-2.0
"""Main effects and interactions of the factors of a sweep: a quantity at each level, or pair of levels, over balanced settings."""

import itertools
from dataclasses import dataclass

from estimates import Estimate, median
from sweep_runs import Cell, Sweep, SweepRun, Value

Levels = tuple[str, ...]


@dataclass(frozen=True)
class Effect:
    factors: tuple[str, ...]  # one: a main effect; two: an interaction
    quantity: str
    settings: int  # of the other factors, over which a seed's median is taken
    at: dict[Levels, Estimate]  # over seeds


def middle(values: list[Value]) -> Value:
    """The median, where a censored number is larger than every known one."""
    ordered = sorted(values, key=lambda value: (not value.known, value.number))
    low, high = ordered[(len(ordered) - 1) // 2], ordered[len(ordered) // 2]
    return Value((low.number + high.number) / 2) if low.known and high.known else Value(low.number, False)


def effect(sweep: Sweep, factors: tuple[str, ...], quantity: str) -> Effect | None:
    """Only those settings of the other factors are used that occur with all levels, so that levels do not differ by them. None if there
    are none, or no run has the quantity."""
    places = [sweep.factors.index(factor) for factor in factors]
    combinations = list(itertools.product(*(sweep.levels(factor) for factor in factors)))

    def parts(cell: Cell) -> tuple[Levels, Levels]:
        return tuple(cell[i] for i in places), tuple(level for i, level in enumerate(cell) if i not in places)

    by_parts = {parts(cell): sweep.of(cell) for cell in sweep.cells()}
    others = [other for other in dict.fromkeys(other for _, other in by_parts)
              if all((levels, other) in by_parts for levels in combinations)]
    if not others or len(combinations) < 2:
        return None
    found = {levels: median(_per_seed([by_parts[levels, other] for other in others], quantity)) for levels in combinations}
    return Effect(factors, quantity, len(others), found) if any(one.number is not None for one in found.values()) else None


def _per_seed(settings: list[list[SweepRun]], quantity: str) -> list[Value]:
    """One number for each seed that has all settings: numbers of one seed are not independent."""
    by_setting = [{run.seed: value for run in runs if (value := run.value(quantity)) is not None} for runs in settings]
    seeds = set.intersection(*(set(numbers) for numbers in by_setting))
    return [middle([numbers[seed] for numbers in by_setting]) for seed in sorted(seeds)]
