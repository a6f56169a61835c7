# SPDX-License-Identifier: Apache-2.0
"""Main effects and interactions: over which settings they are taken, and that a seed counts once."""

import pathlib
import sys
import tempfile
import unittest

TREE = pathlib.Path(__file__).resolve().parents[3]
sys.path[:0] = [str(TREE / "experiment/report"), str(TREE / "tests/support")]

from effects import effect, middle  # noqa: E402
from made_sweeps import make_sweep, row  # noqa: E402
from sweep_runs import Sweep, Value, read_sweep  # noqa: E402

AXES = ("a.x", "a.y")


def sweep(rows: list[list[str]]) -> Sweep:
    with tempfile.TemporaryDirectory() as folder:
        return read_sweep(make_sweep(pathlib.Path(folder), rows, AXES))


def crossed(seeds: int = 6) -> Sweep:
    """100 + 10 x + y, and 50 more where both are high."""
    return sweep([row("none", seed, 100.0 + 10 * x + y + 50 * (x == 2 and y == 5), (str(x), str(y)))
                  for x in (1, 2) for y in (3, 5) for seed in range(1, seeds + 1)])


class Effects(unittest.TestCase):
    def test_of_one_factor_are_medians_over_the_levels_of_the_others(self) -> None:
        found = effect(crossed(), ("a.x",), "sim_time_s")
        self.assertEqual({levels: one.number for levels, one in found.at.items()}, {("1",): 114, ("2",): 149})
        self.assertEqual(found.settings, 2)

    def test_of_two_factors_show_that_they_interact(self) -> None:
        at = {levels: one.number for levels, one in effect(crossed(), ("a.x", "a.y"), "sim_time_s").at.items()}
        self.assertEqual((at["1", "5"] - at["1", "3"], at["2", "5"] - at["2", "3"]), (2, 52))

    def test_count_a_seed_once_so_that_five_seeds_have_no_interval(self) -> None:
        self.assertIsNone(effect(crossed(5), ("a.x",), "sim_time_s").at["1",].low)
        self.assertIsNotNone(effect(crossed(6), ("a.x",), "sim_time_s").at["1",].low)

    def test_use_the_settings_that_all_levels_have(self) -> None:
        # One at a time around (1, 3); taken over all rows, y = 3 would include x = 2.
        one_at_a_time = sweep([row("none", seed, time, setting) for seed in range(1, 4)
                               for time, setting in ((10.0, ("1", "3")), (90.0, ("2", "3")), (20.0, ("1", "5")))])
        found = effect(one_at_a_time, ("a.y",), "sim_time_s")
        self.assertEqual({levels: one.number for levels, one in found.at.items()}, {("3",): 10, ("5",): 20})
        self.assertIsNone(effect(one_at_a_time, ("a.x", "a.y"), "sim_time_s"))

    def test_are_bounds_where_runs_did_not_finish(self) -> None:
        runs = [row("none", seed, None if x == 2 else 10.0, (str(x), "3")) for x in (1, 2) for seed in range(1, 7)]
        self.assertEqual(effect(sweep(runs), ("a.x",), "sim_time_s").at["2",].relation, ">")
        self.assertEqual(middle([Value(5), Value(9, False)]), Value(5, False))
        self.assertEqual(middle([Value(5), Value(9, False), Value(7)]), Value(7))

    def test_without_numbers_are_left_out(self) -> None:
        self.assertIsNone(effect(crossed(), ("a.x",), "round_trip_mean_s"))


if __name__ == "__main__":
    unittest.main()
