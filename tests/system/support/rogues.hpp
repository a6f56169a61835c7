// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "tests/system/support/process.hpp"

namespace caravan::test {

/// What rogues (tests/rogue) do from the start of the run.
struct Mischief {
  std::uint32_t domain = 0;
  std::uint32_t robots = 4;
  double rate = 200.0;  ///< samples per second, per rogue
  double seconds = 3600.0;
  std::uint32_t seed = 1;  ///< seed of the first rogue
};

/// One rogue for each role; they end with this object.
class Rogues {
 public:
  Rogues(const std::vector<std::string>& roles, const Mischief& mischief,
         const std::filesystem::path& folder) {
    for (std::size_t i = 0; i < roles.size(); ++i) {
      processes_.push_back(std::make_unique<Process>(
          std::vector<std::string>{"../tests/rogue_participant", "--domain", std::to_string(mischief.domain),
                                   "--robots", std::to_string(mischief.robots), "--rate",
                                   std::to_string(mischief.rate), "--seconds",
                                   std::to_string(mischief.seconds), "--seed",
                                   std::to_string(mischief.seed + i), "--role", roles[i]},
          folder / ("rogue_" + std::to_string(i) + ".log")));
    }
  }
  [[nodiscard]] bool have_all_begun() const {
    bool all = true;
    for (const auto& one : processes_) all = all && one->prints("begins", std::chrono::milliseconds{0});
    return all;
  }
  [[nodiscard]] std::string output() const {
    std::string text;
    for (const auto& one : processes_) text += one->output();
    return text;
  }

 private:
  std::vector<std::unique_ptr<Process>> processes_;
};

}  // namespace caravan::test
