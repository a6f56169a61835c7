# SPDX-License-Identifier: Apache-2.0
"""The tables of whole sweeps: censored runs, runs without a result, factors, few seeds; and input that is refused in one line."""

import csv
import pathlib
import subprocess
import sys
import tempfile
import unittest

TREE = pathlib.Path(__file__).resolve().parents[3]
sys.path[:0] = [str(TREE / "experiment/report"), str(TREE / "tests/support")]

from made_sweeps import make_sweep, row  # noqa: E402

PROGRAM = TREE / "experiment/report/sweep_statistics.py"
FIRST = "mode,quantity,n,minimum,lower_quartile,median,upper_quartile,maximum,used,censored,missing,"


def run(folder: pathlib.Path, *options: str, python: tuple[str, ...] = ()) -> subprocess.CompletedProcess:
    return subprocess.run([sys.executable, "-B", *python, str(PROGRAM), str(folder), *options], capture_output=True, text=True, check=False)


def table(file: pathlib.Path) -> list[dict[str, str]]:
    with open(file, newline="", encoding="utf-8") as stream:
        return list(csv.DictReader(stream))


class SweepTest(unittest.TestCase):
    def setUp(self) -> None:
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.folder = pathlib.Path(place.name) / "out"

    def tables(self, rows: list[list[str]], axes: tuple[str, ...] = ()) -> tuple[list[dict[str, str]], list[dict[str, str]]]:
        ended = run(make_sweep(self.folder, rows, axes))
        self.assertEqual((ended.returncode, ended.stderr), (0, ""))
        self.printed = ended.stdout
        return table(self.folder / "summary.csv"), table(self.folder / "comparisons.csv")

    def one(self, rows: list[dict[str, str]], **wanted: str) -> dict[str, str]:
        found = [one for one in rows if all(one[key] == value for key, value in wanted.items())]
        self.assertEqual(len(found), 1, wanted)
        return found[0]


class Tables(SweepTest):
    def test_keep_the_first_columns_and_add_estimates(self) -> None:
        summary, _ = self.tables([row("none", seed, 100.0 * seed) for seed in range(1, 9)])
        self.assertTrue((self.folder / "summary.csv").read_text().startswith(FIRST))
        time = self.one(summary, quantity="sim_time_s")
        self.assertEqual([time[name] for name in ("n", "minimum", "lower_quartile", "median", "upper_quartile", "maximum")],
                         ["8", "100", "275", "450", "625", "800"])
        self.assertEqual((time["estimate"], time["relation"], time["censored"], time["missing"]), ("450", "=", "0", "0"))
        self.assertLess(float(time["low_95"]), 450)
        self.assertGreater(float(time["high_95"]), 450)
        self.assertNotIn("wall_time_s", {one["quantity"] for one in summary})

    def test_count_runs_that_did_not_finish_as_longer_than_all_others(self) -> None:
        summary, comparisons = self.tables([row("none", seed, 100.0 + seed) for seed in range(1, 9)]
                                           + [row("full", seed, 50.0 if seed < 4 else None) for seed in range(1, 9)])
        full = self.one(summary, quantity="sim_time_s", mode="full")
        self.assertEqual([full[name] for name in ("n", "used", "censored", "estimate", "relation", "high_95")],
                         ["8", "8", "5", "3600", ">", "inf"])
        self.assertIn("> 3600.0", self.printed)
        pair = self.one(comparisons, quantity="sim_time_s")
        self.assertEqual([pair[name] for name in ("level", "reference", "pairs", "unpaired", "censored", "relation")],
                         ["full", "none", "8", "0", "5", ">"])
        self.assertGreater(float(pair["rank_biserial"]), 0.5)
        finished = self.one(summary, quantity="completed", mode="full")
        self.assertEqual((finished["statistic"], finished["estimate"]), ("proportion", "0.375"))
        self.assertEqual(self.one(comparisons, quantity="completed")["test"], "mcnemar")

    def test_name_runs_without_a_result_and_seeds_without_a_pair(self) -> None:
        summary, comparisons = self.tables([row("none", 1, 10), row("none", 2, None, state="failed"), row("full", 1, 20),
                                            row("full", 2, 30), row("full", 3, 40), row("none", 3, None, state="pending")])
        none = self.one(summary, quantity="sim_time_s", mode="none")
        self.assertEqual((none["n"], none["missing"], none["censored"]), ("1", "2", "0"))
        pair = self.one(comparisons, quantity="sim_time_s")
        self.assertEqual((pair["pairs"], pair["unpaired"], pair["difference"]), ("1", "2", "10"))

    def test_take_a_zero_that_means_none_as_none(self) -> None:
        summary, _ = self.tables([row("none", seed, 10.0) for seed in range(1, 4)])
        trips = self.one(summary, quantity="round_trip_mean_s")
        self.assertEqual((trips["n"], trips["used"], trips["estimate"]), ("3", "0", ""))

    def test_of_one_seed_have_neither_interval_nor_finding(self) -> None:
        summary, comparisons = self.tables([row("none", 1, 10), row("full", 1, 20)])
        self.assertEqual(self.one(summary, quantity="sim_time_s", mode="none")["low_95"], "")
        pair = self.one(comparisons, quantity="sim_time_s")
        self.assertEqual((pair["p_value"], pair["low_95"], pair["difference"]), ("1", "", "10"))

    def test_of_ties_only_find_nothing(self) -> None:
        _, comparisons = self.tables([row(mode, seed, 10.0) for mode in ("none", "full") for seed in range(1, 31)])
        pair = self.one(comparisons, quantity="sim_time_s")
        self.assertEqual([pair[name] for name in ("equal", "difference", "low_95", "high_95", "p_value", "p_holm", "rank_biserial")],
                         ["30", "0", "0", "0", "1", "1", "0"])

    def test_are_the_same_again(self) -> None:
        rows = [row(mode, seed, 10.0 * (seed * 7 % 11 + len(mode))) for mode in ("none", "full") for seed in range(1, 11)]
        self.tables(rows)
        first = [(self.folder / name).read_bytes() for name in ("summary.csv", "comparisons.csv")]
        self.tables(rows)
        self.assertEqual(first, [(self.folder / name).read_bytes() for name in ("summary.csv", "comparisons.csv")])

    def test_print_long_lists_shortened(self) -> None:
        self.tables([row("none", 1, 10.0, (str(count),)) for count in range(60)], ("robots.count",))
        self.assertIn("... and 36 more in summary.csv", self.printed)


class Factors(SweepTest):
    AXES = ("algorithm.vision_radius_m", "robots.count")

    def rows(self) -> list[list[str]]:
        return [row("none", seed, 100.0 + seed - 10 * int(radius) + (seed % 3) * int(count), (radius, count))
                for radius in ("2", "4", "6") for count in ("5", "9") for seed in range(1, 13)]

    def test_have_a_row_for_each_setting(self) -> None:
        summary, _ = self.tables(self.rows(), self.AXES)
        times = [one for one in summary if one["quantity"] == "sim_time_s"]
        self.assertEqual([(one[self.AXES[0]], one[self.AXES[1]]) for one in times],
                         [("2", "5"), ("2", "9"), ("4", "5"), ("4", "9"), ("6", "5"), ("6", "9")])
        self.assertEqual({one["n"] for one in times}, {"12"})
        self.assertEqual(list(times[0])[:4], ["mode", *self.AXES, "quantity"])

    def test_are_compared_with_their_first_level_where_all_others_are_equal(self) -> None:
        _, comparisons = self.tables(self.rows(), self.AXES)
        found = [(one["factor"], one["level"], one["reference"], one["where"]) for one in comparisons if one["quantity"] == "sim_time_s"]
        radius, count = self.AXES
        self.assertEqual(found, [(radius, "4", "2", f"{count}=5"), (radius, "4", "2", f"{count}=9"),
                                 (radius, "6", "2", f"{count}=5"), (radius, "6", "2", f"{count}=9"),
                                 (count, "9", "5", f"{radius}=2"), (count, "9", "5", f"{radius}=4"), (count, "9", "5", f"{radius}=6")])

    def test_are_corrected_for_all_comparisons_of_the_quantity(self) -> None:
        _, comparisons = self.tables(self.rows(), self.AXES)
        pair = self.one(comparisons, quantity="sim_time_s", level="6", where="robots.count=5")
        self.assertEqual((float(pair["difference"]), float(pair["p_value"])), (-40, 2 / 2**12))
        self.assertAlmostEqual(float(pair["p_holm"]), 7 * 2 / 2**12, 9)
        self.assertIn("corrected for the 7 comparisons", self.printed)

    def test_that_never_differ_one_at_a_time_are_not_compared(self) -> None:
        _, comparisons = self.tables([row("none", 1, 10.0, (str(i), str(i))) for i in range(8)], self.AXES)
        self.assertEqual(comparisons, [])


class BadInput(SweepTest):
    def refused(self, *parts: str, folder: pathlib.Path | None = None) -> None:
        before = {file: file.read_bytes() for file in self.folder.glob("*.csv")}
        ended = run(folder or self.folder)
        self.assertEqual((ended.returncode, ended.stdout, ended.stderr.count("\n")), (2, "", 1), ended.stderr)
        for part in ("caravan sweep: ", *parts):
            self.assertIn(part, ended.stderr)
        self.assertEqual(before, {file: file.read_bytes() for file in self.folder.glob("*.csv")})

    def damage(self, old: str, new: str) -> None:
        file = make_sweep(self.folder, [row("none", 1, 10), row("none", 2, 20)]) / "runs.csv"
        text = file.read_text()
        self.assertIn(old, text)
        file.write_text(text.replace(old, new, 1))

    def test_a_folder_that_is_no_sweep_is_refused(self) -> None:
        self.folder.mkdir()
        self.refused(str(self.folder), "it has no runs.csv")
        self.refused("it has no runs.csv", folder=self.folder / "missing")

    def test_a_file_in_place_of_a_folder_is_refused(self) -> None:
        self.refused("Not a directory", folder=make_sweep(self.folder, [row("none", 1, 1)]) / "runs.csv")

    def test_damaged_tables_are_refused_by_row_and_column(self) -> None:
        self.damage("20,1.5,0,1\n", "20,1.")
        self.refused("runs.csv: its last row is cut off")
        self.damage("20,1.5,0,1\n", "20\n")
        self.refused("runs.csv: row 3: 9 fields instead of 12")
        self.damage(",20,", ",twenty,")
        self.refused("row 3: sim_time_s 'twenty' is not a number")
        self.damage(",20,", ",nan,")
        self.refused("row 3: sim_time_s 'nan' is not a number")
        self.damage("none,2,", "none,x,")
        self.refused("row 3: seed 'x' is not a whole number")
        self.damage("none,2,", "none,1,")
        self.refused("row 3: the same settings and seed stand in an earlier row")
        self.damage("00,1,0,10", "00,2,0,10")
        self.refused("row 2: completed '2' is neither 0 nor 1")
        self.damage(",digest,", ",hash,")
        self.refused("column digest is missing")

    def test_empty_and_binary_tables_are_refused(self) -> None:
        file = make_sweep(self.folder, []) / "runs.csv"
        self.refused("has no run")
        file.write_bytes(b"")
        self.refused("its last row is cut off")
        file.write_bytes(b"\xff\xfe\x00\n")
        self.refused("is not text in UTF-8")

    def test_no_scipy_is_one_line_and_leaves_the_tables(self) -> None:
        make_sweep(self.folder, [row("none", 1, 1)])
        (self.folder / "summary.csv").write_text("mode,quantity\n")
        ended = run(self.folder, python=("-S",))  # without Debian's packages
        self.assertEqual((ended.returncode, ended.stderr.count("\n")), (2, 1), ended.stderr)
        self.assertIn("python3-scipy", ended.stderr)
        self.assertEqual((self.folder / "summary.csv").read_text(), "mode,quantity\n")
        self.assertFalse((self.folder / "comparisons.csv").exists())


if __name__ == "__main__":
    unittest.main()
