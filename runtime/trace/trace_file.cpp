// SPDX-License-Identifier: Apache-2.0
#include "runtime/trace/trace_file.hpp"

#include <array>
#include <cerrno>
#include <utility>

#include "runtime/config/start_error.hpp"
#include "runtime/config/write_error.hpp"

namespace caravan::runtime {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kFlushPeriod{400};
constexpr std::size_t kBufferSize = 1U << 18U;

}  // namespace

std::string trace_heading(const std::string& part, std::uint32_t number) {
  return "caravan trace 1 " + part + " " + std::to_string(number) + "\n";
}

std::filesystem::path robot_trace_in(const std::filesystem::path& folder, std::uint32_t robot) {
  return folder / ("robot_" + std::to_string(robot) + ".trace");
}

TraceFile::TraceFile(std::filesystem::path file, const std::string& part, std::uint32_t number)
    : file_{std::move(file)},
      heading_{trace_heading(part, number)},
      buffer_{std::make_unique_for_overwrite<char[]>(kBufferSize)} {
  open();
  if (!out_) throw StartError{cannot_write(file_, reason_).what()};
}

void TraceFile::open() {
  out_ = std::ofstream{};
  out_.rdbuf()->pubsetbuf(buffer_.get(), static_cast<std::streamsize>(kBufferSize));
  out_.open(file_, std::ios::binary | std::ios::trunc);
  out_ << heading_ << std::flush;
  note_reason();
  flushed_ = Clock::now();
}

void TraceFile::record(std::span<const std::uint8_t> step) {
  const auto size = static_cast<std::uint32_t>(step.size());
  std::array<char, 4> length{};
  for (std::size_t i = 0; i < 4; ++i) length[i] = static_cast<char>(size >> (8 * i));
  out_.write(length.data(), length.size());
  out_.write(reinterpret_cast<const char*>(step.data()), static_cast<std::streamsize>(step.size()));
  note_reason();
}

void TraceFile::note_reason() {
  if (!out_ && reason_ == 0) reason_ = errno;
}

void TraceFile::restart() { open(); }

void TraceFile::keep_up() {
  const Clock::time_point now = Clock::now();
  if (out_ && now - flushed_ < kFlushPeriod) return;
  flushed_ = now;
  flush();
}

void TraceFile::flush() {
  out_.flush();
  note_reason();
  if (!out_) throw cannot_write(file_, reason_);
}

std::unique_ptr<TraceFile> open_trace(const std::vector<std::string>& files, const std::string& part,
                                      std::uint32_t robots) {
  return files.empty() ? nullptr : std::make_unique<TraceFile>(files.back(), part, robots);
}

}  // namespace caravan::runtime
