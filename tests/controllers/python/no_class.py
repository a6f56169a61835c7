# SPDX-License-Identifier: Apache-2.0
"""Has nothing that drives."""


class Idle:
    pass
