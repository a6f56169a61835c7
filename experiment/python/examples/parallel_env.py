# SPDX-License-Identifier: Apache-2.0
"""Caravan as a parallel multi-agent environment: for those who learn policies.

The functions and what they return are those of a parallel environment of PettingZoo (J. K. Terry et al., NeurIPS 2021),
which is not needed. One step of the environment is `repeat` steps of the run; all robots act at the same time.

    env = ForagingEnv(caravan.Scenario.load("deploy/scenarios/small.toml"))
    observations, infos = env.reset(seed=1)
    while env.agents:
        actions = {agent: policy(observations[agent]) for agent in env.agents}
        observations, rewards, terminations, truncations, infos = env.step(actions)"""

import math

import caravan
import numpy
from caravan_controller import Outputs

FRONT = 8  # sonars 0 to 7 look ahead and to both sides
REWARDS = {"pick_up": 1.0, "delivery": 10.0, "contact": -0.1}  # for a row of events.csv


class _Puppet:
    """A robot's controller that does what the environment tells it."""

    def __init__(self, robot):
        self.robot = robot
        self.inputs = None
        self.wheels_mps = (0.0, 0.0)

    def step(self, inputs):
        self.inputs = inputs
        left_mps, right_mps = self.wheels_mps
        return Outputs(left_mps=left_mps, right_mps=right_mps, gripper_closed=self.grips())

    def grips(self):
        """Closes at the source, opens at the destination."""
        sensors, destination = self.inputs.sensors, self.inputs.destination
        is_there = destination is not None and math.dist(sensors.position, destination) < 1.0
        is_at_source = math.dist(sensors.position, self.robot.source) < 0.8 * self.robot.service_radius_m
        return is_at_source or (sensors.holding and not is_there)


class ForagingEnv:
    """Robots carry items. An action is the speeds of both wheels in [-1, 1], an observation a vector of 16 numbers."""

    action_shape, observation_shape = (2,), (FRONT + 8,)

    def __init__(self, scenario, repeat=10):
        self.scenario = scenario
        self.repeat = repeat
        self.possible_agents = [f"robot_{k + 1}" for k in range(scenario.robots)]
        self.agents = []

    def reset(self, seed=None, options=None):
        """A new run. Returns observations and infos by agent. `options` are changes of the scenario."""
        changes = dict(options or {}) | ({} if seed is None else {"seed": seed})
        self.puppets = {}

        def puppet(robot, _):
            return self.puppets.setdefault(f"robot_{robot.id}", _Puppet(robot))

        self.run = caravan.Run(self.scenario.changed(changes), controller=puppet)
        self.agents = list(self.possible_agents)
        self.known_events = 0
        self.run.step()  # the robots stand, and sense
        return self._observations(), {agent: {} for agent in self.agents}

    def step(self, actions):
        """Returns observations, rewards, terminations, truncations and infos, each by agent."""
        for agent in self.agents:
            puppet = self.puppets[agent]
            limit_mps = puppet.robot.body.wheel_limit_mps
            puppet.wheels_mps = tuple(float(speed) * limit_mps for speed in numpy.clip(actions[agent], -1.0, 1.0))
        self.run.step(self.repeat)
        observations, rewards, infos = self._observations(), self._rewards(), {agent: {} for agent in self.agents}
        is_done = 0 < self.run.scenario.items <= self.run.items_delivered
        terminations = {agent: is_done for agent in self.agents}
        truncations = {agent: self.run.finished and not is_done for agent in self.agents}
        if self.run.finished:
            self.agents = []
        return observations, rewards, terminations, truncations, infos

    def _observations(self):
        return {agent: self._observation(self.puppets[agent]) for agent in self.agents}

    def _observation(self, puppet):
        """Of the last step of the run: sonars, position, heading, holding, and the destination while it is in sight."""
        sensors, destination = puppet.inputs.sensors, puppet.inputs.destination
        ranges = numpy.minimum(sensors.sonar_range_m[:FRONT] / puppet.robot.sonar_range_m, 1.0)
        seen = (0.0, 0.0, 0.0) if destination is None else (
            1.0, destination.x_m - sensors.position.x_m, destination.y_m - sensors.position.y_m)
        rest = [*sensors.position, math.cos(sensors.yaw_rad), math.sin(sensors.yaw_rad), float(sensors.holding), *seen]
        return numpy.concatenate([ranges, rest]).astype(numpy.float32)

    def _rewards(self):
        rewards = dict.fromkeys(self.agents, 0.0)
        events = self.run.events(self.known_events)
        for event in events:
            rewards[f"robot_{event['robot']}"] += REWARDS.get(event["event"], 0.0)
        self.known_events += len(events)
        return rewards
