// SPDX-License-Identifier: Apache-2.0
#include "experiment/report/write_report.hpp"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <optional>
#include <string>
#include <thread>

#include "runtime/config/start_error.hpp"
#include "runtime/process/data_folder.hpp"
#include "runtime/process/run_process.hpp"

namespace caravan::experiment {
namespace {

namespace fs = std::filesystem;

/// Long enough for the figures of a large sweep.
constexpr std::chrono::seconds kPatience{1800};
/// Debian's own interpreter, for which its matplotlib is installed.
constexpr const char* kPython = "/usr/bin/python3";

fs::path drawing_program() {
  fs::path program = runtime::data_folder() / "report/report.py";
  if (fs::is_regular_file(program)) return program;
  throw runtime::StartError{"caravan report: " + program.string() + " is missing: install Caravan anew"};
}

/// Starts the program with no signal blocked, so that Ctrl-C ends it.
pid_t start(std::vector<std::string> words) {
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawnattr_t attributes{};
  posix_spawnattr_init(&attributes);
  sigset_t none{};
  sigemptyset(&none);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK);
  pid_t pid = -1;
  const int error = posix_spawn(&pid, kPython, nullptr, &attributes, arguments.data(), environ);
  posix_spawnattr_destroy(&attributes);
  if (error != 0) {
    throw runtime::StartError{std::string{"caravan report: "} + kPython + ": " + std::strerror(error)};
  }
  return pid;
}

/// How the process ended; none: it took too long, and was killed.
std::optional<int> end_of(pid_t pid) {
  const auto deadline = std::chrono::steady_clock::now() + kPatience;
  int status = 0;
  while (waitpid(pid, &status, WNOHANG) != pid) {
    if (std::chrono::steady_clock::now() > deadline) {
      kill(pid, SIGKILL);
      (void)waitpid(pid, &status, 0);
      return std::nullopt;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds{20});
  }
  return status;
}

}  // namespace

int write_report(const std::vector<fs::path>& folders, const std::optional<fs::path>& out) {
  std::vector<std::string> words{kPython, drawing_program().string()};
  if (out) words.insert(words.end(), {"--out", out->string()});
  words.emplace_back("--");
  for (const fs::path& folder : folders) words.push_back(folder.string());
  const pid_t pid = start(std::move(words));
  const std::optional<int> ended = end_of(pid);
  if (!ended) {
    std::fprintf(stderr, "caravan report: drawing took longer than %lld s and was stopped\n",
                 static_cast<long long>(kPatience.count()));
    return runtime::kFailed;
  }
  const int status = *ended;
  if (WIFEXITED(status)) return WEXITSTATUS(status);
  return WTERMSIG(status) == SIGINT || WTERMSIG(status) == SIGTERM ? runtime::kInterrupted : runtime::kFailed;
}

}  // namespace caravan::experiment
