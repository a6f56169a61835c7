# SPDX-License-Identifier: Apache-2.0
"""Does not say which one drives."""


class Left:
    def step(self, inputs):
        pass


class Right(Left):
    pass


class _Base(Left):
    pass
