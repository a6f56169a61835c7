// SPDX-License-Identifier: Apache-2.0
#include "hardware_bridge/shell/modem_shell.hpp"
#include "runtime/config/start_error.hpp"
#include "runtime/process/run_process.hpp"
#include "runtime/scenario/shared_tables.hpp"

namespace {

using namespace caravan;

bridge::ModemAddress parse_modem(const std::vector<std::string>& texts) {
  const std::string example = "give one, such as udp:7001 or /dev/ttyUSB2";
  if (texts.size() != 1) throw runtime::StartError{"--modem: " + example};
  bridge::ModemAddress address;
  if (!texts.front().starts_with("udp:")) {
    address.serial = bridge::Endpoint{bridge::parse_port(texts.front(), "--modem"), std::nullopt};
    return address;
  }
  const std::string port = texts.front().substr(4);
  const unsigned long number = std::strtoul(port.c_str(), nullptr, 10);
  if (port.empty() || port.find_first_not_of("0123456789") != std::string::npos || number < 1 ||
      number > 65535) {
    throw runtime::StartError{"--modem: " + example + ", not " + texts.front()};
  }
  address.udp_port = static_cast<std::uint16_t>(number);
  return address;
}

}  // namespace

int main(int argc, char** argv) {
  std::uint32_t robot = 0;
  std::uint32_t bit_rate = 250000;
  std::uint32_t channel_change_us = 130;
  std::vector<std::string> modem;
  const runtime::Program program{
      .name = "radio_modem_bridge",
      .purpose = "A real radio in place of the emulated one, for one robot",
      .numbers = {{"--robot", "Number of the robot, from 1", true, &robot},
                  {"--bit-rate", "Bits a second on the air (250000)", false, &bit_rate},
                  {"--channel-change",
                   "Microseconds without reception when the radio changes its channel (130)", false,
                   &channel_change_us}},
      .texts = {{"--modem",
                 "/dev/ttyUSB2 or tcp:HOST:PORT (packets by SLIP), or udp:PORT for all on this machine",
                 &modem}}};
  return runtime::run_process(
      program, argc, argv, [&](const runtime::Start& start, runtime::Loop& loop) -> int {
        bridge::ModemAddress address = parse_modem(modem);
        if (bit_rate < 1000) throw runtime::StartError{"--bit-rate: must be at least 1000"};
        const auto scenario = runtime::TomlDocument::load(start.scenario);
        const runtime::RadioTable radio = runtime::read_radio(scenario);
        if (robot < 1 || robot > runtime::read_robots(scenario).count) {
          throw runtime::StartError{"--robot: must be 1 to robots.count"};
        }
        const bridge::modem::RadioLimits limits{
            .mtu_bytes = radio.mtu_bytes,
            .channel_count = radio.channel_count,
            .bit_rate_bps = static_cast<double>(bit_rate),
            .channel_change = std::chrono::microseconds{channel_change_us},
            .queue_length = radio.queue_length};
        if (start.check_only) return runtime::kDone;
        if (address.serial) address.serial = bridge::resolve(address.serial->address, "--modem");
        const runtime::BusConfig bus{.role = "radio_modem_bridge " + std::to_string(robot),
                                     .domain = start.domain,
                                     .lease_s = start.lease_s,
                                     .transport = start.transport};
        return bridge::ModemShell{limits, robot, address, bus, loop}.run();
      });
}
