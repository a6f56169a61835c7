# SPDX-License-Identifier: Apache-2.0
"""The report as files: every figure shows something, the page is self-contained, colours are distinguishable."""

import contextlib
import io
import pathlib
import re
import sys
import tempfile
import unittest
import xml.etree.ElementTree

import matplotlib.image
import numpy as np

TREE = pathlib.Path(__file__).resolve().parents[3]
sys.path[:0] = [str(TREE / "experiment/report"), str(TREE / "tests/support")]

import report  # noqa: E402
import style  # noqa: E402
from made_runs import make_run, robot  # noqa: E402
from made_sweeps import make_sweep, row  # noqa: E402
from page import page  # noqa: E402
from quantities import by_mode  # noqa: E402
from records import read_run  # noqa: E402

# Machado, Oliveira and Fernandes 2009: simulation of colour blindness, in linear RGB.
SEEN_BY = {
    "everybody": np.eye(3),
    "protanopes": np.array([[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216],
                            [-0.003882, -0.048116, 1.051998]]),
    "deuteranopes": np.array([[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413],
                              [-0.011820, 0.042940, 0.968881]]),
    "tritanopes": np.array([[1.255528, -0.076749, -0.178779], [-0.078411, 0.930809, 0.147602],
                            [0.004733, 0.691367, 0.303900]])}
TO_XYZ = np.array([[0.4124564, 0.3575761, 0.1804375], [0.2126729, 0.7151522, 0.0721750],
                   [0.0193339, 0.1191920, 0.9503041]])


def in_lab(colours: list[str], seen: np.ndarray) -> np.ndarray:
    """CIE L*a*b* of hexadecimal sRGB colours as somebody sees them."""
    rgb = np.array([[int(colour[i:i + 2], 16) / 255 for i in (1, 3, 5)] for colour in colours])
    linear = np.where(rgb <= 0.04045, rgb / 12.92, ((rgb + 0.055) / 1.055) ** 2.4)
    xyz = np.clip(linear @ seen.T, 0, 1) @ TO_XYZ.T / np.array([0.95047, 1.0, 1.08883])
    f = np.where(xyz > 0.008856, np.cbrt(xyz), 7.787 * xyz + 16 / 116)
    return np.stack([116 * f[:, 1] - 16, 500 * (f[:, 0] - f[:, 1]), 200 * (f[:, 1] - f[:, 2])], axis=-1)


def least_difference(colours: list[str], seen: np.ndarray) -> float:
    lab = in_lab(colours, seen)
    apart = np.linalg.norm(lab[:, None] - lab[None], axis=-1)
    return float(np.min(apart[~np.eye(len(colours), dtype=bool)]))


class Colours(unittest.TestCase):
    def test_colour_blind_people_can_tell_them_apart(self) -> None:
        # 2.3 is just noticeable side by side (Mahy, Van Eycken and Oosterlinck 1994); lines need far more.
        for who, seen in SEEN_BY.items():
            with self.subTest(who=who):
                self.assertGreater(least_difference(list(style.ROBOT_COLOURS), seen), 18)
                self.assertGreater(least_difference(list(style.MODE_COLOURS.values()), seen), 15)
                self.assertGreater(least_difference(list(style.ACTIVITY_COLOURS.values()), seen), 10)

    def test_no_robot_is_invisible_on_white(self) -> None:
        self.assertLess(np.max(in_lab(list(style.ROBOT_COLOURS), np.eye(3))[:, 0]), 82)

    def test_sixty_robots_look_different(self) -> None:
        looks = {(style.robot_colour(robot), str(style.robot_dash(robot))) for robot in range(1, 61)}
        self.assertEqual(len(looks), 60)


def write(out: pathlib.Path, *folders: pathlib.Path) -> tuple[int, str]:
    """The exit code and the standard error."""
    said = io.StringIO()
    with contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(said):
        code = report.write_report(list(folders), out)
    return code, said.getvalue()


class ReportOfASweep(unittest.TestCase):
    """Three modes of three runs, one of which is broken, and one run in which no robot had a path."""

    @classmethod
    def setUpClass(cls) -> None:
        held = tempfile.TemporaryDirectory()
        cls.addClassCleanup(held.cleanup)
        runs = pathlib.Path(held.name) / "runs"
        for mode in ("none", "partial", "full"):
            for seed in (1, 2, 3):
                make_run(runs / f"{mode}/seed_{seed}", mode, seed)
        make_run(runs / "none/seed_4", "none", 4, completed=False, items_delivered=0, per_robot=[robot(1), robot(2)])
        (runs / "full/seed_2/metrics.json").write_text("{")
        cls.out = pathlib.Path(held.name) / "out"
        cls.code, cls.said = write(cls.out, runs)
        cls.page = (cls.out / "report.html").read_text(encoding="utf-8")

    def test_has_every_figure_as_svg_and_png_and_none_is_empty(self) -> None:
        figures = self.out / "figures"
        self.assertEqual({file.stem for file in figures.glob("*.svg")}, set(report.ORDER))
        for name in report.ORDER:
            with self.subTest(name=name):
                root = xml.etree.ElementTree.parse(figures / f"{name}.svg").getroot()
                lines = root.findall(".//{http://www.w3.org/2000/svg}path")
                self.assertGreater(len(lines), 20)
                picture = matplotlib.image.imread(figures / f"{name}.png")
                coloured = np.ptp(picture[..., :3], axis=-1) > 0.15
                self.assertGreater(np.count_nonzero(coloured), 500, "nothing but black on white")
                self.assertIn(f'id="{name}"', self.page)

    def test_needs_nothing_else(self) -> None:
        loads = re.findall(r'(?:src|href)="(?!#|data:)[^"]*"|url\((?!#)|@import|<script', self.page)
        self.assertEqual(loads, [])

    def test_has_drawings_that_do_not_take_each_others_parts(self) -> None:
        drawings = [set(re.findall(r'\bid="([^"]+)"', drawing)) for drawing in self.page.split("<svg")[1:]]
        self.assertEqual(len(drawings), len(report.ORDER))
        self.assertEqual(len(set.union(*drawings)), sum(map(len, drawings)))

    def test_has_the_runs_that_did_not_deliver_everything(self) -> None:
        self.assertIn("4 (3)", self.page)
        self.assertIn("time limit reached", self.page)

    def test_names_the_broken_run_and_goes_on(self) -> None:
        self.assertEqual(self.code, 0)
        self.assertIn("full/seed_2: metrics.json is cut off", self.said)
        self.assertIn("full/seed_2: metrics.json is cut off", self.page)


class Reports(unittest.TestCase):
    def setUp(self) -> None:
        held = tempfile.TemporaryDirectory()
        self.addCleanup(held.cleanup)
        self.folder = pathlib.Path(held.name)

    def test_one_run_in_which_nobody_found_anything_has_a_report(self) -> None:
        run = make_run(self.folder / "run", "none", completed=False, items_delivered=0, per_robot=[robot(1), robot(2)],
                       exchanges={"completed": 0, "failed": 0, "mean_duration_s": 0.0}, routes=0)
        for name, columns in (("events.csv", "time_s,robot,event,detail"), ("paths.csv", "robot,index,x_m,y_m"),
                              ("trips.csv", "robot,trip,picked_up_s,delivered_s,next_pick_up_s"),
                              ("path_lengths.csv", "time_s,robot,length_m")):
            (run / name).write_text(columns + "\n")
        self.assertEqual(write(self.folder / "out", run)[0], 0)
        drawn = {file.stem for file in (self.folder / "out/figures").glob("*.png")}
        self.assertEqual(drawn, set(report.ORDER) - {"round_trips", "final_paths_all_runs"})

    def test_without_a_single_run_there_is_none(self) -> None:
        (self.folder / "empty").mkdir()
        code, said = write(self.folder / "out", self.folder / "empty")
        self.assertEqual(code, 1)
        self.assertIn("holds no run", said)
        self.assertFalse((self.folder / "out").exists())

    def test_a_sweep_has_its_statistics_and_figures_of_its_factors(self) -> None:
        axes = ("robots.count",)
        sweep = make_sweep(self.folder / "sweep", [row(mode, seed, None if seed > 4 else 10.0 * seed + len(mode) + int(count), (count,))
                                                   for mode in ("none", "full") for count in ("3", "5") for seed in range(1, 8)], axes)
        make_run(sweep / "none/seed_1", "none", 1)
        code, said = write(self.folder / "out", sweep)
        self.assertEqual((code, said.count("left out")), (0, 0), said)
        page_text = (self.folder / "out/report.html").read_text(encoding="utf-8")
        for part in ('id="statistics"', "p (Holm) is corrected for the 4 comparisons", "none robots.count=3", 'id="main_effects"',
                     'id="interactions"', ">47.0 (", "to unbounded)", "combine all settings of a mode", ">0.57 ("):
            self.assertTrue(part in page_text, part)
        for name in ("main_effects", "interactions"):
            picture = matplotlib.image.imread(self.folder / f"out/figures/{name}.png")
            self.assertGreater(np.count_nonzero(np.ptp(picture[..., :3], axis=-1) > 0.15), 500)

    def test_a_damaged_table_of_a_sweep_is_named_and_the_rest_is_drawn(self) -> None:
        make_run(self.folder / "sweep/none/seed_1", "none", 1)
        (self.folder / "sweep/runs.csv").write_text("index,mode\n")
        code, said = write(self.folder / "out", self.folder / "sweep")
        self.assertEqual(code, 0)
        self.assertIn("column seed is missing", said)
        self.assertIn("column seed is missing", (self.folder / "out/report.html").read_text(encoding="utf-8"))

    def test_the_same_runs_give_the_same_drawings(self) -> None:
        runs = by_mode([read_run(make_run(self.folder / "run"))])
        for name in ("final_paths", "items_over_time"):
            once = report.draw(report.PICTURES[name], runs, self.folder).read_bytes()
            self.assertEqual(report.draw(report.PICTURES[name], runs, self.folder).read_bytes(), once)

    def test_the_names_of_scenarios_cannot_break_the_page(self) -> None:
        runs = by_mode([read_run(make_run(self.folder / "run", scenario="<b>&"))])
        text = page(report.title_of(runs), runs, [], [])
        self.assertIn("&lt;b&gt;&amp;", text)
        self.assertNotIn("<b>", text)


if __name__ == "__main__":
    unittest.main()
