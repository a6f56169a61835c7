# SPDX-License-Identifier: Apache-2.0
"""Says what it was given, and keeps what it was given first."""

import numpy
from caravan_controller import Activity, Event, Exchange, Frame, Mode, Origin, Outputs, Position, Report


class Values:
    def __init__(self, robot, parameters):
        self.robot = robot
        self.first = None
        self.weights = parameters.numbers("weights", [1.0, 2.0], low=0.0)
        self.is_on = parameters.flag("is_on", False)

    def step(self, inputs):
        sonars = inputs.sensors.sonar_range_m
        assert isinstance(sonars, numpy.ndarray) and sonars.shape == (16,) and not sonars.flags.owndata
        self.first = sonars if self.first is None else self.first
        robot, sensors = self.robot, inputs.sensors
        said = [robot.id, robot.seed, robot.body.track_m, robot.sonar_mounts[3].heading_rad, robot.sonar_range_m,
                robot.radio.mtu_bytes, robot.radio.channel_count, robot.source.x_m, robot.service_radius_m,
                inputs.now_ns, inputs.now_s, sonars[0], sensors.sonar_age_s[15], sensors.position.x_m, sensors.position.y_m,
                sensors.yaw_rad, sensors.left_wheel_rad, sensors.right_wheel_rad, sensors.holding, inputs.destination,
                [(frame.channel, frame.bytes, frame.signal_strength_dbm) for frame in inputs.heard], self.weights, self.is_on]
        return Outputs(left_mps=self.first[0], right_mps=numpy.float32(0.5), gripper_closed=numpy.bool_(True),
                       tuned_channel=numpy.int64(3), frames=[Frame(1, bytes([0, 255]))],
                       report=Report(mode=Mode.TRANSPORT, activity=Activity.AVOIDING, origin=Origin.FOUND,
                                     towards_destination=True, trips=2, malformed_frames=7, path=[Position(1.0, 2.0)],
                                     exchanges=[Exchange(partner=4, completed=True, began_ns=5, ended_ns=6)],
                                     events=[Event("said", repr(said))]))
