// SPDX-License-Identifier: Apache-2.0
#include "runtime/provenance/differences.hpp"

#include <gmock/gmock.h>

#include <functional>

namespace caravan::runtime {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

Provenance example() {
  return {.build = {.version = "0.1.0",
                    .commit = {.id = "aaaa", .dirty = false},
                    .compiler = "GNU 12.2.0",
                    .type = "Release",
                    .flags = "-O3",
                    .libraries = {{"eigen", "3.4.0"}, {"ode", "0.16.2"}}},
          .host = {.processor = "P",
                   .architecture = "x86_64",
                   .cores = 2,
                   .kernel = "Linux 6.1",
                   .release = "Debian 12"},
          .command_line = {"caravan", "run"},
          .seeds = {{"seed", 1}},
          .scenario_sha256 = "cccc",
          .transport = "shm",
          .agents_per_process = 1,
          .controller = {},
          .agent = {}};
}

TEST(Differences, AreNoneBetweenARunAndItselfWhateverItsCommandLine) {
  Provenance again = example();
  again.command_line = {"caravan", "rerun", "DIR"};

  EXPECT_THAT(differences(example(), again), IsEmpty());
}

TEST(Differences, NameEachPartThatChangedOnce) {
  struct Case {
    std::function<void(Provenance&)> change;
    std::string line;
  };
  const std::vector<Case> cases{
      {[](Provenance& one) { one.build.version = "0.2.0"; }, "version: 0.2.0; the run had 0.1.0"},
      {[](Provenance& one) { one.build.commit.id = "bbbb"; }, "commit: bbbb; the run had aaaa"},
      {[](Provenance& one) { one.build.commit.dirty = true; }, "commit: aaaa with changes; the run had aaaa"},
      {[](Provenance& one) { one.build.compiler = "Clang 14"; },
       "compiler: Clang 14; the run had GNU 12.2.0"},
      {[](Provenance& one) { one.build.type = "Debug"; }, "build type: Debug; the run had Release"},
      {[](Provenance& one) { one.build.flags = "-O2"; }, "compiler flags: -O2; the run had -O3"},
      {[](Provenance& one) { one.build.libraries["ode"] = "0.16.6"; },
       "library ode: 0.16.6; the run had 0.16.2"},
      {[](Provenance& one) { one.build.libraries.erase("ode"); }, "library ode: none; the run had 0.16.2"},
      {[](Provenance& one) { one.build.libraries["new"] = "1"; }, "library new: 1; the run had none"},
      {[](Provenance& one) { one.host.processor = "Q"; }, "processor: Q; the run had P"},
      {[](Provenance& one) { one.host.architecture = "aarch64"; },
       "architecture: aarch64; the run had x86_64"},
      {[](Provenance& one) { one.host.cores = 4; }, "cores: 4; the run had 2"},
      {[](Provenance& one) { one.host.kernel = "Linux 6.2"; }, "kernel: Linux 6.2; the run had Linux 6.1"},
      {[](Provenance& one) { one.host.release = "Debian 13"; }, "release: Debian 13; the run had Debian 12"},
      {[](Provenance& one) { one.seeds["seed"] = 2; }, "seed seed: 2; the run had 1"},
      {[](Provenance& one) { one.scenario_sha256 = "dddd"; },
       "scenario: SHA-256 dddd; the run had SHA-256 cccc"},
      {[](Provenance& one) {
         one.controller = {"/a.so", "ffff"};
       },
       "controller: SHA-256 ffff; the run had none"},
      {[](Provenance& one) {
         one.agent = {"/agent", "ffff"};
       },
       "agent: SHA-256 ffff; the run had none"}};
  for (const Case& one : cases) {
    Provenance now = example();
    one.change(now);
    EXPECT_THAT(differences(example(), now), ElementsAre(one.line));
  }
}

TEST(Differences, LeaveOutWhereAFileWithEqualContentLies) {
  Provenance then = example();
  then.controller = {"/home/a/mine.so", "ffff"};
  Provenance now = example();
  now.controller = {"/srv/b/mine.so", "ffff"};

  EXPECT_THAT(differences(then, now), IsEmpty());
}

}  // namespace
}  // namespace caravan::runtime
