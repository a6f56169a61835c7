// SPDX-License-Identifier: Apache-2.0
#include "tests/contract/providers.hpp"

namespace caravan::test {
namespace {

using Programs = std::vector<std::unique_ptr<Process>>;

// A busy machine delays all processes; such delays are not the subject of the suite.
const std::string kPatient = "gps_timeout_s = 3.0\nsilence_s = 1.8\n";

std::string tcp(std::uint16_t port) { return "tcp:127.0.0.1:" + std::to_string(port); }

Programs start_world_server(ContractField& field) {
  Programs programs;
  programs.push_back(field.start_world(room(1, 0), ""));
  return programs;
}

Programs start_pioneer_bridge(ContractField& field) {
  Programs programs;
  programs.push_back(field.start_world(room(1, 0) + kPatient, "1"));
  auto robot = field.start_robot(1);
  programs.push_back(field.start("pioneer_bridge",
                                 {"--robot", "1", "--port", tcp(robot.port), "--gps", tcp(robot.gps_port)}));
  programs.push_back(std::move(robot.process));
  return programs;
}

}  // namespace

std::ostream& operator<<(std::ostream& out, const Provider& provider) { return out << provider.name; }

void ContractField::SetUp() { programs_ = GetParam().start(*this); }

std::vector<Provider> providers() {
  return {{"WorldServer", start_world_server}, {"PioneerBridge", start_pioneer_bridge}};
}

}  // namespace caravan::test
