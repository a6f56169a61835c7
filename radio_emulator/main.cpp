// SPDX-License-Identifier: Apache-2.0
#include "radio_emulator/config/radio_config.hpp"
#include "radio_emulator/shell/radio_shell.hpp"
#include "runtime/process/run_process.hpp"
#include "runtime/scenario/bodies.hpp"
#include "runtime/scenario/shared_tables.hpp"

int main(int argc, char** argv) {
  using namespace caravan;
  std::vector<std::string> trace_file;
  std::vector<std::string> bodies;
  const runtime::Program program{
      .name = "radio_emulator",
      .purpose = "The emulated radio: delivers frames by range and channel",
      .texts = {
          {"--trace", "File for the data that each step adds to the radio's hash chain", &trace_file},
          {"--bodies", "Robots behind a bridge, such as 1-3 or 2,4: their frames have the bridge's stamps",
           &bodies}}};
  return runtime::run_process(
      program, argc, argv, [&](const runtime::Start& start, runtime::Loop& loop) -> int {
        const runtime::TomlDocument scenario = runtime::TomlDocument::load(start.scenario);
        const radio::MediumConfig config = radio::load_radio_config(scenario);
        const std::uint32_t robots = runtime::read_robots(scenario).count;
        const radio::Fleet fleet{robots, runtime::read_bodies(bodies, robots)};
        if (start.check_only) return runtime::kDone;
        const runtime::BusConfig bus{.role = "radio_emulator",
                                     .domain = start.domain,
                                     .lease_s = start.lease_s,
                                     .transport = start.transport};
        auto trace = runtime::open_trace(trace_file, runtime::kRadioTrace, robots);
        return radio::RadioShell{config, fleet, bus, std::move(trace), loop}.run();
      });
}
