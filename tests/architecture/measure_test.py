#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""measure.py counts the files that docs/architecture.md names, and ends without a message when its reader has left."""

import os
import pathlib
import subprocess
import sys
import unittest

import measure

HERE = pathlib.Path(__file__).resolve().parent


class Measure(unittest.TestCase):
    def files_of(self, kind):
        texts = dict(measure.texts_of(HERE.parents[1], measure.SUFFIXES))
        return measure.files_to_touch(measure.EXEMPLARS[kind], texts)

    def test_a_scenario_key_costs_its_struct_and_its_reader(self):
        files = self.files_of("scenario key (exploration_step_m)")
        self.assertEqual(
            files, ["robot_agent/config/navigation_tables.cpp", "robot_agent/core/navigation/settings.hpp", "docs/scenario.md"]
        )

    def test_a_radio_model_with_a_key_costs_its_parameters_their_reader_and_the_model(self):
        files = self.files_of("radio model (loss by chance)")
        self.assertEqual(
            [file for file in files if not file.startswith("docs/")],
            [
                "runtime/pure/propagation_config.hpp",
                "runtime/scenario/shared_tables.cpp",
                "radio_emulator/medium/propagation.hpp",
            ],
        )

    def test_a_reader_that_leaves_ends_it_without_a_message(self):
        reader, writer = os.pipe()
        os.close(reader)
        with os.fdopen(writer, "wb") as output:
            done = subprocess.run([sys.executable, "-B", str(HERE / "measure.py")], stdout=output, stderr=subprocess.PIPE)
        self.assertEqual(done.stderr, b"")


if __name__ == "__main__":
    unittest.main()
