# SPDX-License-Identifier: Apache-2.0
"""Runs that `caravan run` has recorded, and runs over DDS, which are its processes."""

import csv
import json
import pathlib
import subprocess
import tempfile

import numpy

from caravan._engine import RunError, ScenarioError
from caravan.run import EVENT, TRACK

PROGRAM = pathlib.Path(__file__).resolve().parents[4] / "bin/caravan"
TRIP = numpy.dtype([("robot", int), ("trip", int), ("picked_up_s", float), ("delivered_s", float), ("next_pick_up_s", float)])


class Records:
    """The folder of a run (docs/outputs.md)."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)

    def metrics(self):
        return json.loads((self.folder / "metrics.json").read_text(encoding="utf-8"))

    @property
    def digest(self):
        return self.metrics()["digest"]

    def tracks(self):
        return self._rows("tracks.csv", TRACK)

    def events(self):
        return self._rows("events.csv", EVENT)

    def trips(self):
        """A time that has not come is NaN."""
        return self._rows("trips.csv", TRIP)

    def _rows(self, name, kind):
        def value(text, field):
            return text if kind[field] == object else kind[field].type(text or "nan")
        with open(self.folder / name, newline="", encoding="utf-8") as file:
            return numpy.array([tuple(value(row[field], field) for field in kind.names) for row in csv.DictReader(file)], kind)


def run_over_dds(scenario, folder, options=()):
    """Runs the scenario as processes on DDS, by `caravan run`, and returns its records.

    `folder` must not exist yet. `options` are those of `caravan run`, such as ["--agents-per-process", "15"].
    Raises ScenarioError when it does not start, RunError when it fails."""
    with tempfile.TemporaryDirectory() as scratch:
        file = pathlib.Path(scratch) / "scenario.toml"
        file.write_text(scenario.changed({}).text, encoding="utf-8")
        line = [PROGRAM, "run", file, "--engine", "dds", "--quiet", "--out", folder, *options]
        done = subprocess.run(line, check=False, capture_output=True, text=True)
    if done.returncode not in (0, 1) or not (pathlib.Path(folder) / "metrics.json").exists():
        raise ScenarioError(done.stderr.strip() or f"caravan run: exit code {done.returncode}")
    if done.returncode == 1 and json.loads((pathlib.Path(folder) / "metrics.json").read_text())["failure"]:
        raise RunError(done.stderr.strip())
    return Records(folder)


def to_frame(rows):
    """A pandas frame of what tracks(), events() or trips() gave. Needs pandas (python3-pandas)."""
    import pandas  # pylint: disable=import-outside-toplevel
    return pandas.DataFrame(rows)
