// SPDX-License-Identifier: Apache-2.0
#include "experiment/metrics/run_directory.hpp"

#include <array>
#include <cerrno>
#include <ctime>
#include <fstream>
#include <system_error>

#include "runtime/config/start_error.hpp"
#include "runtime/config/write_error.hpp"

namespace caravan::experiment {
namespace {

namespace fs = std::filesystem;

std::string wall_clock() {
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  localtime_r(&now, &local);
  std::array<char, 32> text{};
  std::strftime(text.data(), text.size(), "%Y%m%d-%H%M%S", &local);
  return text.data();
}

void make_wanted(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw runtime::StartError{folder.string() + ": cannot be created: " + error.message()};
  const bool empty = fs::is_empty(folder, error);
  if (error) throw runtime::StartError{folder.string() + ": cannot be read: " + error.message()};
  if (!empty) throw runtime::StartError{folder.string() + ": is not empty; choose another --out"};
}

}  // namespace

fs::path make_run_directory(const std::optional<fs::path>& wanted, const RunFacts& facts) {
  if (wanted) {
    make_wanted(*wanted);
    return *wanted;
  }
  std::error_code error;
  fs::create_directories("runs", error);
  const fs::path base = fs::path{"runs"} / (facts.scenario + "-" + facts.mode + "-" +
                                            std::to_string(facts.seed) + "-" + wall_clock());
  fs::path folder = base;
  for (int again = 2; !fs::create_directory(folder, error); ++again) {
    if (error) throw runtime::StartError{folder.string() + ": cannot be created: " + error.message()};
    folder = base.string() + "-" + std::to_string(again);
  }
  return folder;
}

void write_whole_file(const fs::path& file, const std::string& text) {
  const fs::path fresh = file.string() + ".new";
  errno = 0;
  std::ofstream out{fresh};
  out << text;
  out.close();
  const int reason = out ? 0 : errno;
  std::error_code error;
  if (out) fs::rename(fresh, file, error);
  if (out && !error) return;
  std::error_code ignored;
  fs::remove(fresh, ignored);
  throw runtime::cannot_write(file, error ? error.value() : reason);
}

}  // namespace caravan::experiment
