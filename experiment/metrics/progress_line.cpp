// SPDX-License-Identifier: Apache-2.0
#include "experiment/metrics/progress_line.hpp"

#include <unistd.h>

#include "experiment/metrics/csv_file.hpp"

namespace caravan::experiment {
namespace {

constexpr std::chrono::milliseconds kOnTerminal{250};
constexpr std::chrono::seconds kElsewhere{5};

}  // namespace

std::string progress_text(const RunFacts& facts, const Progress& progress, double speed) {
  std::string text = "simulated " + fixed(in_seconds(progress.stamp) / 60.0, 1) + " min of " +
                     fixed(in_seconds(facts.max_time) / 60.0, 1) + "  " + fixed(speed, 1) + " x  items " +
                     std::to_string(progress.items_delivered);
  if (facts.items > 0) text += "/" + std::to_string(facts.items);
  text += "  with path " + std::to_string(progress.robots_with_path) + "/" + std::to_string(facts.robots) +
          "  exchanges " + std::to_string(progress.exchanges_completed);
  if (progress.exchanges_failed > 0) text += " (" + std::to_string(progress.exchanges_failed) + " failed)";
  return text;
}

ProgressLine::ProgressLine(std::FILE* out)
    : out_{out}, terminal_{out != nullptr && ::isatty(::fileno(out)) == 1}, shown_{Clock::now()} {}

void ProgressLine::update(const RunFacts& facts, const Progress& progress, Clock::time_point now) {
  const auto period = terminal_ ? Clock::duration{kOnTerminal} : Clock::duration{kElsewhere};
  if (out_ == nullptr || now - shown_ < period) return;
  const double speed =
      in_seconds(progress.stamp - shown_stamp_) / std::chrono::duration<double>(now - shown_).count();
  shown_ = now;
  shown_stamp_ = progress.stamp;
  const std::string text = progress_text(facts, progress, speed);
  std::fprintf(out_, terminal_ ? "\r\033[K%s" : "%s\n", text.c_str());
  std::fflush(out_);
  line_open_ = terminal_;
}

void ProgressLine::close() {
  if (line_open_) std::fputs("\r\033[K", out_);
  line_open_ = false;
}

}  // namespace caravan::experiment
