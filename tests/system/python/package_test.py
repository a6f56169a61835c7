# SPDX-License-Identifier: Apache-2.0
"""The package caravan: scenarios, embedded runs, runs over DDS."""

import os
import pathlib
import pickle
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest
from unittest import mock

import caravan
import numpy
import support
from caravan_controller import Event, Outputs, Report

SHORT = {"experiment.items": 0, "experiment.max_time_s": 20.0}
CHATTERER = support.ROOT / "tests/controllers/python/chatterer.py"


class Spinner:
    """A controller that a notebook would define."""

    def __init__(self, robot, parameters):
        self.robot = robot
        self.fails_at_s = parameters.number("fails_at_s", 1e9)

    def step(self, inputs):
        if inputs.now_s >= self.fails_at_s:
            raise LookupError("no way")
        news = Report(events=[Event("began", f"robot={self.robot.id}")]) if inputs.now_ns == 0 else None
        return Outputs(left_mps=-0.2, right_mps=0.2, report=news)


def press_ctrl_c(times):
    """Once the run looks out for it, and again each time that it has been noticed."""
    def press():
        is_noticed = signal.default_int_handler  # by then
        while signal.getsignal(signal.SIGINT) is is_noticed:
            time.sleep(0.01)
        for left in range(times, 0, -1):
            time.sleep(0.1)
            os.kill(os.getpid(), signal.SIGINT)
            while left > 1 and signal.getsignal(signal.SIGINT) is not is_noticed:
                time.sleep(0.01)
    threading.Thread(target=press).start()


class Scenarios(unittest.TestCase):
    def setUp(self):
        self.small = caravan.Scenario.load(support.SMALL)

    def test_keys_are_changed(self):
        changed = self.small.changed({"seed": numpy.int64(3), "radio.range_m": numpy.float64(2.5), "algorithm.mode": "none",
                                      "robots.source_m": numpy.array([-4.0, -4.0]),
                                      "world.cylinder": [{"centre_m": [2.0, -2.0], "radius_m": 0.5}]})
        self.assertEqual(changed.tables["seed"], 3)
        self.assertEqual(changed.tables["radio"]["range_m"], 2.5)
        self.assertEqual(changed.tables["robots"]["source_m"], [-4.0, -4.0])
        self.assertEqual(changed.tables["world"]["cylinder"], [{"centre_m": [2.0, -2.0], "radius_m": 0.5}])
        self.assertEqual(changed.tables["world"]["box"], self.small.tables["world"]["box"])
        self.assertEqual(self.small.tables["seed"], 1)

    def test_a_dict_changes_a_table_key_by_key(self):
        changed = self.small.changed({"experiment": {"items": 2}, "world": {"arena_m": (13, 13)}})
        self.assertEqual(changed.tables["experiment"], {"items": 2, "max_time_s": 3600.0})
        self.assertEqual(changed.tables["world"]["cylinder"], self.small.tables["world"]["cylinder"])
        self.assertEqual((changed.name, changed.robots, changed.items), ("small", 4, 2))

    def test_a_wrong_change_is_refused_with_the_line_of_the_program(self):
        with self.assertRaises(caravan.ScenarioError) as caught:
            self.small.changed({"robots.count": 0})
        said = subprocess.run([support.PROGRAM, "run", support.SMALL, "--set", "robots.count=0"], capture_output=True, text=True, check=False).stderr
        self.assertEqual(str(caught.exception) + "\n", said.replace("--set", "changed"))

    def test_a_file_that_is_not_there_is_refused_with_the_line_of_the_program(self):
        with self.assertRaises(caravan.ScenarioError) as caught:
            caravan.Scenario.load("no_such.toml")
        said = subprocess.run([support.PROGRAM, "check", "no_such.toml"], capture_output=True, text=True, check=False).stderr
        self.assertEqual(str(caught.exception) + "\n", said)

    def test_scenarios_can_be_sent_to_other_processes(self):
        self.assertEqual(pickle.loads(pickle.dumps(self.small)).text, self.small.text)

    def test_a_wrong_key_or_value_is_refused(self):
        for changes, reason in (({"radio.range": 3.0}, "^changed radio.range=3.0: unknown key$"),
                                ({"radio.range_m": -2}, "^changed radio.range_m=-2: must be "),
                                ({"radio.range_m": "far"}, '^changed radio.range_m="far": must be a number$'),
                                ({"radoi.range_m": 2.0}, "radoi"), ({"bridge.silence": 1.0}, "^changed bridge.silence=1.0: unknown key$"),
                                ({"seed.of_world": 2}, "^changed seed.of_world=2: "), ({"seed": 2**63}, "^changed seed=9223372036854775808: "),
                                ({"seed": None}, "^changed seed=None: must be a number"), ({"a key": 1}, "^changed a key=1: is not a key"),
                                ({"robots.source_m": [100.0, 0.0]}, "source")):
            with self.assertRaisesRegex(caravan.ScenarioError, reason):
                self.small.changed(changes)

    def test_a_file_with_an_error_is_refused_with_its_line(self):
        with self.assertRaisesRegex(caravan.ScenarioError, "^mine.toml:[0-9]+: radio.range_m: must be "):
            caravan.Scenario(self.small.text.replace("range_m = 2.0", "range_m = -2.0"), "mine.toml")


class EmbeddedRuns(unittest.TestCase):
    def setUp(self):
        self.small = caravan.Scenario.load(support.SMALL)
        self.short = self.small.changed(SHORT)

    def test_the_digest_is_that_of_the_program(self):
        run = caravan.Run(self.small)
        run.run()
        self.assertTrue(run.finished)
        self.assertEqual(run.digest, "11507217511ba8df")
        self.assertEqual(run.items_delivered, 4)
        metrics = run.metrics()
        self.assertEqual((metrics["digest"], metrics["completed"], metrics["scenario"]), (run.digest, True, "small"))
        self.assertEqual(numpy.count_nonzero(run.events()["event"] == "delivery"), 4)

    def test_steps_give_what_a_whole_run_gives(self):
        whole, stepped = caravan.Run(self.short), caravan.Run(self.short)
        whole.run()
        self.assertEqual(stepped.step(), 1)
        self.assertAlmostEqual(stepped.now_s, 0.032)
        stepped.run(until_s=10.0)
        self.assertFalse(stepped.finished)
        self.assertTrue(10.0 <= stepped.now_s < 10.05)
        while stepped.step(7) == 7:
            pass
        self.assertEqual(stepped.step(), 0)
        self.assertEqual(stepped.digest, whole.digest)
        numpy.testing.assert_array_equal(stepped.poses(), whole.poses())
        self.assertEqual(whole.poses().shape, (4, 3))
        tracks = whole.tracks()
        self.assertEqual(len(tracks), 4 * 21)
        self.assertEqual(set(tracks["robot"]), {1, 2, 3, 4})

    def test_a_class_of_the_caller_drives_the_robots(self):
        run = caravan.Run(self.short, controller=Spinner)
        began = run.poses()
        run.run()
        numpy.testing.assert_allclose(run.poses()[:, :2], began[:, :2], atol=0.2)
        self.assertEqual(list(run.events()["detail"][:4]), [f"robot={k}" for k in (1, 2, 3, 4)])

    def test_a_controller_that_fails_ends_the_run_with_its_line(self):
        run = caravan.Run(self.short.changed({"controller.fails_at_s": 1.0}), controller=Spinner)
        with self.assertRaisesRegex(caravan.RunError, r"robot 1, step 33 .*package_test.py:34: LookupError: no way"):
            run.run()
        self.assertIn("LookupError", run.metrics()["failure"])
        self.assertEqual(run.metrics()["controller"], "Spinner")
        with self.assertRaisesRegex(caravan.RunError, "controller Spinner, robot 1, step 33 .*no way"):
            run.step()

    def test_a_key_of_a_controller_is_strict_too(self):
        with self.assertRaisesRegex(caravan.ScenarioError, "controller.colour: unknown key"):
            caravan.Run(self.short.changed({"controller.colour": 1}), controller=Spinner)
        with self.assertRaisesRegex(caravan.ScenarioError, "controller.colour: unknown key"):
            caravan.Run(self.short.changed({"controller.colour": 1}))

    def test_a_missing_controller_is_refused(self):
        with self.assertRaisesRegex(caravan.ScenarioError, "controller .*/no_such.py: there is no such file"):
            caravan.Run(self.short.changed({"controller.library": pathlib.Path("no_such.py")}))

    def test_what_makes_no_controllers_is_refused(self):
        with self.assertRaisesRegex(caravan.ScenarioError, "robot 1: cannot be made: .*gives a int, which has no function step"):
            caravan.Run(self.short, controller=lambda robot, _: robot.id)

    def test_a_controller_cannot_look_at_its_own_run(self):
        class Curious:
            def __init__(self, *_):
                pass

            def step(self, _):
                return Outputs(left_mps=run.now_s)
        run = caravan.Run(self.short, controller=Curious)
        with self.assertRaisesRegex(caravan.RunError, "robot 1, step 1 .*RunError: this run is being stepped"):
            run.step()

    def test_ctrl_c_comes_between_two_steps(self):
        for controller in (None, Spinner):
            run = caravan.Run(self.small.changed({"experiment.items": 0, "experiment.max_time_s": 1e6}), controller=controller)
            press_ctrl_c(1)
            with self.assertRaises(KeyboardInterrupt):
                run.run()
            steps = round(run.now_s / 0.032)
            self.assertGreater(steps, 0)
            self.assertIs(signal.getsignal(signal.SIGINT), signal.default_int_handler)
            self.assertEqual(run.step(3), 3)
            again = caravan.Run(run.scenario, controller=controller)
            again.step(steps + 3)
            self.assertEqual(again.digest, run.digest)

    def test_a_second_ctrl_c_ends_a_controller_that_does_not_return(self):
        class Endless:
            def __init__(self, *_):
                pass

            def step(self, _):
                while True:
                    time.sleep(0.01)
        run = caravan.Run(self.short, controller=Endless)
        press_ctrl_c(2)
        with self.assertRaises(KeyboardInterrupt):
            run.run()
        self.assertIn("KeyboardInterrupt", run.metrics()["failure"])

    def test_other_threads_go_on_meanwhile(self):
        runs = [caravan.Run(self.short), caravan.Run(self.short)]
        threads = [threading.Thread(target=run.run) for run in runs]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(runs[0].digest, runs[1].digest)
        self.assertTrue(runs[0].finished)

    def test_python_s_lock_is_free_meanwhile(self):
        run = caravan.Run(self.small.changed({"experiment.items": 0, "experiment.max_time_s": 1e6}))
        counted = [0]
        ends = threading.Event()

        def count():
            while not ends.wait(0.001):
                counted[0] += 1
        thread = threading.Thread(target=count)
        thread.start()
        most, end = 0, time.monotonic() + 60
        try:
            while most < 3 and time.monotonic() < end:
                before = counted[0]
                run._run.go_on(10**6, 2**62)  # pylint: disable=protected-access
                most = max(most, counted[0] - before)
        finally:
            ends.set()
            thread.join()
        self.assertGreaterEqual(most, 3, "another thread goes on during one call")


class RunsOverDds(unittest.TestCase):
    def test_give_the_digest_and_the_records_of_the_embedded_engine(self):
        scenario = caravan.Scenario.load(support.SMALL).changed({**SHORT, "controller.library": str(CHATTERER)})
        run = caravan.Run(scenario)
        run.run()
        with tempfile.TemporaryDirectory() as folder:
            records = caravan.run_over_dds(scenario, pathlib.Path(folder) / "run", ["--agents-per-process", "4"])
            self.assertEqual(records.digest, run.digest)
            self.assertEqual(records.metrics()["controller"], "chatterer")
            tracks = records.tracks()
            self.assertEqual(len(tracks), len(run.tracks()))
            numpy.testing.assert_allclose(tracks["x_m"], run.tracks()["x_m"], atol=1e-4)
            self.assertEqual(list(records.events()["event"]), list(run.events()["event"]))
            self.assertEqual(len(records.trips()), numpy.count_nonzero(run.events()["event"] == "pick_up"))
            with self.assertRaisesRegex(caravan.ScenarioError, "run: is not empty"):
                caravan.run_over_dds(scenario, pathlib.Path(folder) / "run")


class Frames(unittest.TestCase):
    def test_rows_become_frames_of_pandas(self):
        run = caravan.Run(caravan.Scenario.load(support.SMALL).changed(SHORT))
        run.run()
        self.assertEqual(list(caravan.to_frame(run.tracks()).columns), ["time_s", "robot", "x_m", "y_m", "yaw_rad"])

    def test_without_pandas_the_reason_is_said(self):
        with mock.patch.dict(sys.modules, {"pandas": None}), self.assertRaisesRegex(ImportError, "python3-pandas"):
            caravan.to_frame([])


if __name__ == "__main__":
    unittest.main(verbosity=2)
