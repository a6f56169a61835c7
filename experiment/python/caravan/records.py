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

_PROGRAM = pathlib.Path(__file__).resolve().parents[4] / "bin/caravan"
_TRIP = numpy.dtype([("robot", int), ("trip", int), ("picked_up_s", float), ("delivered_s", float), ("next_pick_up_s", float)])
_REFUSED = 2  # exit code: nothing has begun
_LONGEST_STOP_S = 10


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
        return self._rows("trips.csv", _TRIP)

    def _rows(self, name, kind):
        def value(text, field):
            return text if kind[field] == object else kind[field].type(text or "nan")
        with open(self.folder / name, newline="", encoding="utf-8") as file:
            return numpy.array([tuple(value(row[field], field) for field in kind.names) for row in csv.DictReader(file)], kind)


def run_over_dds(scenario, folder, options=()):
    """Runs the scenario as processes on DDS, by `caravan run`, and returns its records when the run is over.

    `folder` must be new or empty. `options` are those of `caravan run`, such as ["--agents-per-process", "15"]. Ctrl-C stops the
    processes. Raises ScenarioError when the run does not start, RunError when it fails."""
    with tempfile.TemporaryDirectory(prefix="caravan_") as scratch:
        file = pathlib.Path(scratch) / "scenario.toml"
        file.write_text(scenario.changed({"name": scenario.name}).text, encoding="utf-8")
        command = [_PROGRAM, "run", file, "--engine", "dds", "--quiet", "--out", folder, *options]
        code, said = _call([str(word) for word in command])
    if code == _REFUSED:
        raise ScenarioError(said)
    records = Records(folder)
    if code != 0:
        metrics = records.metrics() if (records.folder / "metrics.json").is_file() else {"failure": said}
        if metrics["failure"] or metrics["interrupted"]:
            raise RunError(metrics["failure"] or "the run was stopped by a signal")
    return records


def _call(command):
    """The exit code, and the last line on standard error."""
    with subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, stdin=subprocess.DEVNULL, text=True) as process:
        try:
            said = process.communicate()[1]
        except BaseException:
            process.terminate()
            try:
                process.communicate(timeout=_LONGEST_STOP_S)
            except subprocess.TimeoutExpired:
                process.kill()
            raise
    lines = said.strip().splitlines()
    return process.returncode, lines[-1] if lines else f"{' '.join(command)}: exit code {process.returncode}"


def to_frame(rows):
    """A pandas frame of what tracks(), events() or trips() gave. Raises ImportError without pandas."""
    try:
        import pandas  # pylint: disable=import-outside-toplevel
    except ImportError as error:
        raise ImportError("to_frame() needs pandas: apt-get install python3-pandas. The rows are NumPy arrays already.") from error
    return pandas.DataFrame(rows)
