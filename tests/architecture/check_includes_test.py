#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The include check finds each breach: every case is one forbidden line in its own tree."""

import pathlib
import tempfile
import unittest

import check_includes


def breaches(files):
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        for path, text in files.items():
            (root / path).parent.mkdir(parents=True, exist_ok=True)
            (root / path).write_text(text)
        return check_includes.check(root)[0]


class CheckIncludes(unittest.TestCase):
    def assert_breach(self, path, text):
        self.assertEqual(len(breaches({path: text})), 1, f"{path}: {text}")

    def test_an_agent_core_may_use_std_eigen_and_the_pure_runtime(self):
        lines = '#include <vector>\n#include <Eigen/Core>\n#include "runtime/pure/random.hpp"\n'
        self.assertEqual(breaches({"robot_agent/core/agent.cpp": lines}), [])

    def test_an_agent_never_sees_the_truth(self):
        self.assert_breach("robot_agent/shell/agent_shell.hpp", '#include "idl/world_types.hpp"\n')
        self.assert_breach("robot_agent/core/agent.cpp", '#include "world_server/types.hpp"\n')
        self.assert_breach("hardware_bridge/shell/pioneer_shell.hpp", '#include "idl/world_types.hpp"\n')

    def test_generated_headers_are_for_idl(self):
        line = '#include "robotPubSubTypes.h"\n'
        self.assertEqual(breaches({"idl/robot_types.hpp": line}), [])
        self.assert_breach("robot_agent/shell/agent_shell.hpp", line)
        self.assert_breach("robot_agent/shell/wire.hpp", '#include "robot.h"\n')

    def test_only_physics_sees_ode(self):
        self.assertEqual(breaches({"world_server/physics/body.cpp": "#include <ode/ode.h>\n"}), [])
        self.assert_breach("hardware_bridge/core/robot/microcontroller.cpp", "#include <ode/ode.h>\n")
        self.assert_breach("world_server/referee/items.cpp", "#include <ode/ode.h>\n")
        self.assert_breach("experiment/embedded/engine.cpp", "#include <ode/ode.h>\n")

    def test_dds_is_for_bus_shells_and_launcher(self):
        line = "#include <fastdds/dds/domain/DomainParticipant.hpp>\n"
        self.assertEqual(breaches({"runtime/bus/bus.cpp": line, "world_server/shell/shell.cpp": line}), [])
        self.assert_breach("experiment/metrics/metrics.cpp", line)
        self.assert_breach("radio_emulator/medium/medium.cpp", line)

    def test_programs_do_not_include_one_another(self):
        self.assert_breach("radio_emulator/shell/shell.cpp", '#include "world_server/types.hpp"\n')
        self.assert_breach("experiment/embedded/engine.cpp", '#include "world_server/shell/world_shell.hpp"\n')

    def test_experiments_do_not_know_deployments(self):
        line = '#include "experiment/metrics/run_record.hpp"\n'
        self.assertEqual(breaches({"deploy/launcher/run_dds.cpp": line}), [])
        for folder in ("metrics", "embedded", "trace", "sweep", "report"):
            self.assert_breach(f"experiment/{folder}/any.cpp", '#include "deploy/launcher/run_dds.hpp"\n')
        self.assert_breach("runtime/host/children.cpp", line)

    def test_the_kit_is_for_tests(self):
        line = "#include <caravan/deployment.hpp>\n"
        self.assertEqual(breaches({"deploy/kit/run_script.cpp": line, "deploy/templates/my_swarm/my_swarm_test.cpp": line}), [])
        self.assert_breach("robot_agent/shell/agent_shell.cpp", line)
        self.assert_breach("deploy/controllers/braitenberg.cpp", line)
        self.assert_breach("deploy/kit/include/caravan/seen.hpp", '#include "deploy/kit/tally.hpp"\n')

    def test_a_core_has_no_clock_thread_file_or_hash_order(self):
        self.assert_breach("robot_agent/core/agent.cpp", "auto now = std::chrono::steady_clock::now();\n")
        for header in ("thread", "fstream", "random", "unordered_map"):
            self.assert_breach("robot_agent/core/agent.cpp", f"#include <{header}>\n")

    def test_files_do_not_include_one_another_in_a_circle(self):
        files = {"runtime/pure/a.hpp": '#include "runtime/pure/b.hpp"\n', "runtime/pure/b.hpp": '#include "runtime/pure/a.hpp"\n'}
        self.assertEqual(len(breaches(files)), 1)

    def test_a_folder_without_a_rule_is_a_breach(self):
        self.assert_breach("deploy/odds_and_ends/file.cpp", "#include <vector>\n")


if __name__ == "__main__":
    unittest.main()
