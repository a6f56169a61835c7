// SPDX-License-Identifier: Apache-2.0
#include "runtime/provenance/sha256.hpp"

#include <gtest/gtest.h>

namespace caravan::runtime {
namespace {

// The examples of NIST for FIPS 180-4.
TEST(Sha256, GivesThePublishedValues) {
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(sha256(std::string(1'000'000, 'a')),
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Sha256, DoesNotDependOnHowTheTextIsDivided) {
  const std::string text(200, 'x');
  for (std::size_t first = 0; first <= text.size(); ++first) {
    Sha256 hash;
    hash.add(std::string_view{text}.substr(0, first));
    hash.add(std::string_view{text}.substr(first));
    ASSERT_EQ(hash.hex(), sha256(text)) << first;
  }
}

TEST(Sha256, DiffersForEveryLengthAroundABlock) {
  for (std::size_t length = 50; length < 70; ++length)
    EXPECT_NE(sha256(std::string(length, 'a')), sha256(std::string(length + 1, 'a'))) << length;
}

}  // namespace
}  // namespace caravan::runtime
