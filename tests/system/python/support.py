# SPDX-License-Identifier: Apache-2.0
"""What the tests of the Python packages share."""

import os
import pathlib
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[3]
PROGRAM = pathlib.Path(os.environ["CARAVAN"])
SMALL = ROOT / "deploy/scenarios/small.toml"


def main():
    if os.environ.get("CARAVAN_SANITIZE"):
        print("skipped: the interpreter is not built with a sanitizer, which would have to be its first library")
        sys.exit(77)
    unittest.main(verbosity=2)
