// SPDX-License-Identifier: Apache-2.0
#include "runtime/host/domain_lock.hpp"
#include "runtime/process/run_process.hpp"
#include "world_server/shell/world_shell.hpp"

int main(int argc, char** argv) {
  using namespace caravan;
  std::vector<std::string> awaited;
  std::vector<std::string> trace_file;
  std::vector<std::string> bodies;
  const runtime::Program program{
      .name = "world_server",
      .purpose = "The emulated world: physics, sensors, items and the step barrier",
      .texts = {
          {"--await", "Observer without which the run does not start", &awaited},
          {"--trace", "File for the data that each step adds to the world's hash chain", &trace_file},
          {"--bodies", "Robots behind a bridge, such as 1-3 or 2,4: served as rt/body_<i> (pacing free)",
           &bodies}}};
  return runtime::run_process(
      program, argc, argv, [&](const runtime::Start& start, runtime::Loop& loop) -> int {
        world::WorldConfig config = world::load_world_config(runtime::TomlDocument::load(start.scenario));
        config.bodies = world::read_bodies(bodies, config);
        if (start.check_only) return runtime::kDone;
        const runtime::DomainLock lock{start.domain};
        const runtime::BusConfig bus{.role = "world_server",
                                     .domain = start.domain,
                                     .lease_s = start.lease_s,
                                     .transport = start.transport};
        auto trace = runtime::open_trace(trace_file, runtime::kWorldTrace, config.robots.count);
        return world::WorldShell{config, bus, awaited, std::move(trace), loop}.run();
      });
}
