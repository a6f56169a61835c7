// SPDX-License-Identifier: Apache-2.0
// agent_contract: checks an agent against the rules P-50 to P-68 of docs/protocol.md. docs/agent_contract.md
// says how it is used, and what the rules ask of an agent.
#include <gtest/gtest.h>

#include <CLI/CLI.hpp>

#include "runtime/process/data_folder.hpp"
#include "runtime/process/run_process.hpp"
#include "runtime/process/streams.hpp"
#include "tests/contract/agent/played_run.hpp"

int main(int argc, char** argv) {
  using namespace caravan;
  runtime::prepare_streams();
  testing::InitGoogleTest(&argc, argv);  // takes its own options out
  test::Subject& subject = test::subject();
  subject.program = std::filesystem::read_symlink("/proc/self/exe").parent_path() / "robot_agent";
  std::string transport = "shm";
  double patience_s = 60.0;
  CLI::App app{"Checks an agent against the rules P-50 to P-68 of " + runtime::page("protocol.md"),
               "agent_contract"};
  app.add_option("--agent", subject.program, "The program under test; robot_agent without this option")
      ->check(CLI::ExistingFile);
  app.add_option("--scenario", subject.scenario, "Scenario that it is given; one of the suite's own without")
      ->check(CLI::ExistingFile);
  app.add_option("--transport", transport, "DDS transport: shm, udp (on 127.0.0.1) or a profile (FILE.xml)")
      ->check(runtime::complaint_about_transport);
  app.add_option("--patience", patience_s, "Seconds that an answer may take; more on a busy machine")
      ->check(CLI::Range(1.0, 600.0));
  app.add_option("arguments", subject.more, "After --: further arguments of the program");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return runtime::with_output_written(app.exit(error) == 0 ? 0 : 2);
  }
  subject.program = std::filesystem::absolute(subject.program);
  if (!subject.scenario.empty()) subject.scenario = std::filesystem::absolute(subject.scenario);
  subject.transport = runtime::transport_named(transport);
  subject.patience = std::chrono::milliseconds{static_cast<std::int64_t>(1000.0 * patience_s)};
  return runtime::with_output_written(RUN_ALL_TESTS());
}
