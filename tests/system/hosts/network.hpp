// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "tests/system/support/process.hpp"

namespace caravan::test {

/// Hosts on a network of their own: namespaces of the kernel, joined by a bridge. Each has its own
/// interfaces, host name and /dev/shm. Nothing in them reaches a real interface, and all is gone with this
/// object.
class Network {
 public:
  /// @param logs  folder for what setting it up says
  Network(std::size_t hosts, std::filesystem::path logs);

  /// Why the kernel does not allow it; empty: it does, and the network is there.
  [[nodiscard]] const std::string& refusal() const { return refusal_; }
  /// @param host from 1 to the number of hosts, here and below
  [[nodiscard]] static std::string address(std::size_t host) { return "10.77.0." + std::to_string(host); }
  /// Starts one of our programs on a host.
  /// @param arguments  the first is the program's name in the folder of binaries, or its path
  [[nodiscard]] std::unique_ptr<PatientProcess> start(std::size_t host, std::vector<std::string> arguments,
                                                      const std::string& log);
  /// Takes the host's link down, or up again.
  void cut(std::size_t host);
  void heal(std::size_t host);

 private:
  using Words = std::vector<std::string>;

  /// A process that holds namespaces open; null, with a refusal, when it cannot.
  std::unique_ptr<PatientProcess> hold(const Words& before, const std::string& set_up,
                                       const std::string& log);
  [[nodiscard]] Words inside(const PatientProcess& holder, const Words& namespaces) const;
  /// Runs a command to its end. @return whether it ended well
  bool run(Words words);
  void make_hosts(std::size_t hosts);

  std::filesystem::path logs_;
  bool as_user_ = false;  // in a user namespace: the test is not run by root
  std::string refusal_;
  std::unique_ptr<PatientProcess> middle_;  // holds the bridge
  std::vector<std::unique_ptr<PatientProcess>> hosts_;
};

}  // namespace caravan::test
