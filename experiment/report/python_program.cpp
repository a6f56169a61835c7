// SPDX-License-Identifier: Apache-2.0
#include "experiment/report/python_program.hpp"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <optional>
#include <thread>

#include "runtime/config/start_error.hpp"
#include "runtime/process/data_folder.hpp"
#include "runtime/process/run_process.hpp"

namespace caravan::experiment {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

constexpr const char* kPython = "/usr/bin/python3";

std::vector<std::string> command_of(const PythonProgram& program) {
  const fs::path file = runtime::data_folder() / "report" / program.file;
  if (!fs::is_regular_file(file)) {
    throw runtime::StartError{program.caller + ": " + file.string() + " is missing: install Caravan anew"};
  }
  std::vector<std::string> words{kPython, file.string()};
  words.insert(words.end(), program.arguments.begin(), program.arguments.end());
  return words;
}

/// Starts the program with no signal blocked; with a loop, in a process group of its own.
pid_t start(const PythonProgram& program) {
  std::vector<std::string> words = command_of(program);
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawnattr_t attributes{};
  posix_spawnattr_init(&attributes);
  sigset_t none{};
  sigemptyset(&none);
  posix_spawnattr_setsigmask(&attributes, &none);
  const int own_group = program.loop != nullptr ? POSIX_SPAWN_SETPGROUP : 0;
  posix_spawnattr_setflags(&attributes, static_cast<short>(POSIX_SPAWN_SETSIGMASK | own_group));
  pid_t pid = -1;
  const int error = posix_spawn(&pid, kPython, nullptr, &attributes, arguments.data(), environ);
  posix_spawnattr_destroy(&attributes);
  if (error != 0) {
    throw runtime::StartError{program.caller + ": " + kPython + ": " + std::strerror(error)};
  }
  return pid;
}

bool stopped_within(runtime::Loop* loop, std::chrono::milliseconds time) {
  if (loop != nullptr) {
    return loop->wait(std::chrono::steady_clock::now() + time) == runtime::Loop::Woken::kStop;
  }
  std::this_thread::sleep_for(time);
  return false;
}

int kill_and_wait(const PythonProgram& program, pid_t pid) {
  kill(program.loop != nullptr ? -pid : pid, SIGKILL);
  int status = 0;
  (void)waitpid(pid, &status, 0);
  return status;
}

}  // namespace

int run_python(const PythonProgram& program) {
  const pid_t pid = start(program);
  const auto deadline = std::chrono::steady_clock::now() + program.patience;
  int status = 0;
  while (waitpid(pid, &status, WNOHANG) != pid) {
    if (stopped_within(program.loop, 20ms)) {
      (void)kill_and_wait(program, pid);
      return runtime::kInterrupted;
    }
    if (std::chrono::steady_clock::now() > deadline) {
      (void)kill_and_wait(program, pid);
      std::fprintf(stderr, "%s: %s took longer than %lld s and was stopped\n", program.caller.c_str(),
                   program.file.c_str(), static_cast<long long>(program.patience.count()));
      return runtime::kFailed;
    }
  }
  if (WIFEXITED(status)) return WEXITSTATUS(status);
  return WTERMSIG(status) == SIGINT || WTERMSIG(status) == SIGTERM ? runtime::kInterrupted : runtime::kFailed;
}

}  // namespace caravan::experiment
