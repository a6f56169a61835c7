# SPDX-License-Identifier: Apache-2.0
"""The project's own C++ files."""

import pathlib

ROOT = pathlib.Path(__file__).resolve().parents[2]
FOLDERS = ("runtime", "idl", "robot_agent", "world_server", "radio_emulator", "hardware_bridge", "experiment", "deploy", "tests")


def files_ending_in(*endings):
    return sorted(file for folder in FOLDERS for file in (ROOT / folder).rglob("*") if file.suffix in endings)
