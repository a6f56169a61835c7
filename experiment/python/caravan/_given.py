# SPDX-License-Identifier: Apache-2.0
"""The controller of a run whose controllers are made by a class of its caller."""

import caravan.run


class Given:
    def __init__(self, robot, parameters):
        self.controller = caravan.run.given[parameters.integer("given", 0)](robot, parameters)

    def step(self, inputs):
        return self.controller.step(inputs)
