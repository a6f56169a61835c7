# SPDX-License-Identifier: Apache-2.0
"""A run of the embedded engine in this process."""

import contextvars
import json
import pathlib
import warnings

import numpy

from caravan import _engine
from caravan._interrupt import between_steps

EVENT = numpy.dtype([("time_s", float), ("robot", int), ("event", object), ("detail", object)])
TRACK = numpy.dtype([("time_s", float), ("robot", int), ("x_m", float), ("y_m", float), ("yaw_rad", float)])
_LARGEST = 2**63 - 1

making = contextvars.ContextVar("making")  # what makes the controllers while a run is made; for _given.py


class Run:
    """One run, stepped by the caller. The same scenario gives the digest of `caravan run`."""

    def __init__(self, scenario, controller=None):
        """`controller`: a class, or another callable, that makes a controller from (robot, parameters); without it the
        scenario says what drives the robots.

        Raises ScenarioError when the scenario or a controller refuses."""
        self.scenario = scenario
        if controller is None:
            self._run = _engine.Run(scenario.text, scenario.file, "", "")
        else:
            given = str(pathlib.Path(__file__).with_name("_given.py"))
            token = making.set(controller)
            try:
                self._run = _engine.Run(scenario.text, scenario.file, given, getattr(controller, "__name__", type(controller).__name__))
            finally:
                making.reset(token)
        self._is_warned = False

    def step(self, steps=1):
        """At most so many steps; fewer when the run ends. Returns how many.

        Ctrl-C raises KeyboardInterrupt after a step, and the run can go on. Raises RunError when a controller fails; then it cannot."""
        if steps < 0:
            raise ValueError(f"steps must be 0 or more, is {steps}")
        return self._go_on(steps, _LARGEST)

    def run(self, until_s=None):
        """To the end of the run, or to the first step at or after this simulated time. Otherwise like step()."""
        return self._go_on(_LARGEST, _LARGEST if until_s is None else min(round(until_s * 1e9), _LARGEST))

    def _go_on(self, steps, until_ns):
        done = 0
        with between_steps() as interrupts:
            while not interrupts and (part := self._run.go_on(steps - done, until_ns)):
                done += part
        if not self._is_warned and (complaint := self._run.complaint()):
            self._is_warned = True
            warnings.warn(complaint, RuntimeWarning, stacklevel=3)
        return done

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

    def events(self, first=0):
        """The rows of events.csv so far, from row `first` on: fields time_s, robot, event, detail."""
        return numpy.array(self._run.events(first), EVENT)

    def metrics(self):
        """The content of metrics.json so far, without `provenance`."""
        metrics = json.loads(self._run.metrics())
        del metrics["provenance"]
        return metrics
