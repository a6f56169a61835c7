// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "tests/system/bridge/support/socket.hpp"

namespace caravan::test {

/// A cable between a bridge and an emulated device, over TCP. A test can pull it, cut it or add noise.
class Cable {
 public:
  /// @param device  the device's port
  explicit Cable(std::uint16_t device);
  ~Cable();
  Cable(const Cable&) = delete;
  Cable& operator=(const Cable&) = delete;

  /// The port to which the bridge connects.
  [[nodiscard]] std::uint16_t port() const { return port_; }

  enum class State : std::uint8_t {
    kWhole,
    kPulled,   ///< both ends see the connection close; no new one is made
    kFrozen,   ///< carries nothing; hides that an end has closed
    kGarbled,  ///< replaces every byte; hides that an end has closed
    kOneWay,   ///< silently drops what the bridge sends
    kSlow,     ///< carries 350 bytes a second from device to bridge; the rest waits
    kNoisy     ///< whole, but adds random bytes to those of the device
  };
  void set(State state) { state_ = state; }
  /// Passes everything that the device sends through `change` on its way to the bridge.
  void change(std::function<std::vector<std::uint8_t>(const std::vector<std::uint8_t>&)> change) {
    const std::lock_guard lock{mutex_};
    change_ = std::move(change);
  }

 private:
  struct Ends {
    Socket bridge{-1};
    Socket device{-1};
  };
  void run();
  void plug_in(Ends& ends) const;
  void carry(Ends& ends) const;
  [[nodiscard]] bool pass(const Socket& from, const Socket& to, bool to_bridge) const;
  void slow_down(std::vector<std::uint8_t>& bytes) const;

  std::uint16_t device_;
  std::uint16_t port_ = 0;
  Socket listener_{-1};
  std::atomic<State> state_{State::kWhole};
  std::atomic<bool> ending_{false};
  mutable std::mutex mutex_;
  std::function<std::vector<std::uint8_t>(const std::vector<std::uint8_t>&)> change_;
  // State of the slow line; used by the thread only.
  mutable std::vector<std::uint8_t> waiting_;
  mutable std::chrono::steady_clock::time_point slow_since_;
  mutable std::size_t carried_ = 0;
  std::thread thread_;
};

}  // namespace caravan::test
