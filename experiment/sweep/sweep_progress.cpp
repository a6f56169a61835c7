// SPDX-License-Identifier: Apache-2.0
#include "experiment/sweep/sweep_progress.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>

namespace caravan::experiment {
namespace {

constexpr std::size_t kBarWidth = 20;

/// 75:08 = 75 minutes and 8 seconds.
std::string minutes(double time_s) {
  const auto whole = static_cast<long>(std::ceil(time_s));
  const std::string rest = std::to_string(whole % 60);
  return std::to_string(whole / 60) + (rest.size() < 2 ? ":0" : ":") + rest;
}

}  // namespace

double time_left_s(double mean_s, std::size_t waiting, std::span<const double> ages_s, std::size_t jobs) {
  double work_s = mean_s * static_cast<double>(waiting);
  double longest_s = waiting > 0 ? mean_s : 0.0;
  for (const double age_s : ages_s) {
    const double rest_s = std::max(0.0, mean_s - age_s);
    work_s += rest_s;
    longest_s = std::max(longest_s, rest_s);
  }
  return std::max(longest_s, work_s / static_cast<double>(jobs));
}

std::string progress_bar(const SweepCount& count) {
  const std::size_t ended = count.done + count.failed;
  const std::size_t filled = count.total == 0 ? kBarWidth : kBarWidth * ended / count.total;
  std::string text = "[" + std::string(filled, '#') + std::string(kBarWidth - filled, '.') + "] " +
                     std::to_string(ended) + " of " + std::to_string(count.total);
  if (count.failed > 0) text += ", " + std::to_string(count.failed) + " failed";
  if (count.running > 0) text += ", " + std::to_string(count.running) + " running";
  if (count.left_s) text += ", " + minutes(*count.left_s) + " left";
  return text;
}

SweepProgress::SweepProgress(std::FILE* out)
    : out_{out}, terminal_{out != nullptr && ::isatty(::fileno(out)) == 1} {}

void SweepProgress::show(const SweepCount& count) {
  if (!terminal_) return;
  const std::string text = progress_bar(count);
  if (text == shown_) return;
  std::fprintf(out_, "\r\033[K%s", text.c_str());
  std::fflush(out_);
  shown_ = text;
}

void SweepProgress::say(const std::string& line) {
  if (out_ == nullptr) return;
  close();
  std::fprintf(out_, "%s\n", line.c_str());
  std::fflush(out_);
}

void SweepProgress::close() {
  if (!shown_.empty()) std::fputs("\r\033[K", out_);
  shown_.clear();
}

}  // namespace caravan::experiment
