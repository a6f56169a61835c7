// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>

#include "idl/control_types.hpp"
#include "runtime/bus/bus.hpp"

namespace caravan::deploy {

/// The result of a request.
struct ControlAnswer {
  enum class Kind : std::uint8_t { kDone, kScheduled, kRefused, kNone };
  Kind kind = Kind::kNone;
  std::uint64_t step = 0;  ///< from which it takes effect
  std::string reason;      ///< why it was refused, or that there was no answer

  [[nodiscard]] bool is_good() const { return kind == Kind::kDone || kind == Kind::kScheduled; }
};

/// Sends requests to the world and the radio and waits for their answers.
///
/// A request is repeated every half second with the same number until it is answered, so that neither a
/// process that is just starting nor a late match of the topics loses it. One request at a time.
class Requester {
 public:
  /// Creates its topics on `bus`, which must be closed before this object is destroyed.
  void join(runtime::Bus& bus);

  /// @param request   its requester and id are set here
  /// @param patience  wall time
  /// @return kScheduled if it is for a later step or waits at the radio for the next truth, and if it was
  /// accepted but its step did not begin within `patience`
  [[nodiscard]] ControlAnswer ask(caravan_interfaces::msg::ControlRequest request,
                                  std::chrono::milliseconds patience);

 private:
  void on_reply(const caravan_interfaces::msg::ControlReply& reply);

  std::mutex mutex_;
  std::condition_variable changed_;
  std::string name_;
  std::uint32_t id_ = 0;
  std::optional<ControlAnswer> answer_;  // to the request `id_`
  runtime::Writer<caravan_interfaces::msg::ControlRequestPubSubType> requests_;
};

}  // namespace caravan::deploy
