// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "runtime/bus/fastdds_version.hpp"
#include "runtime/bus/participant.hpp"

namespace caravan::runtime {

[[nodiscard]] inline ParticipantId to_id(const rtps::GuidPrefix_t& prefix) {
  ParticipantId id;
  std::copy(std::begin(prefix.value), std::end(prefix.value), id.prefix.begin());
  return id;
}

}  // namespace caravan::runtime
