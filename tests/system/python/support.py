# SPDX-License-Identifier: Apache-2.0
"""What the tests of the Python packages share."""

import os
import pathlib

PROGRAM = pathlib.Path(os.environ["CARAVAN"])
ROOT = pathlib.Path(__file__).resolve().parents[3]
SMALL = ROOT / "deploy/scenarios/small.toml"
