// SPDX-License-Identifier: Apache-2.0
#include "hardware_bridge/config/bridge_table.hpp"
#include "hardware_bridge/shell/pioneer_shell.hpp"
#include "runtime/config/start_error.hpp"
#include "runtime/process/run_process.hpp"

namespace {

using namespace caravan;

const std::string& only_one(const std::vector<std::string>& texts, const char* option, const char* example) {
  if (texts.size() != 1) throw runtime::StartError{std::string{option} + ": give one, such as " + example};
  return texts.front();
}

struct Addresses {
  bridge::PortAddress robot;
  std::optional<bridge::PortAddress> gps;
};

Addresses parse(const std::vector<std::string>& port, const std::vector<std::string>& gps) {
  Addresses addresses;
  addresses.robot =
      bridge::parse_port(only_one(port, "--port", "/dev/ttyUSB0 or tcp:127.0.0.1:8101"), "--port");
  const std::string& receiver = only_one(gps, "--gps", "/dev/ttyUSB1, tcp:127.0.0.1:8201 or none");
  if (receiver != "none") addresses.gps = bridge::parse_port(receiver, "--gps");
  return addresses;
}

/// Recognises the same device by name or in numbers, by a link or directly.
void refuse_one_for_both(const bridge::Endpoint& robot, const bridge::Endpoint& gps) {
  if (canonical(robot) != canonical(gps)) return;
  const std::string port = to_text(robot.address);
  const std::string receiver = to_text(gps.address);
  throw runtime::StartError{"--gps: " + receiver + " is the robot's --port" +
                            (receiver == port ? "" : " (" + port + ")") +
                            "; give the receiver's own, or none"};
}

bridge::Devices find(const Addresses& addresses, std::uint32_t baud, std::uint32_t gps_baud) {
  bridge::Devices devices;
  devices.robot = bridge::resolve(addresses.robot, "--port");
  if (baud != 0) devices.baud = baud;
  if (addresses.gps) devices.gps = bridge::resolve(*addresses.gps, "--gps");
  if (devices.gps) refuse_one_for_both(devices.robot, *devices.gps);
  devices.gps_baud = gps_baud;
  return devices;
}

void check_baud(std::uint32_t baud, const char* option) {
  for (const std::uint32_t known : {0U, 4800U, 9600U, 19200U, 38400U, 57600U, 115200U}) {
    if (baud == known) return;
  }
  throw runtime::StartError{std::string{option} + ": must be 4800, 9600, 19200, 38400, 57600 or 115200"};
}

}  // namespace

int main(int argc, char** argv) {
  std::uint32_t robot = 0;
  std::uint32_t baud = 0;
  std::uint32_t gps_baud = 9600;
  std::vector<std::string> port;
  std::vector<std::string> gps;
  const runtime::Program program{
      .name = "pioneer_bridge",
      .purpose = "A bridge to a real Pioneer robot (or arcos_robot), whose agent runs unchanged",
      .numbers = {{"--robot", "Number of the robot, from 1", true, &robot},
                  {"--baud", "Baud rate of a serial --port; 0: search (0)", false, &baud},
                  {"--gps-baud", "Baud rate of a serial --gps (9600)", false, &gps_baud}},
      .texts = {{"--port", "The robot: /dev/ttyUSB0 or tcp:HOST:8101", &port},
                {"--gps", "Its GPS receiver (NMEA 0183): /dev/ttyUSB1, tcp:HOST:PORT or none", &gps}}};
  return runtime::run_process(
      program, argc, argv, [&](const runtime::Start& start, runtime::Loop& loop) -> int {
        check_baud(baud, "--baud");
        check_baud(gps_baud, "--gps-baud");
        const Addresses addresses = parse(port, gps);
        const auto scenario = runtime::TomlDocument::load(start.scenario);
        (void)bridge::load_robot_config(scenario, robot);  // checks the robot's number
        const bridge::BridgeConfig config = bridge::load_bridge_config(scenario, addresses.gps.has_value());
        if (start.check_only) return runtime::kDone;
        const bridge::Devices devices = find(addresses, baud, gps_baud);
        const runtime::BusConfig bus{.role = "pioneer_bridge " + std::to_string(robot),
                                     .domain = start.domain,
                                     .lease_s = start.lease_s,
                                     .transport = start.transport};
        return bridge::PioneerShell{config, robot, devices, bus, loop}.run();
      });
}
