# SPDX-License-Identifier: Apache-2.0
"""The example of an environment for learners."""

import math
import unittest

import caravan
import numpy
import parallel_env
import support

AGENTS = ["robot_1", "robot_2", "robot_3", "robot_4"]


def towards_the_source(observation):
    """Drives to the source of small.toml at (-4.5, -4.5)."""
    x_m, y_m, cosine, sine = observation[8:12]
    error = math.remainder(math.atan2(-4.5 - y_m, -4.5 - x_m) - math.atan2(sine, cosine), 2 * math.pi)
    turn, speed = max(-0.2, min(0.3 * error, 0.2)), 0.2 * max(0.0, math.cos(error))
    return numpy.array([speed - turn, speed + turn])


class Environment(unittest.TestCase):
    def setUp(self):
        self.env = parallel_env.ForagingEnv(caravan.Scenario.load(support.SMALL))

    def test_observations_and_rewards_are_by_robot(self):
        observations, infos = self.env.reset(seed=1)
        self.assertEqual(list(observations), AGENTS)
        self.assertEqual(infos, {agent: {} for agent in AGENTS})
        total = dict.fromkeys(AGENTS, 0.0)
        for _ in range(60):
            observations, rewards, terminations, truncations, _ = self.env.step(
                {agent: towards_the_source(observations[agent]) for agent in self.env.agents})
            for agent in AGENTS:
                total[agent] += rewards[agent]
        for agent in AGENTS:
            self.assertEqual(observations[agent].shape, self.env.observation_shape)
            self.assertTrue(numpy.isfinite(observations[agent]).all())
            self.assertGreater(total[agent], 0.5, f"{agent} has picked up an item")
            self.assertEqual(observations[agent][12], 1.0, f"{agent} holds it")
        self.assertFalse(any(terminations.values()) or any(truncations.values()))

    def test_an_episode_ends_when_time_is_up(self):
        observations, _ = self.env.reset(seed=1, options={"experiment.max_time_s": 1.0})
        steps = 0
        while self.env.agents:
            observations, _, terminations, truncations, _ = self.env.step(dict.fromkeys(AGENTS, numpy.zeros(2)))
            steps += 1
        self.assertEqual(steps, 4)
        self.assertTrue(all(truncations.values()))
        self.assertFalse(any(terminations.values()))

    def test_a_reset_repeats_a_seed(self):
        def episode(seed):
            self.env.reset(seed=seed)
            return [self.env.step(dict.fromkeys(AGENTS, numpy.array([0.3, 0.1])))[0]["robot_2"] for _ in range(5)]
        first, again, other = episode(1), episode(1), episode(2)
        numpy.testing.assert_array_equal(first, again)
        self.assertFalse(numpy.array_equal(first, other))


if __name__ == "__main__":
    unittest.main(verbosity=2)
