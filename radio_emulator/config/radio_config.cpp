// SPDX-License-Identifier: Apache-2.0
#include "radio_emulator/config/radio_config.hpp"

#include "runtime/scenario/shared_tables.hpp"

namespace caravan::radio {

MediumConfig load_radio_config(const runtime::TomlDocument& scenario) {
  const runtime::RadioTable table = runtime::read_radio(scenario);
  return {.propagation = table.propagation,
          .channel_count = table.channel_count,
          .mtu_bytes = table.mtu_bytes,
          .queue_length = table.queue_length,
          .seed = runtime::read_seed(scenario)};
}

}  // namespace caravan::radio
