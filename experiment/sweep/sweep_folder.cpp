// SPDX-License-Identifier: Apache-2.0
#include "experiment/sweep/sweep_folder.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "experiment/metrics/text_file.hpp"
#include "runtime/config/start_error.hpp"

namespace caravan::experiment {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using Json = nlohmann::json;

/// Longer than the runs of a killed sweep take to end.
constexpr auto kPatience = 4s;

[[noreturn]] void refuse(const fs::path& folder, const std::string& why,
                         const std::string& or_else = "choose another --out") {
  throw runtime::StartError{folder.string() + ": " + why + "; " + or_else};
}

/// Whether there is anything but what sweeps create first: logs, and files whose names begin with a dot.
bool holds_something(const fs::path& folder) {
  return std::ranges::any_of(fs::directory_iterator{folder}, [](const fs::directory_entry& entry) {
    const std::string name = entry.path().filename();
    return name != "logs" && !name.starts_with('.');
  });
}

/// Several tasks may write the same text at the same time, so each uses its own temporary name.
void write_shared(const fs::path& folder, const std::string& name, const std::string& text) {
  std::array<char, 256> host{};
  gethostname(host.data(), host.size() - 1);
  const fs::path fresh = folder / ("." + name + "." + host.data() + "." + std::to_string(getpid()));
  std::ofstream out{fresh};
  out << text;
  out.close();
  std::error_code error;
  if (out) fs::rename(fresh, folder / name, error);
  if (!out || error) throw runtime::StartError{folder.string() + ": cannot be written"};
}

void check_runs(const fs::path& folder, const std::string& written, const SweepPlan& plan) {
  std::set<std::string> planned;
  for (const PlannedRun& run : plan.runs) planned.insert(folder_of(run));
  try {
    const Json sweep = Json::parse(written);
    for (const Json& run : sweep.at("runs")) {
      if (planned.contains(run.at("folder").get<std::string>())) continue;
      const auto mode = run.at("mode").get<std::string>();
      const auto seed = run.at("seed").get<std::uint64_t>();
      const auto point = run.value("point", std::string{});
      refuse(folder, "holds a sweep with other --modes, --seeds, --set or --plan: " +
                         (point.empty() ? "" : point + " ") + mode + " " + std::to_string(seed) +
                         " is not among these runs");
    }
  } catch (const Json::exception&) {
    refuse(folder, "its sweep.json cannot be read");
  }
}

/// SHA-256 by file.
using Hashes = std::map<std::string, std::string>;
const std::string kControllersFile = "controllers.json";

Hashes controllers_in(const fs::path& folder) {
  const auto text = text_in(folder / kControllersFile);
  if (!text) return {};
  try {
    return Json::parse(*text).get<Hashes>();
  } catch (const Json::exception&) {
    refuse(folder, "its " + kControllersFile + " cannot be read");
  }
}

/// The content of a controller's file is no part of the scenario, so it is compared by itself.
void check_and_note_controllers(const fs::path& folder, const SweepPlan& plan) {
  const Hashes before = controllers_in(folder);
  Hashes hashes = before;
  for (const runtime::HashedFile& controller : plan.controllers) {
    const auto [known, is_new] = hashes.emplace(controller.file, controller.sha256);
    if (is_new || known->second == controller.sha256) continue;
    refuse(folder,
           "holds a sweep with another controller: " + controller.file + " was changed since (SHA-256 " +
               known->second.substr(0, 12) + "... then, " + controller.sha256.substr(0, 12) + "... now)",
           "choose another --out, or put the former file back");
  }
  if (hashes != before)
    write_shared(folder, kControllersFile,
                 Json(hashes).dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

void check_and_begin(const fs::path& folder, const SweepPlan& plan) {
  const auto scenario = text_in(folder / "scenario.toml");
  if (!scenario) {
    if (holds_something(folder)) refuse(folder, "is not empty and is not a sweep");
    write_shared(folder, "scenario.toml", plan.scenario_text);
    check_and_note_controllers(folder, plan);
    return;
  }
  if (fs::exists(folder / "metrics.json")) refuse(folder, "holds a single run");
  if (*scenario != plan.scenario_text) {
    refuse(folder, "holds a sweep of another scenario or with other options");
  }
  if (const auto written = text_in(folder / "sweep.json")) check_runs(folder, *written, plan);
  check_and_note_controllers(folder, plan);
}

}  // namespace

SweepFolder::SweepFolder(fs::path folder, const SweepPlan& plan, Claim claim, runtime::Loop& loop,
                         std::size_t task)
    : folder_{std::move(folder)} {
  std::error_code error;
  fs::create_directories(folder_, error);
  if (error) throw runtime::StartError{folder_.string() + ": cannot be created: " + error.message()};
  if (claim != Claim::kSummarise) {
    locks_.emplace_back(folder_ / ".runs.lock", claim == Claim::kTask ? LOCK_SH : LOCK_EX, "another sweep",
                        loop);
  }
  if (claim == Claim::kTask) {
    const std::string index = std::to_string(task);
    locks_.emplace_back(folder_ / (".task_" + index + ".lock"), LOCK_EX, "another start of task " + index,
                        loop);
  } else {
    locks_.emplace_back(folder_ / ".tables.lock", LOCK_EX, "another sweep", loop);
  }
  check_and_begin(folder_, plan);
}

std::vector<int> SweepFolder::locks() const {
  std::vector<int> descriptors;
  for (const Lock& lock : locks_) descriptors.push_back(lock.descriptor());
  return descriptors;
}

SweepFolder::Lock::Lock(const fs::path& file, int kind, const std::string& holder, runtime::Loop& loop)
    // Without O_CLOEXEC: the runs inherit the lock and hold it until the last of them has ended.
    : file_{open(file.c_str(), O_RDWR | O_CREAT, 0644)} {
  if (file_ < 0) throw runtime::StartError{file.string() + ": cannot be written: " + std::strerror(errno)};
  const auto deadline = std::chrono::steady_clock::now() + kPatience;
  // A file system without locks is accepted: the lock cannot be checked there.
  while (flock(file_, kind | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
    const auto now = std::chrono::steady_clock::now();
    const bool stop = loop.wait(now + 50ms) == runtime::Loop::Woken::kStop;
    if (!stop && now < deadline) continue;
    close(file_);
    throw runtime::StartError{file.parent_path().string() + ": " + holder + " is using it"};
  }
}

SweepFolder::Lock::~Lock() {
  if (file_ >= 0) close(file_);
}

}  // namespace caravan::experiment
