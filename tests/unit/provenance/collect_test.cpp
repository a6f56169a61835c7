// SPDX-License-Identifier: Apache-2.0
#include "runtime/provenance/collect.hpp"

#include <gmock/gmock.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "runtime/config/start_error.hpp"
#include "runtime/provenance/sha256.hpp"

namespace caravan::runtime {
namespace {

using testing::MatchesRegex;

TEST(Collecting, FindsTheProcessorsModelAndElseTheBoard) {
  EXPECT_EQ(
      processor_in("processor\t: 0\nvendor_id\t: AuthenticAMD\nmodel\t\t: 17\nmodel name\t: AMD EPYC 7B13\n"),
      "AMD EPYC 7B13");
  EXPECT_EQ(processor_in("processor\t: 0\nBogoMIPS\t: 108.00\n\nModel\t\t: Raspberry Pi 4 Model B Rev 1.4\n"),
            "Raspberry Pi 4 Model B Rev 1.4");
  EXPECT_EQ(processor_in("model name\t:\nprocessor : 1"), "unknown");
  EXPECT_EQ(processor_in(""), "unknown");
}

TEST(Collecting, FindsTheReleaseOfTheDistribution) {
  EXPECT_EQ(release_in("NAME=\"Debian\"\nPRETTY_NAME=\"Debian GNU/Linux 12 (bookworm)\"\nID=debian\n"),
            "Debian GNU/Linux 12 (bookworm)");
  EXPECT_EQ(release_in("NAME=Debian\n"), "unknown");
}

TEST(Collecting, NamesTheBuild) {
  const Build build = this_build();

  EXPECT_THAT(build.version, MatchesRegex("[0-9]+\\.[0-9]+\\.[0-9]+"));
  EXPECT_THAT(build.commit.id, MatchesRegex("unknown|[0-9a-f]{40}"));
  EXPECT_EQ(build.commit.dirty.has_value(), build.commit.id != "unknown");
  EXPECT_THAT(build.compiler, MatchesRegex("[A-Za-z]+ [0-9.]+"));
  EXPECT_NE(build.type, "");
  EXPECT_THAT(build.flags, testing::HasSubstr("-ffp-contract=off"));
  EXPECT_THAT(build.flags, testing::Not(testing::HasSubstr("-Wall")));
  for (const char* name : {"eigen", "fast_cdr", "fast_dds", "glibc", "ode", "tomlplusplus"}) {
    ASSERT_TRUE(build.libraries.contains(name)) << name;
    EXPECT_THAT(build.libraries.at(name), MatchesRegex("[0-9]+\\.[0-9.]+")) << name;
  }
}

TEST(Collecting, NamesTheHost) {
  const Host host = this_host();

  EXPECT_NE(host.processor, "");
  EXPECT_NE(host.architecture, "unknown");
  EXPECT_GE(host.cores, 1U);
  EXPECT_THAT(host.kernel, testing::StartsWith("Linux "));
  EXPECT_NE(host.release, "");
}

TEST(Collecting, HashesFilesAndNamesThoseThatCannotBeRead) {
  const auto file = std::filesystem::temp_directory_path() / ("caravan-hashed-" + std::to_string(getpid()));
  const std::string text(200'000, 'x');
  std::ofstream{file} << text;

  EXPECT_EQ(hashed(file).file, file.string());
  EXPECT_EQ(hashed(file).sha256, sha256(text));
  std::filesystem::remove(file);
  for (const auto& missing : {file, std::filesystem::temp_directory_path()}) {
    try {
      (void)hashed(missing);
      ADD_FAILURE() << missing;
    } catch (const StartError& error) {
      EXPECT_THAT(error.what(), testing::StartsWith(missing.string() + ": cannot be read: "));
    }
  }
}

}  // namespace
}  // namespace caravan::runtime
