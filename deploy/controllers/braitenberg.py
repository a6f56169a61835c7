# SPDX-License-Identifier: Apache-2.0
"""braitenberg.cpp in Python: vehicle 3b of V. Braitenberg, "Vehicles: Experiments in Synthetic Psychology", MIT Press, 1984."""

from caravan_controller import Outputs


class Vehicle3b:
    def __init__(self, robot, parameters):
        self.cruise_mps = parameters.number("cruise_mps", 0.5, low=0.0, high=1.6)
        self.sight_m = parameters.number("sight_m", 1.5, low=0.1, high=5.0)

    def closeness(self, ranges_m):
        """0: nothing in sight, 1: something touches a sonar. A range that is not known (NaN) counts as nothing."""
        return 1.0 - min([self.sight_m, *ranges_m]) / self.sight_m

    def step(self, inputs):
        range_m = inputs.sensors.sonar_range_m.tolist()
        left, right = self.closeness(range_m[0:4]), self.closeness(range_m[4:8])
        return Outputs(left_mps=self.cruise_mps * (1.0 - 2.4 * right), right_mps=self.cruise_mps * (1.0 - 2.0 * left))
