# SPDX-License-Identifier: Apache-2.0
"""Medians and proportions: with censored numbers, with few, with equal ones."""

import math
import pathlib
import sys
import unittest

import numpy as np
from scipy import stats

TREE = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(TREE / "experiment/report"))

from estimates import kaplan_meier_half, median, proportion  # noqa: E402
from sweep_runs import Value  # noqa: E402


def known(*numbers: float) -> list[Value]:
    return [Value(number) for number in numbers]


def censored(*numbers: float) -> list[Value]:
    return [Value(number, False) for number in numbers]


class Median(unittest.TestCase):
    def test_is_the_ordinary_one_with_scipys_interval_when_nothing_is_censored(self) -> None:
        numbers = np.random.default_rng(5).lognormal(size=25)
        found = median(known(*numbers))
        expected = stats.bootstrap((numbers,), np.median, n_resamples=9999, method="BCa",
                                   random_state=np.random.default_rng(1)).confidence_interval
        self.assertEqual((found.statistic, found.number, found.relation), ("median", np.median(numbers), "="))
        self.assertAlmostEqual(found.low, expected.low)
        self.assertAlmostEqual(found.high, expected.high)

    def test_gives_the_same_interval_again(self) -> None:
        numbers = known(*np.random.default_rng(6).normal(size=12))
        self.assertEqual(median(numbers), median(numbers))

    def test_counts_a_censored_number_as_larger_than_every_known_one(self) -> None:
        found = median(known(10, 20, 30, 40, 50) + censored(60, 60))
        self.assertEqual((found.number, found.relation), (40, "="))
        self.assertEqual(found.high, math.inf)  # resamples in which most are censored are common
        self.assertLess(found.low, 40)

    def test_differs_from_the_median_of_those_that_finished(self) -> None:
        finished = known(*range(1, 20))
        self.assertEqual(median(finished).number, 10)
        self.assertEqual(median(finished + censored(*[100] * 6)).number, 13)

    def test_is_above_the_limit_when_more_than_half_are_censored(self) -> None:
        found = median(known(10, 20) + censored(*[60] * 5))
        self.assertEqual((found.number, found.relation, found.high), (60, ">", math.inf))

    def test_is_above_the_last_known_number_when_exactly_half_are_censored(self) -> None:
        found = median(known(10, 20, 30) + censored(60, 60, 60))
        self.assertEqual((found.number, found.relation), (30, ">"))

    def test_of_censored_numbers_only_is_above_the_limit_without_an_upper_end(self) -> None:
        found = median(censored(*[60] * 8))
        self.assertEqual((found.number, found.relation, found.low, found.high), (60, ">", 60, math.inf))

    def test_of_equal_numbers_has_an_interval_of_no_width(self) -> None:
        found = median(known(*[4] * 10))
        self.assertEqual((found.number, found.low, found.high), (4, 4, 4))

    def test_has_an_interval_where_leaving_out_a_number_changes_nothing(self) -> None:
        found = median(known(1, 2, 2, 2, 2, 2, 2, 9))
        self.assertTrue(1 <= found.low <= 2 <= found.high <= 9)

    def test_of_fewer_than_six_has_no_interval(self) -> None:
        self.assertIsNone(median(known(1, 2, 3, 4, 5)).low)
        self.assertIsNotNone(median(known(1, 2, 3, 4, 5, 6)).low)
        self.assertEqual(median(known(7)).number, 7)
        self.assertIsNone(median([]).number)


class KaplanMeier(unittest.TestCase):
    # Freireich et al. 1963, remission times in weeks under 6-MP; the published median is 23 weeks.
    WEEKS = np.array([6, 6, 6, 6, 7, 9, 10, 10, 11, 13, 16, 17, 19, 20, 22, 23, 25, 32, 32, 34, 35], dtype=float)
    RELAPSED = np.array([1, 1, 1, 0, 1, 0, 1, 0, 0, 1, 1, 0, 0, 0, 1, 1, 0, 0, 0, 0, 0], dtype=bool)

    def test_finds_the_published_median(self) -> None:
        found = median([Value(*one) for one in zip(self.WEEKS, self.RELAPSED)])
        self.assertEqual((found.statistic, found.number, found.relation), ("median (Kaplan-Meier)", 23, "="))
        self.assertLess(found.low, 23)
        self.assertEqual(found.high, math.inf)

    def test_equals_the_ordinary_median_without_censored_times(self) -> None:
        random = np.random.default_rng(7)
        for count in (1, 2, 3, 8, 9):
            numbers = np.round(random.exponential(10, size=(20, count)))
            ends = kaplan_meier_half(numbers, np.ones_like(numbers, dtype=bool), math.inf)
            np.testing.assert_array_equal(np.mean(ends, axis=0), np.median(numbers, axis=-1))


class Proportion(unittest.TestCase):
    def test_has_wilsons_interval(self) -> None:
        found = proportion(known(*[1] * 81, *[0] * 182))  # Newcombe 1998, table I: 0.3080 (0.2553 to 0.3662)
        self.assertAlmostEqual(found.number, 0.3080, 4)
        self.assertAlmostEqual(found.low, 0.2553, 4)
        self.assertAlmostEqual(found.high, 0.3662, 4)

    def test_is_not_certain_when_all_are_equal(self) -> None:
        self.assertGreater(proportion(known(*[0] * 10)).high, 0.2)


if __name__ == "__main__":
    unittest.main()
