# SPDX-License-Identifier: Apache-2.0
"""Counts its steps in globals, its own and those of a module beside it, which no controller should."""

import tally
from caravan_controller import Outputs

STEPS = 0


class Counter:
    def __init__(self, robot, parameters):
        pass

    def step(self, inputs):
        global STEPS
        STEPS += 1
        tally.STEPS.append(inputs.now_ns)
        return Outputs(left_mps=STEPS, right_mps=len(tally.STEPS))
