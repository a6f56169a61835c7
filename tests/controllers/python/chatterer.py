# SPDX-License-Identifier: Apache-2.0
"""chatterer.cpp in Python: the same draws, the same decisions, the same run."""

from caravan_controller import Event, Frame, Outputs, Report


class Chatterer:
    def __init__(self, robot, parameters):
        self.random = robot.random()
        self.limit_mps = robot.body.wheel_limit_mps
        self.cruise_mps = parameters.number("cruise_mps", 0.4, low=0.0, high=1.0)
        self.turn = 0.0
        self.reported = False

    def step(self, inputs):
        for frame in inputs.heard:
            for byte in frame.bytes:
                self.turn += 0.001 * (byte - 127)
        ahead_m = min(inputs.sensors.sonar_range_m[2:6].tolist())
        self.turn = 0.4 if ahead_m < 0.8 else 0.95 * self.turn + self.random.uniform(-0.05, 0.05)
        speed_mps = 0.0 if ahead_m < 0.8 else self.cruise_mps
        outputs = Outputs(left_mps=max(-self.limit_mps, min(speed_mps - self.turn, self.limit_mps)),
                          right_mps=max(-self.limit_mps, min(speed_mps + self.turn, self.limit_mps)),
                          gripper_closed=True)
        outputs.frames.append(Frame(0, bytes([self.random.word() % 256])))
        if not self.reported:
            outputs.report = Report(events=[Event("began", f"turn={self.turn:f}")])
        self.reported = True
        return outputs
