# SPDX-License-Identifier: Apache-2.0
"""A run of the embedded engine in this process."""

import itertools
import json
import pathlib

import numpy

from caravan import _engine

EVENT = numpy.dtype([("time_s", float), ("robot", int), ("event", object), ("detail", object)])
TRACK = numpy.dtype([("time_s", float), ("robot", int), ("x_m", float), ("y_m", float), ("yaw_rad", float)])

given = {}  # number -> what makes the controllers of a run; for _given.py
_numbers = itertools.count(1)


class Run:
    """One run, stepped by the caller. The same scenario gives the digest of `caravan run`."""

    def __init__(self, scenario, controller=None):
        """`controller`: a class, or another callable, that makes a controller from (robot, parameters); without it the
        scenario says what drives the robots.

        Raises ScenarioError when the scenario or a controller refuses."""
        if controller is not None:
            number = next(_numbers)
            given[number] = controller
            library = pathlib.Path(__file__).with_name("_given.py")
            scenario = scenario.changed({"controller.library": str(library), "controller.given": number})
        self.scenario = scenario
        self._run = _engine.Run(scenario.text, scenario.file)

    def step(self, steps=1):
        """At most so many steps; less when the run ends. Returns how many. Raises RunError when a controller fails."""
        return self._run.step(steps)

    def run(self, until_s=None):
        """To the end of the run, or until this simulated time. Python's lock is free meanwhile."""
        return self._run.run_until(2**63 - 1 if until_s is None else round(until_s * 1e9))

    @property
    def finished(self):
        return self._run.finished()

    @property
    def now_s(self):
        return self._run.now_ns() / 1e9

    @property
    def digest(self):
        return self._run.digest()

    @property
    def robots(self):
        return self._run.robots()

    @property
    def items_delivered(self):
        return self._run.items_delivered()

    def poses(self):
        """(robots, 3): x_m, y_m, yaw_rad of each robot now, in frame W; row 0 is robot 1."""
        return self._run.poses()

    def tracks(self):
        """The rows of tracks.csv so far, one for a robot and simulated second: fields time_s, robot, x_m, y_m, yaw_rad."""
        columns = self._run.tracks()
        rows = numpy.empty(len(columns), TRACK)
        for index, name in enumerate(TRACK.names):
            rows[name] = columns[:, index]
        return rows

    def events(self):
        """The rows of events.csv so far: fields time_s, robot, event, detail."""
        return numpy.array(self._run.events(), EVENT)

    def metrics(self):
        """The content of metrics.json so far."""
        return json.loads(self._run.metrics())
