# SPDX-License-Identifier: Apache-2.0
"""The data that the report reads from a run, and its handling of folders without one."""

import json
import pathlib
import sys
import tempfile
import unittest

import numpy as np

TREE = pathlib.Path(__file__).resolve().parents[3]
sys.path[:0] = [str(TREE / "experiment/report"), str(TREE / "tests/support")]

import series  # noqa: E402
import traffic  # noqa: E402
from find_runs import read_all  # noqa: E402
from made_runs import make_run, metrics, metrics, robot  # noqa: E402
from quantities import (QUANTITIES, by_mode, exchanges_per_minute, last_items_per_minute,  # noqa: E402
                        lost_to_traffic, round_trip_s, summary, typical)
from records import BrokenRun, read_run  # noqa: E402
from trip_budget import PARTS, budget, time_in  # noqa: E402


class InAFolder(unittest.TestCase):
    def setUp(self) -> None:
        self.held = tempfile.TemporaryDirectory()
        self.addCleanup(self.held.cleanup)
        self.folder = pathlib.Path(self.held.name)


class Reading(InAFolder):
    def test_a_session_told_of_by_both_counts_once_and_a_lone_attempt_as_failed(self) -> None:
        run = read_run(make_run(self.folder / "run"))
        self.assertEqual(run.exchanges.tolist(), [[8.0, 1.0], [9.0, 0.0]])
        self.assertEqual(len(run.reports), 3)

    def test_only_robots_touching_robots_are_contacts(self) -> None:
        self.assertEqual(read_run(make_run(self.folder / "run")).contacts.tolist(), [10.0])

    def test_a_row_that_is_cut_off_is_left_out(self) -> None:
        folder = make_run(self.folder / "run")
        for name in ("tracks.csv", "events.csv", "trips.csv", "paths.csv"):
            file = folder / name
            file.write_text(file.read_text()[:-4])
        run = read_run(folder)
        self.assertEqual(len(run.tracks), 20)
        self.assertEqual(run.deliveries.tolist(), [10.0])

    def test_a_run_recorded_without_activities_and_path_lengths_can_be_read(self) -> None:
        folder = make_run(self.folder / "run")
        (folder / "activities.csv").unlink()
        (folder / "path_lengths.csv").unlink()
        run = read_run(folder)
        self.assertIsNone(budget([run]))

    def test_says_what_is_wrong_with_a_broken_run(self) -> None:
        for name, text, reason in (("metrics.json", '{"mode": ', "cut off"),
                                   ("metrics.json", '{"mode": "full"}', "no seed"),
                                   ("scenario.toml", "name = ", "cannot be read"),
                                   ("tracks.csv", "time_s,robot\n", "empty"),
                                   ("events.csv", "time_s,robot\n1.0\n", "events.csv:2"),
                                   ("paths.csv", "robot,index,x_m,y_m\n1,0,here,0\n", "cannot be read")):
            with self.subTest(name=name, text=text):
                folder = make_run(self.folder / f"{name}-{len(text)}")
                (folder / name).write_text(text)
                with self.assertRaisesRegex(BrokenRun, reason):
                    read_run(folder)
        folder = make_run(self.folder / "missing")
        (folder / "events.csv").unlink()
        with self.assertRaisesRegex(BrokenRun, "events.csv: No such file"):
            read_run(folder)

    def test_names_what_is_not_of_its_kind_in_the_metrics(self) -> None:
        right = metrics()["per_robot"]
        for number, (changes, reason) in enumerate((
                ({"per_robot": None}, "per_robot that no run writes: None"),
                ({"per_robot": [None, None]}, "robot 1, is no table"),
                ({"per_robot": [right[0] | {"found_s": "soon"}, right[1]]}, "robot 1, has a found_s"),
                ({"per_robot": [right[0], right[1] | {"items": None}]}, "robot 2, has a items"),
                ({"per_robot": [right[0], {}]}, "robot 2, has no items"),
                ({"per_robot": right[:1]}, "contradicts itself"),
                ({"sim_time_s": float("nan")}, "sim_time_s that no run writes: nan"),
                ({"sim_time_s": True}, "sim_time_s"),
                ({"exchanges": {}}, "exchanges has no completed"),
                ({"contacts": []}, "contacts"),
                ({"routes": 10**400}, "routes"))):
            with self.subTest(changes=changes):
                with self.assertRaisesRegex(BrokenRun, f"metrics.json.*{reason}"):
                    read_run(make_run(self.folder / str(number), **changes))

    def test_a_folder_in_place_of_a_file_is_named(self) -> None:
        for name in ("metrics.json", "scenario.toml", "tracks.csv", "events.csv", "trips.csv", "paths.csv"):
            with self.subTest(name=name):
                folder = make_run(self.folder / name)
                (folder / name).unlink()
                (folder / name).mkdir()
                with self.assertRaisesRegex(BrokenRun, f"{name}: Is a directory"):
                    read_run(folder)


class Finding(InAFolder):
    def test_takes_runs_folders_of_runs_and_sweeps_each_run_once(self) -> None:
        one = make_run(self.folder / "one")
        make_run(self.folder / "sweep/none/seed_2", "none", 2)
        make_run(self.folder / "sweep/none/seed_10", "none", 10)
        (self.folder / "sweep/scenario.toml").write_text("")
        (self.folder / "sweep/sweep.json").write_text('{"runs": []}')
        runs, skipped = read_all([one, self.folder / "sweep", self.folder])
        self.assertEqual([run.seed for run in runs], [1, 2, 10])
        self.assertEqual(skipped, [])

    def test_names_what_it_skips_and_goes_on(self) -> None:
        make_run(self.folder / "good")
        broken = make_run(self.folder / "broken")
        (broken / "metrics.json").write_text("")
        (self.folder / "begun").mkdir()
        (self.folder / "begun/scenario.toml").write_text("")
        runs, skipped = read_all([self.folder, self.folder / "nowhere"])
        self.assertEqual(len(runs), 1)
        self.assertEqual({one.folder.name for one in skipped}, {"broken", "begun", "nowhere"})

    def test_names_the_runs_of_a_sweep_that_left_nothing(self) -> None:
        make_run(self.folder / "full/seed_1")
        planned = [{"mode": "full", "seed": seed, "folder": f"full/seed_{seed}", "state": state, "reason": reason}
                   for seed, state, reason in ((1, "done", ""), (2, "failed", "exit code 2"), (3, "pending", ""))]
        (self.folder / "sweep.json").write_text(json.dumps({"runs": planned}))
        runs, skipped = read_all([self.folder])
        self.assertEqual(len(runs), 1)
        self.assertEqual([one.reason for one in skipped], ["failed: exit code 2", "pending"])


class Numbers(InAFolder):
    def test_nothing_is_dropped_from_the_summaries(self) -> None:
        make_run(self.folder / "a")
        make_run(self.folder / "b", seed=2, completed=False, items_delivered=1, sim_time_s=60.0,
                 per_robot=[robot(1, found_s=4.0, items=1, path_length_m=8.0), robot(2)],
                 exchanges={"completed": 0, "failed": 5, "mean_duration_s": 0.5})
        runs = by_mode(read_all([self.folder])[0])["full"]
        text = {quantity.name: summary(quantity, runs) for quantity in QUANTITIES}
        self.assertEqual(text["time to the last item, min"], "0.3; 1 of 2 without")
        self.assertEqual(text["robots that never had a path"], "0.5 (0 to 1)")
        self.assertEqual(text["exchanges failed"], "3 (1 to 5)")
        self.assertEqual(text["items delivered"], "1.5 (1 to 2)")

    def test_the_typical_run_is_the_median_of_those_that_delivered_everything(self) -> None:
        for seed, end_s, completed in ((1, 30.0, True), (2, 20.0, True), (3, 40.0, True), (4, 99.0, False)):
            make_run(self.folder / str(seed), seed=seed, sim_time_s=end_s, completed=completed)
        self.assertEqual(typical(by_mode(read_all([self.folder])[0])["full"]).seed, 1)

    def test_round_trips_end_with_the_next_pick_up(self) -> None:
        self.assertEqual(round_trip_s(read_run(make_run(self.folder / "run"))), [8.0])

    def test_exchanges_per_minute_are_over_the_time_in_which_they_were_allowed(self) -> None:
        self.assertAlmostEqual(exchanges_per_minute(read_run(make_run(self.folder / "run"))), 60 * 2 / 15)
        self.assertIsNone(exchanges_per_minute(read_run(make_run(self.folder / "none", "none"))))

    def test_items_per_minute_leaves_out_the_start(self) -> None:
        run = read_run(make_run(self.folder / "run"))
        self.assertAlmostEqual(last_items_per_minute(run, 1), 60 / 8)
        self.assertIsNone(last_items_per_minute(run, 2))

    def test_metrics_made_for_tests_are_what_the_reader_wants(self) -> None:
        self.assertEqual(metrics()["robots"], len(metrics()["per_robot"]))


class OverTime(InAFolder):
    def test_the_band_is_median_and_quartiles_and_a_run_that_ended_keeps_its_last_value(self) -> None:
        for seed, end_s in ((1, 20.0), (2, 10.0), (3, 20.0)):
            make_run(self.folder / str(seed), seed=seed, sim_time_s=end_s)
        runs = read_all([self.folder])[0]
        band = series.band(runs, series.items, np.array([0.0, 11.0, 19.0]))
        self.assertEqual(band.median.tolist(), [0.0, 1.0, 2.0])
        self.assertEqual(band.low.tolist(), [0.0, 1.0, 1.5])

    def test_the_mean_path_is_that_of_the_robots_that_have_one(self) -> None:
        run = read_run(make_run(self.folder / "run"))
        lengths = series.mean_path_length(run, np.array([3.0, 5.0, 9.0, 13.0]))
        self.assertTrue(np.isnan(lengths[0]))
        self.assertEqual(lengths[1:].tolist(), [20.0, 14.5, 8.5])


class Traffic(InAFolder):
    def test_time_is_lost_where_a_robot_with_a_path_falls_short_of_cruise_speed(self) -> None:
        found = traffic.losses(read_run(make_run(self.folder / "run")))
        # Robot 1 drives at cruise speed. Robot 2 stands from 8 s on, 12 s; robot 1 is within 2 m of it at 9 to 11 s.
        self.assertAlmostEqual(float(np.sum(found.lost_s)), 12.0)
        self.assertAlmostEqual(float(np.sum(found.lost_s[found.beside])), 3.0)

    def test_its_share_is_of_the_time_that_robots_had_a_path(self) -> None:
        self.assertAlmostEqual(lost_to_traffic(read_run(make_run(self.folder / "run"))), 100 * 3 / (16 + 12))

    def test_the_map_holds_all_time_lost_beside_another_robot(self) -> None:
        runs = [read_run(make_run(self.folder / name)) for name in ("a", "b")]
        edges = np.linspace(-6, 6, 13)
        lost = traffic.lost_to_traffic_map(runs, edges, edges)
        self.assertAlmostEqual(float(np.sum(lost)), 3.0)
        self.assertAlmostEqual(lost[7, 6], 3.0)  # x = 0, y = 1

    def test_many_robots_are_taken_in_pieces(self) -> None:
        tracks = np.random.default_rng(5).uniform(-20, 20, (7, 30, 2))
        whole = traffic.nearest_m(tracks)
        before, traffic.CHUNK = traffic.CHUNK, 2 * 30 * 30
        try:
            self.assertTrue(np.array_equal(traffic.nearest_m(tracks), whole))
        finally:
            traffic.CHUNK = before


class Budget(InAFolder):
    def test_time_in_an_activity_is_cut_to_the_interval(self) -> None:
        run = read_run(make_run(self.folder / "run"))
        self.assertAlmostEqual(time_in(run, 1, "avoiding", 6.0, 12.0), 1.0)
        self.assertAlmostEqual(time_in(run, 1, "driving", 0.0, 20.0), 17.5)
        self.assertEqual(time_in(run, 2, "exchanging", 0.0, 20.0), 0.0)

    def test_the_parts_of_a_round_trip_add_up_to_it(self) -> None:
        found = budget([read_run(make_run(self.folder / "run"))])
        parts = dict(zip(PARTS, found.parts_s))
        self.assertEqual(found.trips, 1)
        self.assertAlmostEqual(float(np.sum(found.parts_s)), 8.0)
        self.assertAlmostEqual(parts["avoiding"], 2.0)
        self.assertAlmostEqual(parts["exchanging"], 0.5)
        self.assertAlmostEqual(parts["at cruise speed"], 28.0)  # there and back on 20 m, later 8 m


if __name__ == "__main__":
    unittest.main()
