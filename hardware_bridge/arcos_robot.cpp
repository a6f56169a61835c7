// SPDX-License-Identifier: Apache-2.0
#include "hardware_bridge/config/bridge_table.hpp"
#include "hardware_bridge/shell/robot_shell.hpp"
#include "runtime/config/start_error.hpp"
#include "runtime/process/run_process.hpp"

namespace {

using namespace caravan;

constexpr std::uint32_t kFirstPort = 8100;  // 8101 for robot 1, the default of ARCOS programs
constexpr std::uint32_t kFirstGpsPort = 8200;
constexpr std::uint32_t kNotGiven = 0xffffffff;

std::uint16_t port_of(std::uint32_t given, std::uint32_t usual, const char* option) {
  const std::uint32_t port = given == kNotGiven ? usual : given;
  if (port > 65535) throw runtime::StartError{std::string{option} + ": must be 0 to 65535"};
  return static_cast<std::uint16_t>(port);
}

}  // namespace

int main(int argc, char** argv) {
  std::uint32_t robot = 0;
  std::uint32_t port = kNotGiven;
  std::uint32_t gps_port = kNotGiven;
  const runtime::Program program{
      .name = "arcos_robot",
      .purpose = "An emulated Pioneer 3-DX: ARCOS on a TCP port of 127.0.0.1, for a body of the world",
      .numbers = {
          {"--robot", "Number of the body, from 1", true, &robot},
          {"--port", "TCP port for hosts; 0: any, it is printed (8100 + the number)", false, &port},
          {"--gps-port", "TCP port of its GPS receiver; 0: any (8200 + the number)", false, &gps_port}}};
  return runtime::run_process(
      program, argc, argv, [&](const runtime::Start& start, runtime::Loop& loop) -> int {
        const auto scenario = runtime::TomlDocument::load(start.scenario);
        const bridge::RobotConfig config = bridge::load_robot_config(scenario, robot);
        const bridge::RobotShell::Ports ports{port_of(port, kFirstPort + robot, "--port"),
                                              port_of(gps_port, kFirstGpsPort + robot, "--gps-port")};
        if (start.check_only) return runtime::kDone;
        const runtime::BusConfig bus{.role = "arcos_robot " + std::to_string(robot),
                                     .domain = start.domain,
                                     .lease_s = start.lease_s,
                                     .transport = start.transport};
        return bridge::RobotShell{config, robot, ports, bus, loop}.run();
      });
}
