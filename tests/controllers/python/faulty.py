# SPDX-License-Identifier: Apache-2.0
"""Breaks the rule that the scenario names, on robot 2."""

import sys

import numpy
from caravan_controller import Frame, Outputs, ParameterError, Position, Report


class Faulty:
    def __init__(self, robot, parameters):
        fault = parameters.text("fault", "none")
        self.fault = fault if robot.id == 2 else "none"
        self.at_step = parameters.integer("at_step", 3, low=1)
        self.steps = 0
        self.parameters = parameters
        if self.fault == "constructor":
            raise RuntimeError("no map")
        if self.fault == "parameter":
            raise ParameterError("fault", "must be another one")

    def step(self, inputs):
        self.steps += 1
        outputs = Outputs(left_mps=0.1, right_mps=0.1)
        return outputs if self.steps != self.at_step else getattr(self, self.fault)(inputs, outputs)

    def none(self, inputs, outputs):
        return outputs

    def throws(self, inputs, outputs):
        return {}["cell"]

    def throws_in_numpy(self, inputs, outputs):
        return numpy.linalg.inv(numpy.zeros((2, 2)))

    def writes_a_sonar(self, inputs, outputs):
        inputs.sensors.sonar_range_m[0] = 1.0
        return outputs

    def asks_late(self, inputs, outputs):
        return self.parameters.number("speed_mps", 0.1)

    def exits(self, inputs, outputs):
        sys.exit(0)

    def nan(self, inputs, outputs):
        outputs.left_mps = float("nan")
        return outputs

    def nothing(self, inputs, outputs):
        return None

    def word_for_a_speed(self, inputs, outputs):
        outputs.left_mps = "fast"
        return outputs

    def negative_channel(self, inputs, outputs):
        outputs.tuned_channel = -1
        return outputs

    def frame_of_text(self, inputs, outputs):
        outputs.frames.append(Frame(0, "hello"))
        return outputs

    def no_frame(self, inputs, outputs):
        outputs.frames.append(b"hello")
        return outputs

    def far_path(self, inputs, outputs):
        outputs.report = Report(path=[Position(float("inf"), 1.0)])
        return outputs

    def calls_wrongly(self, inputs, outputs):
        return self.parameters.number("speed_mps", "fast")

    def hangs(self, inputs, outputs):
        while True:
            pass
