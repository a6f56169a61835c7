# SPDX-License-Identifier: Apache-2.0
"""Coverage by simulation: how often the interval contains the true number, for distributions whose true number is known."""

import math
import pathlib
import sys
import unittest
from collections.abc import Callable

import numpy as np

TREE = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(TREE / "experiment/report"))

import estimates  # noqa: E402
from paired import difference, median_difference  # noqa: E402
from sweep_runs import Value  # noqa: E402

SEED = 16
SAMPLES = 250  # the standard error of a coverage of 95 % is 1.4 %
LOW, HIGH = 0.90, 0.99  # of a nominal 95 %


def coverage(interval: Callable[[np.random.Generator], estimates.Estimate], truth: float) -> float:
    random = np.random.default_rng(SEED)
    found = [interval(random) for _ in range(SAMPLES)]
    return float(np.mean([one.low <= truth <= one.high for one in found]))


def censored_at(limit: float, numbers: np.ndarray) -> list[Value]:
    return [Value(min(number, limit), number <= limit) for number in numbers]


class Coverage(unittest.TestCase):
    def setUp(self) -> None:
        print(f"seed {SEED}")
        self.resamples, estimates.RESAMPLES = estimates.RESAMPLES, 999

    def tearDown(self) -> None:
        estimates.RESAMPLES = self.resamples

    def check(self, name: str, interval: Callable[[np.random.Generator], estimates.Estimate], truth: float) -> None:
        with self.subTest(name=name):
            found = coverage(interval, truth)
            print(f"{name}: {100 * found:.1f} %")
            self.assertTrue(LOW <= found <= HIGH, f"{name}: {found}")

    def test_of_the_median(self) -> None:
        for count in (10, 30):
            for name, draw, truth in (
                    ("normal", lambda random, count=count: random.normal(size=count), 0.0),
                    ("exponential", lambda random, count=count: random.exponential(size=count), math.log(2)),
                    ("lognormal", lambda random, count=count: random.lognormal(sigma=1.5, size=count), 1.0)):
                self.check(f"median of {count}, {name}",
                           lambda random, draw=draw: estimates.median([Value(one) for one in draw(random)]), truth)

    def test_of_the_median_with_censored_numbers(self) -> None:
        # A quarter and 45 % of exponential times are above the limit; leaving them out would give medians of 0.47 and 0.32.
        for limit in (math.log(4), math.log(1 / 0.45)):
            self.check(f"median of 30, exponential, limit {limit:.2f}",
                       lambda random, limit=limit: estimates.median(censored_at(limit, random.exponential(size=30))), math.log(2))

    def test_of_the_median_with_several_limits(self) -> None:
        def one(random: np.random.Generator) -> estimates.Estimate:
            times = random.exponential(size=30)
            return estimates.median(censored_at(0.5, times[:10]) + censored_at(2.0, times[10:]))

        self.check("Kaplan-Meier median of 30, limits 0.5 and 2", one, math.log(2))

    def test_of_the_median_difference(self) -> None:
        def one(random: np.random.Generator) -> estimates.Estimate:
            common = random.exponential(5, size=30)  # the seed makes both easy or hard
            level, reference = (common + random.normal(mean, 1, 30) for mean in (0.5, 0.0))
            return median_difference([difference(Value(a), Value(b)) for a, b in zip(level, reference)])

        self.check("median difference of 30 pairs", one, 0.5)

    def test_of_a_proportion(self) -> None:
        self.check("proportion of 30", lambda random: estimates.proportion([Value(one) for one in random.binomial(1, 0.8, 30)]), 0.8)


    def test_of_the_median_difference_with_censored_numbers(self) -> None:
        def one(random: np.random.Generator) -> estimates.Estimate:
            common = random.exponential(5, size=30)
            level, reference = (censored_at(12.0, common + random.normal(mean, 1, 30)) for mean in (0.5, 0.0))
            return median_difference([difference(a, b) for a, b in zip(level, reference)])

        self.check("median difference of 30 pairs, limit 12", one, 0.5)


class DroppingIsWrong(unittest.TestCase):
    def test_intervals_of_the_finished_runs_only_miss_the_true_median(self) -> None:
        """What this file would notice if censored runs were dropped."""
        def dropped(random: np.random.Generator) -> estimates.Estimate:
            times = random.exponential(size=30)
            return estimates.median([Value(time) for time in times[times <= math.log(1 / 0.45)]])

        self.assertLess(coverage(dropped, math.log(2)), 0.5)


if __name__ == "__main__":
    unittest.main()
