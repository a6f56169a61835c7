// SPDX-License-Identifier: Apache-2.0
#include "runtime/pure/one_line.hpp"

#include <gtest/gtest.h>

namespace caravan::pure {
namespace {

TEST(OneLine, EscapesControlCharactersAndKeepsTheRest) {
  EXPECT_EQ(one_line("a\nb\x1b[2J\x7f"), "a\\nb\\x1b[2J\\x7f");
  EXPECT_EQ(one_line("Zürich, 5 m"), "Zürich, 5 m");
}

TEST(OneLine, CutsOffLongText) {
  EXPECT_EQ(one_line(std::string(1000, 'x')), std::string(1000, 'x'));
  EXPECT_EQ(one_line(std::string(5000, 'x')), std::string(1000, 'x') + "...");
}

}  // namespace
}  // namespace caravan::pure
