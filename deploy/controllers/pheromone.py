# SPDX-License-Identifier: Apache-2.0
"""Foraging by virtual pheromone: robots mark where they drive with the length of their way to the source and to the
destination, tell each other these marks by radio, and descend them. docs/pheromone.md explains it and names the literature."""

import math
import struct

from caravan_controller import Frame, Mode, Origin, Outputs, Report

CELL_M = 0.5
SOURCE, DESTINATION = 0, 1  # the two pheromones
MARK = struct.Struct("<BhhHH")  # pheromone, cell x, cell y, way in decimetres, age in seconds
HEADER = b"VP"
SAY_EVERY_S = 0.5
CHOOSE_EVERY_S = 0.3


class Pheromone:
    """Marks of one kind: cell -> (length of the way from it, when it was laid). A mark evaporates after its lifetime."""

    def __init__(self, lifetime_s):
        self.lifetime_s = lifetime_s
        self.marks = {}

    def lay(self, cell, way_m, laid_s):
        old = self.marks.get(cell)
        if old is None or way_m < old[0]:
            self.marks[cell] = (way_m, laid_s)
        elif way_m < old[0] + CELL_M and laid_s > old[1]:
            self.marks[cell] = (old[0], laid_s)  # confirmed

    def evaporate(self, now_s):
        for cell in [cell for cell, (_, laid_s) in self.marks.items() if now_s - laid_s > self.lifetime_s]:
            del self.marks[cell]

    def best(self, position):
        """The middle of the cell through which the way is shortest, as far as it is known; a detour to it counts twice."""
        best, least_m = None, math.inf
        for (i, j), (way_m, _) in self.marks.items():
            x_m, y_m = i * CELL_M, j * CELL_M
            away_m = math.hypot(x_m - position.x_m, y_m - position.y_m)
            total_m = way_m + (away_m if away_m < 3 * CELL_M else 2 * away_m)
            if away_m > 0.8 * CELL_M and total_m < least_m:
                best, least_m = (x_m, y_m), total_m
        return best


class Forager:
    def __init__(self, robot, parameters):
        self.robot = robot
        self.random = robot.random()
        self.cruise_mps = parameters.number("cruise_mps", 0.5, low=0.05, high=1.6)
        lifetime_s = parameters.number("lifetime_s", 600.0, low=1.0, high=65535.0)
        self.pheromones = [Pheromone(lifetime_s), Pheromone(lifetime_s)]
        self.ahead = [k for k, mount in enumerate(robot.sonar_mounts) if abs(mount.heading_rad) < math.radians(60)]
        self.last = None  # position in the last step
        self.driven_m = 0.0
        self.since_m = [math.inf, math.inf]  # odometer at the source and at the destination; inf: not there yet
        self.walk = []  # (cell, odometer) since the last of the two
        self.target = None
        self.choose_at_s = self.say_at_s = self.wander_until_s = self.escape_until_s = 0.0
        self.escape_side = self.last_side = 0.0  # +1: turning left, away from something; 0: not escaping, not yet
        self.wander_rad = self.random.uniform(-math.pi, math.pi)
        self.said = 0  # marks told so far
        self.origin, self.trips, self.was_holding, self.reported = Origin.NONE, 0, False, None

    def step(self, inputs):
        now_s, position = inputs.now_s, inputs.sensors.position
        self.listen(inputs.heard, now_s)
        if math.isnan(position.x_m) or math.isnan(inputs.sensors.yaw_rad):
            return Outputs(gripper_closed=inputs.sensors.holding)
        holding = inputs.sensors.holding
        at_source = self.is_near(position, self.robot.source, 0.8 * self.robot.service_radius_m)
        at_destination = inputs.destination is not None and self.is_near(position, inputs.destination, 1.0)
        self.mark(position, now_s, at_source, at_destination)
        self.trips += holding and not self.was_holding
        self.was_holding = holding
        if now_s >= self.choose_at_s:
            self.choose_at_s = now_s + CHOOSE_EVERY_S
            self.target = self.choose(position, now_s, holding, inputs.destination)
        left_mps, right_mps = self.drive(inputs.sensors, now_s)
        return Outputs(left_mps=left_mps, right_mps=right_mps, gripper_closed=at_source or (holding and not at_destination),
                       frames=self.say(now_s), report=self.news(holding))

    @staticmethod
    def is_near(position, place, radius_m):
        return math.hypot(position.x_m - place.x_m, position.y_m - place.y_m) < radius_m

    def mark(self, position, now_s, at_source, at_destination):
        """Lays marks on the way from both places, and on the way just driven towards the one that is reached."""
        if self.last is not None:
            self.driven_m += math.hypot(position.x_m - self.last.x_m, position.y_m - self.last.y_m)
        self.last = position
        cell = (round(position.x_m / CELL_M), round(position.y_m / CELL_M))
        for kind, is_there in ((SOURCE, at_source), (DESTINATION, at_destination)):
            if is_there:
                for passed, odometer_m in self.walk:
                    self.pheromones[kind].lay(passed, self.driven_m - odometer_m, now_s)
                self.walk = []
                self.since_m[kind] = self.driven_m
                if kind == DESTINATION and self.origin == Origin.NONE:
                    self.origin = Origin.FOUND
        if not self.walk or self.walk[-1][0] != cell:
            self.walk.append((cell, self.driven_m))
            for pheromone, since_m in zip(self.pheromones, self.since_m):
                if since_m < math.inf:
                    pheromone.lay(cell, self.driven_m - since_m, now_s)

    def listen(self, heard, now_s):
        for frame in heard:
            marks = frame.bytes[len(HEADER):]
            if not frame.bytes.startswith(HEADER) or len(marks) % MARK.size != 0:
                continue
            for kind, i, j, way_dm, age_s in MARK.iter_unpack(marks):
                if kind in (SOURCE, DESTINATION):
                    self.pheromones[kind].lay((i, j), way_dm / 10, now_s - age_s)
                    if kind == DESTINATION and self.origin == Origin.NONE:
                        self.origin = Origin.RECEIVED

    def say(self, now_s):
        """Twice a second as many marks as fit into a frame; all of them in turns."""
        if now_s < self.say_at_s:
            return []
        self.say_at_s = now_s + SAY_EVERY_S
        marks = [(kind, cell, mark) for kind in (SOURCE, DESTINATION) for cell, mark in self.pheromones[kind].marks.items()]
        most = min(len(marks), (self.robot.radio.mtu_bytes - len(HEADER)) // MARK.size)
        told = [marks[(self.said + k) % len(marks)] for k in range(most)]
        self.said += most
        return [Frame(0, HEADER + b"".join(
            MARK.pack(kind, i, j, min(65535, round(way_m * 10)), max(0, math.ceil(now_s - laid_s)))
            for kind, (i, j), (way_m, laid_s) in told))] if told else []

    def choose(self, position, now_s, holding, destination):
        """Where to drive: a place in frame W, or None to wander."""
        if holding and destination is not None:
            return destination
        for pheromone in self.pheromones:
            pheromone.evaporate(now_s)
        best = self.pheromones[DESTINATION if holding else SOURCE].best(position)
        if best is None and not holding:
            return self.robot.source  # its coordinates are known, the way there is not
        if not holding and self.is_near(position, self.robot.source, 2.0):
            return self.robot.source
        return best

    def drive(self, sensors, now_s):
        range_m = sensors.sonar_range_m
        nearest_m = min((range_m[k] for k in self.ahead if not math.isnan(range_m[k])), default=math.inf)
        if self.escape_side == 0.0 and nearest_m < 0.4:
            left_m, right_m = (sum(min(range_m[k], 3.0) for k in ks) for ks in ((1, 2, 3), (4, 5, 6)))
            # Turning to the other side each time would end in a corner.
            keeps = now_s < self.escape_until_s + 3.0 and self.last_side != 0.0
            self.escape_side = self.last_side if keeps else (1.0 if left_m > right_m else -1.0)
        if self.escape_side != 0.0:
            self.last_side = self.escape_side
            if nearest_m < 0.7:
                turn_mps = 0.3 * self.escape_side
                return -turn_mps, turn_mps
            self.escape_side = 0.0
            self.escape_until_s = now_s + self.random.uniform(0.5, 2.0)  # straight on, past the obstacle
            self.wander_rad = sensors.yaw_rad
        if now_s < self.escape_until_s:
            heading_rad = sensors.yaw_rad
        elif self.target is not None:
            heading_rad = math.atan2(self.target[1] - self.last.y_m, self.target[0] - self.last.x_m)
        else:
            if now_s >= self.wander_until_s:
                self.wander_until_s = now_s + self.random.uniform(4.0, 12.0)
                self.wander_rad += self.random.uniform(-1.0, 1.0)
            heading_rad = self.wander_rad
        error_rad = math.remainder(heading_rad - sensors.yaw_rad, 2 * math.pi)
        speed_mps = self.cruise_mps * max(0.0, math.cos(error_rad)) * min(1.0, nearest_m)
        turn_mps = max(-0.4, min(0.5 * error_rad, 0.4))
        return speed_mps - turn_mps, speed_mps + turn_mps
    def news(self, holding):
        """The report, when something in it has changed."""
        state = (self.origin, self.trips, holding)
        if state == self.reported:
            return None
        self.reported = state
        return Report(mode=Mode.EXPLORE if self.origin == Origin.NONE else Mode.TRANSPORT, origin=self.origin, trips=self.trips,
                      towards_destination=holding)
