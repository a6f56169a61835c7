# SPDX-License-Identifier: Apache-2.0
class Broken:
    def step(self, inputs:
        pass
