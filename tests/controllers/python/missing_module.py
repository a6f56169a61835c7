# SPDX-License-Identifier: Apache-2.0
"""Needs a module that is not there."""

import no_such_module
