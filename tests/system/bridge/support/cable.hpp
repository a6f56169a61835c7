// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <thread>
#include <vector>

#include "tests/system/bridge/support/socket.hpp"

namespace caravan::test {

/// A cable between a bridge and an emulated device, that a test can pull, cut through or put noise on. TCP at
/// both ends.
class Cable {
 public:
  /// @param device  the device's port
  explicit Cable(std::uint16_t device);
  ~Cable();
  Cable(const Cable&) = delete;
  Cable& operator=(const Cable&) = delete;

  /// Where the bridge connects.
  [[nodiscard]] std::uint16_t port() const { return port_; }

  enum class State : std::uint8_t {
    kWhole,
    kPulled,   ///< both ends see the connection end, none is made
    kFrozen,   ///< nothing comes through, nobody is told, not even that an end is closed
    kGarbled,  ///< every byte is another one; the same
    kNoisy     ///< whole, with random bytes between what the device says
  };
  void set(State state) { state_ = state; }

 private:
  struct Ends {
    Socket bridge{-1};
    Socket device{-1};
  };
  void run();
  void plug_in(Ends& ends) const;
  void carry(Ends& ends) const;
  [[nodiscard]] bool pass(const Socket& from, const Socket& to, bool to_bridge) const;

  std::uint16_t device_;
  std::uint16_t port_ = 0;
  Socket listener_{-1};
  std::atomic<State> state_{State::kWhole};
  std::atomic<bool> ending_{false};
  std::thread thread_;
};

}  // namespace caravan::test
