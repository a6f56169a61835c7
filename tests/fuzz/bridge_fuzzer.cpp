// SPDX-License-Identifier: Apache-2.0
#include "tests/fuzz/bridge_targets.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  caravan::bridge::fuzz::bridge({data, size});
  return 0;
}
