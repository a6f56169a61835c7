// SPDX-License-Identifier: Apache-2.0
#include "runtime/config/toml_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <toml++/toml.h>

#include <fstream>

#include "runtime/config/start_error.hpp"

namespace caravan::runtime {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

std::string repeated(const std::string& text, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) all += text;
  return all;
}

/// The message of the refusal; empty if the text is accepted as TOML.
std::string refusal_of(const std::string& text) {
  try {
    (void)parse_toml(text, "test.toml");
    return "";
  } catch (const StartError& error) {
    return error.what();
  }
}

TEST(TomlText, NestedSixtyThousandDeepIsRefusedAtItsLineInEveryForm) {
  const std::string deep = repeated("a.", 60'000) + "a";
  for (const std::string& text :
       {"[" + deep + "]\n", "[[" + deep + "]]\n", deep + " = 1\n", "x = { " + deep + " = 1 }\n",
        "x = [{ " + deep + " = 1 }]\n", "[\"b\"." + repeated("'a' . ", 60'000) + "a]\n"}) {
    EXPECT_THAT(refusal_of("# head\n" + text), StartsWith("test.toml:2: a key has more than"));
  }
  EXPECT_THAT(refusal_of("x = " + repeated("[", 60'000)), StartsWith("test.toml:1: "));
  EXPECT_THAT(refusal_of("x = " + repeated("{ a = ", 60'000)), StartsWith("test.toml:1: "));
}

TEST(TomlText, NestedByBothWaysTogetherStaysWithinTheStack) {
  const std::string key = repeated("a.", 16) + "a";
  const std::string text =
      "[" + key + "]\n" + key + " = " + repeated("{ " + key + " = ", 250) + "1" + repeated(" }", 250);
  EXPECT_EQ(refusal_of(text), "");
}

TEST(TomlText, DotsInTextsCommentsAndNumbersAreNoDepth) {
  const std::string dots = repeated(".", 100);
  EXPECT_EQ(refusal_of("a = \"" + dots + "\" # " + dots + "\n'" + dots + "' = [" + repeated("1.5, ", 100) +
                       "]\nb = \"\"\"\n\"" + dots + "\n\\\"" + dots + "\"\"\"\nc = '''" + dots +
                       "'''\nd = \"\\\"" + dots + "\"\n"),
            "");
}

TEST(TomlText, ThatIsNotClosedIsToldByTheParser) {
  for (const std::string text : {"a = \"", "a = '", "a = \"\"\"x", "a = \"\\", "[", "[[", "a = [", "a = {"}) {
    EXPECT_THAT(refusal_of(text), StartsWith("test.toml:1: "));
  }
}

class TomlFile : public testing::Test {
 protected:
  TomlFile() {
    std::string pattern = std::filesystem::temp_directory_path() / "caravan_toml_XXXXXX";
    folder_ = mkdtemp(pattern.data());
  }
  ~TomlFile() override { std::filesystem::remove_all(folder_); }
  static std::string refusal_of(const std::filesystem::path& file) {
    try {
      (void)read_toml_file(file, "scenario file");
      return "";
    } catch (const StartError& error) {
      return error.what();
    }
  }

  std::filesystem::path folder_;
};

TEST_F(TomlFile, ThatIsMissingAFolderADeviceOrAPipeIsRefusedAsSuch) {
  EXPECT_THAT(refusal_of(folder_ / "none.toml"), HasSubstr("none.toml: no such scenario file"));
  EXPECT_THAT(refusal_of(folder_), HasSubstr("is a folder, not a scenario file"));
  EXPECT_THAT(refusal_of("/dev/zero"), HasSubstr("is a device or pipe, not a scenario file"));
  ASSERT_EQ(mkfifo((folder_ / "pipe").c_str(), 0600), 0);
  EXPECT_THAT(refusal_of(folder_ / "pipe"), HasSubstr("is a device or pipe, not a scenario file"));
  EXPECT_THAT(refusal_of(folder_ / std::string(5000, 'x')), HasSubstr("File name too long"));
}

TEST_F(TomlFile, OfAnySizeIsNotReadBeyondFourMegabytes) {
  const auto file = folder_ / "huge.toml";
  std::ofstream{file} << "a = 1\n";
  EXPECT_EQ(read_toml_file(file, "scenario file"), "a = 1\n");
  std::filesystem::resize_file(file, 100'000'000'000);  // sparse
  EXPECT_THAT(refusal_of(file), HasSubstr("is longer than 4 MB"));
}

}  // namespace
}  // namespace caravan::runtime
