// SPDX-License-Identifier: Apache-2.0
#include "deploy/cli/try_controllers.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "build_paths.hpp"

namespace caravan::deploy {
namespace {

TEST(TryControllers, TakesTheNameOnceThoughAConstructorForksAndBothProcessesReturn) {
  const std::filesystem::path library =
      std::filesystem::path{CARAVAN_BIN_DIR}.parent_path() / "tests/controllers/faulty.so";
  const auto scenario = runtime::TomlDocument::parse(
      "[robots]\ncount = 3\n[controller]\nfault = \"constructor_forks\"\n", "scenario.toml");
  EXPECT_EQ(try_controllers(scenario, library), "faulty");
}

}  // namespace
}  // namespace caravan::deploy
