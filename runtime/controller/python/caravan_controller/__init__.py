# SPDX-License-Identifier: Apache-2.0
"""What a controller in Python is given in each step, and what it decides.

A controller is a class with two functions:

    from caravan_controller import Outputs

    class Spinner:
        def __init__(self, robot, parameters):
            self.speed_mps = parameters.number("speed_mps", 0.2, low=0.0, high=robot.body.wheel_limit_mps)

        def step(self, inputs):
            return Outputs(left_mps=-self.speed_mps, right_mps=self.speed_mps)

Units are in the names. Frame W is the world: x east, y north. Frame B is the robot: on the floor below the middle of the
axle, x forward, y left. The types are those of the C++ headers (`caravan/controller.hpp`)."""

from __future__ import annotations

import enum
from dataclasses import dataclass, field
from typing import NamedTuple

from caravan_controller._host import Parameters, Random

__all__ = ["Activity", "Body", "Event", "Exchange", "Frame", "Inputs", "Mode", "Origin", "Outputs", "ParameterError",
           "Parameters", "Position", "Radio", "Random", "ReceivedFrame", "Report", "Robot", "SonarMount", "Sensors"]


class ParameterError(ValueError):
    """A key of the table `[controller]` has a value that the controller cannot use. The program adds file and line."""

    def __init__(self, key: str, reason: str):
        super().__init__(f"{key}: {reason}")
        self.key = key
        self.reason = reason


class Position(NamedTuple):
    """In frame W."""

    x_m: float
    y_m: float


class SonarMount(NamedTuple):
    """Where a sonar sits and looks, in frame B."""

    x_m: float
    y_m: float
    heading_rad: float


@dataclass(slots=True)
class Body:
    """The robot's outline on the floor, a rectangle, and its wheels."""

    length_m: float
    ahead_m: float  # from the axle to the front
    width_m: float
    track_m: float  # between the wheels
    wheel_radius_m: float
    wheel_limit_mps: float  # rim speed; faster commands are clamped


@dataclass(slots=True)
class Radio:
    """The limits of the robot's radio."""

    channel_count: int
    mtu_bytes: int


@dataclass(slots=True)
class Robot:
    """What a controller is told of its robot before the first step. There is nothing about other robots or the world."""

    id: int  # from 1
    seed: int  # of the run
    body: Body
    sonar_mounts: list[SonarMount]
    sonar_aperture_rad: float  # full cone of each
    sonar_range_m: float
    radio: Radio
    source: Position  # where items are picked up
    service_radius_m: float  # a gripper picks up and delivers within it

    def random(self, stream: int = 0) -> Random:
        """A stream of random numbers of this run and robot: that of the C++ interface. Different streams are independent."""
        return Random.of_robot(self.seed, self.id, stream)


@dataclass(slots=True)
class Sensors:
    """What the robot measures. A number that is not known now is NaN."""

    sonar_range_m: object  # numpy array, read-only, from the face of each sonar; +inf: no echo
    sonar_age_s: object  # numpy array, read-only: how old each range is
    position: Position  # of B in W, by GPS
    yaw_rad: float  # by compass: counter-clockwise from east, in (-pi, pi]
    left_wheel_rad: float  # wheel angles since the start, forward positive
    right_wheel_rad: float
    holding: bool  # an item is in the gripper


@dataclass(slots=True)
class ReceivedFrame:
    """A frame that the radio has received. It does not say who sent it; its bytes may claim so."""

    channel: int
    bytes: bytes
    signal_strength_dbm: float = float("nan")  # NaN: the radio does not say


@dataclass(slots=True)
class Inputs:
    """What one step is given. `destination` is where the destination is, while the robot sees it; otherwise None."""

    now_ns: int  # simulated time since the run began
    sensors: Sensors
    heard: list[ReceivedFrame]  # since the last step, in the order of arrival
    destination: Position | None = None

    @property
    def now_s(self) -> float:
        return self.now_ns / 1e9


@dataclass(slots=True)
class Frame:
    """A frame to send, of at most Radio.mtu_bytes."""

    channel: int
    bytes: bytes


@dataclass(slots=True)
class Event:
    """Something worth a line in the run's list of events."""

    name: str  # in lower_snake_case
    detail: str = ""  # key=value pairs


@dataclass(slots=True)
class Exchange:
    """One attempt to exchange paths with another robot."""

    partner: int
    session: int = 0  # number that the partners agreed on; 0: none
    primary: bool = False  # this robot asked for it
    completed: bool = False
    began_ns: int = 0
    ended_ns: int = 0


class Mode(enum.IntEnum):
    """Does the robot know a path?"""

    EXPLORE = 0
    TRANSPORT = 1


class Activity(enum.IntEnum):
    IDLE = 0
    DRIVING = 1
    AVOIDING = 2
    EXCHANGING = 3


class Origin(enum.IntEnum):
    """Where a robot's first path came from."""

    NONE = 0
    FOUND = 1
    RECEIVED = 2


@dataclass(slots=True)
class Report:
    """What a controller says of itself. Observers, metrics and records get it; the run does not depend on it."""

    mode: Mode = Mode.EXPLORE
    activity: Activity = Activity.DRIVING
    origin: Origin = Origin.NONE
    towards_destination: bool = False  # direction of travel along the path
    trips: int = 0  # pick-ups so far
    malformed_frames: int = 0  # heard so far that were not of its protocol
    path: list[Position] | None = None  # from the source to the destination; None: as in the report before
    exchanges: list[Exchange] = field(default_factory=list)  # ended in this step
    events: list[Event] = field(default_factory=list)  # of this step


@dataclass(slots=True)
class Outputs:
    """What one step decides."""

    left_mps: float = 0.0  # rim speed of each driven wheel, forward positive
    right_mps: float = 0.0
    gripper_closed: bool = False
    tuned_channel: int = 0  # the radio listens on it from now; 0 is common to all
    frames: list[Frame] = field(default_factory=list)  # sent now, in order
    report: Report | None = None  # when something in it has changed
