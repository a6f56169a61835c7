// SPDX-License-Identifier: Apache-2.0
#include "runtime/scenario/bodies.hpp"

#include <algorithm>

#include "runtime/config/number_list.hpp"

namespace caravan::runtime {

std::vector<std::uint32_t> read_bodies(const std::vector<std::string>& lists, std::uint32_t robots) {
  std::vector<std::uint32_t> bodies;
  for (const std::string& list : lists) {
    for (const std::uint64_t robot : read_number_list(list, {"--bodies", 1, robots, robots})) {
      bodies.push_back(static_cast<std::uint32_t>(robot));
    }
  }
  std::sort(bodies.begin(), bodies.end());
  return bodies;
}

}  // namespace caravan::runtime
