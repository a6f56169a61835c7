// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "tests/system/support/process.hpp"

namespace caravan::test {

/// Hosts on a network of their own: network namespaces joined by a bridge. Each has its own interfaces, host
/// name and /dev/shm. They reach no real interface, and the destructor removes them.
class Network {
 public:
  /// @param logs  folder for the logs of the set-up
  Network(std::size_t hosts, std::filesystem::path logs);

  /// Why the network could not be made; empty if it was.
  [[nodiscard]] const std::string& refusal() const { return refusal_; }
  /// @param host from 1 to the number of hosts; likewise below
  [[nodiscard]] static std::string address(std::size_t host) { return "10.77.0." + std::to_string(host); }
  /// Starts one of our programs on a host.
  /// @param arguments  the first is the name of the program in the folder of binaries, or its path
  [[nodiscard]] std::unique_ptr<PatientProcess> start(std::size_t host, std::vector<std::string> arguments,
                                                      const std::string& log);
  /// Takes the host's link down, or up again.
  void cut(std::size_t host);
  void heal(std::size_t host);

 private:
  using Words = std::vector<std::string>;

  /// A process that keeps namespaces open; null, with `refusal_` set, if it cannot.
  std::unique_ptr<PatientProcess> hold(const Words& before, const std::string& set_up,
                                       const std::string& log);
  [[nodiscard]] Words inside(const PatientProcess& holder, const Words& namespaces) const;
  /// Runs a command and waits. @return whether it succeeded
  bool run(Words words);
  void make_hosts(std::size_t hosts);
  [[nodiscard]] bool waits_for_link(std::size_t host);

  std::filesystem::path logs_;
  bool as_user_ = false;  // in a user namespace, since the test does not run as root
  std::string refusal_;
  std::unique_ptr<PatientProcess> middle_;  // holds the bridge
  std::vector<std::unique_ptr<PatientProcess>> hosts_;
};

}  // namespace caravan::test
