# SPDX-License-Identifier: Apache-2.0
"""Paired differences, their test and effect size, Holm's correction: published values, censored pairs, ties."""

import itertools
import math
import pathlib
import sys
import unittest

import numpy as np
from scipy import stats

TREE = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(TREE / "experiment/report"))

from paired import (difference, exact_p_value, holm, mcnemar, median_difference, rank_biserial, signed_ranks, wilcoxon)  # noqa: E402
from sweep_runs import Value  # noqa: E402

# Heights of cross- and self-fertilised corn plants (Darwin 1876), the example of scipy.stats.wilcoxon.
PLANTS = (6, 8, 14, 16, 23, 24, 28, 29, 41, -48, 49, 56, 60, -67, 75)
SCIPYS_P = 0.041259765625  # published in SciPy's documentation, with the statistic 24.0


class Wilcoxon(unittest.TestCase):
    def test_gives_scipys_published_p_value(self) -> None:
        self.assertEqual(wilcoxon(PLANTS).p_value, SCIPYS_P)
        self.assertEqual(sum(-rank for rank in signed_ranks(PLANTS) if rank < 0), 24)

    def test_over_all_signs_agrees_with_scipy_where_there_are_no_ties(self) -> None:
        self.assertAlmostEqual(exact_p_value(signed_ranks(PLANTS)), SCIPYS_P, 12)
        for count in (3, 10, 30):
            numbers = np.random.default_rng(count).normal(0.3, 1, count)
            self.assertAlmostEqual(exact_p_value(signed_ranks(numbers)), stats.wilcoxon(numbers, method="exact").pvalue, 12)

    def test_is_exact_with_ties(self) -> None:
        numbers = (1, 1, -1, 2, 2, 3, -3, 3)
        ranks = np.abs(signed_ranks(numbers))
        seen = sum(rank for rank in signed_ranks(numbers))
        sums = [np.dot(signs, ranks) for signs in itertools.product((-1, 1), repeat=len(ranks))]
        self.assertAlmostEqual(wilcoxon(numbers).p_value, np.mean(np.abs(sums) >= abs(seen) - 1e-9), 12)

    def test_finds_nothing_in_ties_only(self) -> None:
        found = wilcoxon([0.0] * 12)
        self.assertEqual((found.p_value, found.rank_biserial), (1.0, 0.0))

    def test_leaves_out_zeros(self) -> None:
        self.assertEqual(wilcoxon((*PLANTS, 0, 0)).p_value, SCIPYS_P)

    def test_uses_the_normal_approximation_above_fifty_pairs(self) -> None:
        numbers = np.random.default_rng(2).normal(0.2, 1, 60)
        found = wilcoxon(numbers)
        self.assertEqual(found.test, "wilcoxon normal")
        self.assertAlmostEqual(found.p_value, stats.wilcoxon(numbers).pvalue, 12)

    def test_of_one_pair_or_none_claims_nothing(self) -> None:
        self.assertEqual(wilcoxon([5.0]).p_value, 1.0)
        self.assertIsNone(wilcoxon([]).p_value)

    def test_is_right_one_time_in_twenty_when_there_is_no_difference(self) -> None:
        seed = 16
        print(f"seed {seed}")
        random = np.random.default_rng(seed)
        found = np.mean([wilcoxon(random.normal(size=20)).p_value <= 0.05 for _ in range(500)])
        self.assertTrue(0.03 <= found <= 0.07, found)


class RankBiserial(unittest.TestCase):
    def test_is_the_difference_of_the_two_rank_sums_by_their_total(self) -> None:
        self.assertAlmostEqual(rank_biserial(PLANTS), (96 - 24) / 120)  # the sums that SciPy's example prints
        # King, Rosopa and Minium 2011, quoted by Kerby 2014: 0.57 of sums 43 and 12 is (43 - 12) / 55.
        self.assertAlmostEqual(rank_biserial((10, 9, 8, 7, 6, 3, -5, -4, -2, -1)), 31 / 55)

    def test_is_one_when_every_pair_agrees(self) -> None:
        self.assertEqual(rank_biserial((1, 2, 3)), 1)
        self.assertEqual(rank_biserial((-1, -math.inf)), -1)


class CensoredPairs(unittest.TestCase):
    LIMIT = Value(100, False)

    def test_count_the_censored_one_as_larger(self) -> None:
        self.assertEqual(difference(self.LIMIT, Value(30)).score, math.inf)
        self.assertEqual(difference(self.LIMIT, Value(30)).least, 70)
        self.assertEqual(difference(Value(30), self.LIMIT).score, -math.inf)
        self.assertEqual(difference(Value(30), self.LIMIT).most, -70)

    def test_claim_nothing_when_both_are_censored_or_the_limit_was_lower(self) -> None:
        self.assertEqual(difference(self.LIMIT, self.LIMIT).score, 0)
        self.assertEqual(difference(self.LIMIT, Value(150)).score, 0)
        self.assertEqual(difference(Value(150), self.LIMIT).score, 0)

    def test_have_the_highest_ranks(self) -> None:
        np.testing.assert_array_equal(signed_ranks((5, -math.inf, 90, math.inf)), (1, -3.5, 2, 3.5))

    def test_leave_the_median_difference_known_while_they_are_few(self) -> None:
        found = median_difference([difference(Value(number), Value(0)) for number in (1, 2, 3, 4, 5)]
                                  + [difference(self.LIMIT, Value(30))] * 2)
        self.assertEqual((found.number, found.relation, found.high), (4, "=", math.inf))

    def test_make_the_median_difference_a_bound_when_they_are_most(self) -> None:
        more = [difference(Value(1), Value(0))] * 2 + [difference(self.LIMIT, Value(30 + i)) for i in range(5)]
        found = median_difference(more)
        self.assertEqual((found.number, found.relation), (67, ">"))  # at least 66 .. 70 in five of seven, median of all
        fewer = median_difference([difference(Value(30), self.LIMIT)] * 6)
        self.assertEqual((fewer.number, fewer.relation, fewer.low), (-70, "<", -math.inf))

    def test_are_seen_by_the_test(self) -> None:
        scores = [difference(self.LIMIT, Value(30)).score] * 8
        self.assertEqual(wilcoxon(scores).p_value, 2 / 2**8)


class YesOrNo(unittest.TestCase):
    def test_uses_mcnemars_exact_test(self) -> None:
        scores = [1.0] * 9 + [-1.0] * 1 + [0.0] * 20
        self.assertAlmostEqual(mcnemar(scores).p_value, 22 / 1024, 12)
        self.assertAlmostEqual(mcnemar(scores).rank_biserial, 0.8)
        self.assertEqual(mcnemar([0.0] * 5).p_value, 1)


class Holm(unittest.TestCase):
    def test_multiplies_the_smallest_by_the_number_of_comparisons_and_so_on(self) -> None:
        np.testing.assert_allclose(holm((0.01, 0.04, 0.03, 0.005)), (0.03, 0.06, 0.06, 0.02))

    def test_stays_at_most_one_and_skips_what_was_not_tested(self) -> None:
        self.assertEqual(holm((0.6, None, 0.7)), [1, None, 1])
        self.assertEqual(holm(()), [])


if __name__ == "__main__":
    unittest.main()
