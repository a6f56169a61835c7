// SPDX-License-Identifier: Apache-2.0
// What names folders of the source and build trees. Not part of programs that are installed.
#include <signal.h>

#include <utility>

#include "build_paths.hpp"
#include "tests/system/support/process.hpp"

namespace caravan::test {
namespace fs = std::filesystem;

Process::Process(std::vector<std::string> arguments, fs::path log)
    : PatientProcess{[&] {
                       arguments[0] = std::string{CARAVAN_BIN_DIR} + "/" + arguments[0];
                       return std::move(arguments);
                     }(),
                     std::move(log)} {}

Process::~Process() {
  signal(SIGTERM);
  signal(SIGCONT);  // in case it is suspended
  (void)wait(std::chrono::seconds{10});
}

fs::path scenario(const std::string& name) {
  return fs::path{CARAVAN_SOURCE_DIR} / "deploy" / "scenarios" / name;
}

}  // namespace caravan::test
