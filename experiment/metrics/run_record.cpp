// SPDX-License-Identifier: Apache-2.0
#include "experiment/metrics/run_record.hpp"

#include <utility>

#include "experiment/metrics/metrics_json.hpp"
#include "experiment/metrics/result_table.hpp"
#include "experiment/metrics/run_directory.hpp"
#include "runtime/config/write_error.hpp"

namespace caravan::experiment {
namespace {

/// Shorter than the promised second, so that a late call still keeps the promise.
constexpr std::chrono::milliseconds kFlushPeriod{800};

/// Enough for metrics.json, with some hundred bytes per robot, and for paths.csv in most runs.
std::uint64_t room_for_last_words(std::uint32_t robots) { return (64 + std::uint64_t{robots}) * 1024; }

std::string paths_csv(const std::vector<std::vector<Place>>& paths) {
  std::string text = "robot,index,x_m,y_m\n";
  for (std::size_t robot = 0; robot < paths.size(); ++robot) {
    for (std::size_t i = 0; i < paths[robot].size(); ++i) {
      const Place& place = paths[robot][i];
      text += std::to_string(robot + 1) + "," + std::to_string(i) + "," + fixed(place.x_m, 4) + "," +
              fixed(place.y_m, 4) + "\n";
    }
  }
  return text;
}

}  // namespace

RunRecord::RunRecord(RunFacts facts, std::filesystem::path folder, std::FILE* out)
    : facts_{std::move(facts)},
      folder_{std::move(folder)},
      out_{out},
      metrics_{facts_.robots},
      files_{folder_, facts_.robots},
      spare_{folder_, room_for_last_words(facts_.robots)},
      progress_{out},
      flushed_{ProgressLine::Clock::now()} {
  attempt([this] {
    files_.flush();
    write_summary({}, false);
  });
}

void RunRecord::observe(const Observation& observation) {
  metrics_.observe(observation);
  files_.observe(observation);
}

void RunRecord::keep_up(const std::function<RunEnd()>& so_far) {
  const auto now = ProgressLine::Clock::now();
  if (out_ != nullptr) progress_.update(facts_, metrics_.progress(), now);
  if (now - flushed_ < kFlushPeriod) return;
  flushed_ = now;
  attempt([&] {
    files_.flush();
    write_summary(so_far(), false);
  });
}

void RunRecord::attempt(const std::function<void()>& write) {
  try {
    write();
  } catch (const runtime::WriteError& error) {
    if (failure_.empty()) failure_ = error.what();
  }
}

void RunRecord::write_summary(const RunEnd& end, bool ended) {
  write_whole_file(folder_ / "metrics.json", metrics_json(facts_, metrics_.result(), end, ended));
  write_whole_file(folder_ / "paths.csv", paths_csv(metrics_.paths()));
}

int RunRecord::close(RunEnd end) {
  files_.finish();
  if (is_whole()) {
    attempt([&] {
      files_.flush();
      write_summary(end, true);
    });
  }
  if (!is_whole()) {
    spare_.release();
    if (end.failure.empty()) end.failure = failure_;
    attempt([&] { write_summary(end, true); });
    attempt([&] { files_.flush(); });
    std::fprintf(stderr, "the record of the run ends early: %s\n", failure_.c_str());
  }
  progress_.close();
  const Result result = metrics_.result();
  if (out_ != nullptr) {
    const std::string table = result_table(facts_, result, end);
    std::printf("%s\nfiles       %s\n", table.c_str(), folder_.c_str());
    std::fflush(stdout);
  }
  return exit_code_of(outcome_of(facts_, end, result.items_delivered, result.sim_time));
}

}  // namespace caravan::experiment
