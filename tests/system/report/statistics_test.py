# SPDX-License-Identifier: Apache-2.0
"""The statistics of a real sweep, from `caravan sweep` to its files; without SciPy; interrupted."""

import argparse
import csv
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import unittest

TREE = pathlib.Path(__file__).resolve().parents[3]
PATIENCE_S = 600
FIRST = 8  # columns that the sweep writes itself
CARAVAN = ""


def rows(file: pathlib.Path) -> list[list[str]]:
    with open(file, newline="", encoding="utf-8") as stream:
        return list(csv.reader(stream))


class Statistics(unittest.TestCase):
    def setUp(self) -> None:
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.place = pathlib.Path(place.name)
        self.out = self.place / "out"

    def command(self, *more: str, seeds: str = "1-3") -> list[str]:
        return [CARAVAN, "sweep", str(TREE / "deploy/scenarios/small.toml"), "--seeds", seeds, "--modes", "none,full", "--max-time", "120",
                "--jobs", "2", "--out", str(self.out), *more]

    def sweep(self, *more: str, **environment: str) -> subprocess.CompletedProcess:
        return subprocess.run(self.command(*more), capture_output=True, text=True, timeout=PATIENCE_S, check=False,
                              env={**os.environ, **environment})

    def instead_of_scipy(self, text: str) -> str:
        """@return the PYTHONPATH with which Python finds this instead of SciPy"""
        (self.place / "hidden/scipy").mkdir(parents=True, exist_ok=True)
        (self.place / "hidden/scipy/__init__.py").write_text(text, encoding="utf-8")
        return str(self.place / "hidden")

    def test_are_written_when_the_sweep_ends_and_by_summarise(self) -> None:
        ended = self.sweep()
        self.assertEqual((ended.returncode, ended.stderr), (0, ""))
        self.assertIn("median (95 % interval)", ended.stdout)
        self.assertIn("mode full - none", ended.stdout)
        written = [(self.out / name).read_bytes() for name in ("summary.csv", "comparisons.csv")]
        compared = rows(self.out / "comparisons.csv")
        time_row = next(row for row in compared if row[0] == "sim_time_s")
        self.assertEqual(time_row[1:4] + time_row[5:6], ["mode", "full", "none", "3"])
        runs = {(row[1], row[2]): float(row[rows(self.out / "runs.csv")[0].index("sim_time_s")]) for row in rows(self.out / "runs.csv")[1:]}
        finished = {(row[1], row[2]): row[6] for row in rows(self.out / "runs.csv")[1:]}
        if set(finished.values()) == {"1"}:
            differences = sorted(runs["full", seed] - runs["none", seed] for seed in ("1", "2", "3"))
            self.assertAlmostEqual(float(time_row[9]), differences[1], 6)

        (self.out / "comparisons.csv").unlink()
        again = self.sweep("--summarise", "--quiet")
        self.assertEqual((again.returncode, again.stdout, again.stderr), (0, "", ""))
        self.assertEqual(written, [(self.out / name).read_bytes() for name in ("summary.csv", "comparisons.csv")])

        without = self.sweep("--summarise", "--quiet", PYTHONPATH=self.instead_of_scipy("raise ImportError('hidden')\n"))
        self.assertEqual((without.returncode, without.stderr.count("\n")), (0, 1), without.stderr)
        self.assertIn("python3-scipy", without.stderr)
        self.assertFalse((self.out / "comparisons.csv").exists())
        own = rows(self.out / "summary.csv")
        (self.out / "summary.csv").write_bytes(written[0])
        self.assertEqual(own, [row[:FIRST] for row in rows(self.out / "summary.csv")])

    def test_stop_with_the_sweep(self) -> None:
        self.assertEqual(self.sweep("--quiet").returncode, 0)
        slow = self.instead_of_scipy("import pathlib, os, time\n(pathlib.Path(__file__).parent / 'pid').write_text(str(os.getpid()))\n"
                                     "time.sleep(10000)\n")
        process = subprocess.Popen(self.command("--summarise"), env={**os.environ, "PYTHONPATH": slow}, stdout=subprocess.DEVNULL)
        pid_file = pathlib.Path(slow) / "scipy/pid"
        self.wait_until(lambda: pid_file.exists() and pid_file.read_text() != "")
        process.send_signal(signal.SIGINT)
        self.assertEqual(process.wait(PATIENCE_S), 130)
        self.assertFalse(pathlib.Path("/proc", pid_file.read_text()).exists())

    def test_of_fewer_runs_are_removed_when_more_are_interrupted(self) -> None:
        self.assertEqual(self.sweep("--quiet").returncode, 0)
        self.assertTrue((self.out / "comparisons.csv").exists())
        process = subprocess.Popen(self.command("--quiet", seeds="1-40"))
        self.wait_until(lambda: (self.out / "none/seed_4").exists())
        process.send_signal(signal.SIGINT)
        self.assertEqual(process.wait(PATIENCE_S), 130)
        self.assertFalse((self.out / "comparisons.csv").exists())

    def wait_until(self, there) -> None:
        deadline = time.monotonic() + PATIENCE_S
        while not there():
            self.assertLess(time.monotonic(), deadline)
            time.sleep(0.05)


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--caravan", required=True)
    arguments, rest = parser.parse_known_args()
    CARAVAN = arguments.caravan
    unittest.main(argv=[sys.argv[0], *rest])
