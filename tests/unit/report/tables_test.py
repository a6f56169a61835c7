# SPDX-License-Identifier: Apache-2.0
"""The tables of docs/reproduction.md."""

import pathlib
import sys
import tempfile
import unittest

TREE = pathlib.Path(__file__).resolve().parents[3]
sys.path[:0] = [str(TREE / "experiment/report"), str(TREE / "tests/support")]

from made_runs import make_run, robot  # noqa: E402
from meetings import meetings  # noqa: E402
from paper import PAPER  # noqa: E402
from quantities import QUANTITIES, by_mode  # noqa: E402
from records import read_run  # noqa: E402
from tables import comparison, needed_min, pairs, steady, variants  # noqa: E402


class Tables(unittest.TestCase):
    def setUp(self) -> None:
        held = tempfile.TemporaryDirectory()
        self.addCleanup(held.cleanup)
        folder = pathlib.Path(held.name)
        ends = {("none", 1): 1200.0, ("none", 2): 1500.0, ("full", 1): 1320.0, ("full", 2): 1380.0, ("full", 3): 600.0}
        self.runs = by_mode([read_run(make_run(folder / f"{mode}-{seed}", mode, seed, sim_time_s=end_s))
                             for (mode, seed), end_s in ends.items()])

    def test_the_papers_numbers_bear_names_of_ours(self) -> None:
        self.assertEqual(set(PAPER) - {quantity.name for quantity in QUANTITIES}, set())

    def test_ours_stand_beside_the_papers(self) -> None:
        rows = {line.split(" | ")[0].strip("| "): line for line in comparison(self.runs).splitlines()}
        ours_and_theirs = rows["time to the last item, min"].removeprefix("| time to the last item, min ")
        self.assertEqual(ours_and_theirs, "| 51 | 22.5 (20.0 to 25.0) | 70; 67 (log) | 22.0 (10.0 to 23.0) |")

    def test_only_runs_of_the_same_seed_are_compared(self) -> None:
        self.assertIn("| full against none | 2 | 1 of 2 | +0.0 (-2.0 to +2.0) |", pairs(self.runs))

    def test_the_time_needed_counts_every_robot_from_its_path_on(self) -> None:
        self.assertAlmostEqual(needed_min([0.0], 60.0, 10), 10.0)
        self.assertAlmostEqual(needed_min([0.0, 300.0], 60.0, 10), 7.5)  # 5 items by 5 min, then two a minute
        self.assertAlmostEqual(needed_min([900.0, 0.0], 60.0, 10), 10.0, msg="the second comes too late")

    def test_a_robot_that_searches_meets_one_that_passes_with_a_path_once(self) -> None:
        with tempfile.TemporaryDirectory() as folder:
            run = read_run(make_run(pathlib.Path(folder) / "run", per_robot=[robot(1, found_s=4.0), robot(2)]))
        # As if it were recorded from a minute after exchanges began, at 5 s.
        run.track_times += 65.0
        found = meetings([run])
        self.assertEqual(found.meetings, 1)
        self.assertEqual(found.floor_m2, [44.0], msg="from x = -10 to 10 m, in cells of 2 m")
        self.assertAlmostEqual(found.searching_min, 21 / 60)
        self.assertEqual(found.got_path, 0)

    def test_variants_are_compared_over_the_seeds_that_all_of_them_have(self) -> None:
        time = [quantity for quantity in QUANTITIES if quantity.name == "time to the last item, min"]
        fewer = {"full": [run for run in self.runs["full"] if run.seed != 3]}
        text = variants({"as it is": self.runs, "fewer": fewer}, time)
        self.assertIn("| variant | quantity | none: 2 seeds | full: 2 seeds |", text)
        self.assertIn("| as it is | time to the last item, min | 22.5 (20.0 to 25.0) | 22.5 (22.0 to 23.0) |", text)
        self.assertIn("| fewer | time to the last item, min | - | 22.5 (22.0 to 23.0) |", text)

    def test_runs_too_short_for_a_steady_state_are_counted(self) -> None:
        text = variants({"as it is": self.runs}, [steady()])
        self.assertIn("| items a minute over the last 200 | -; 2 of 2 without | -; 3 of 3 without |", text)


if __name__ == "__main__":
    unittest.main()
