// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace caravan::runtime {

/// Which chain a trace shows.
inline constexpr const char* kWorldTrace = "world";
inline constexpr const char* kRadioTrace = "radio";

/// The first line of a trace file, its line end included.
[[nodiscard]] std::string trace_heading(const std::string& part, std::uint32_t robots);

/// What a run adds to one of its hash chains, step by step, in a file; docs/digest.md describes it.
///
/// Not for several threads at a time.
class TraceFile {
 public:
  /// @param part  kWorldTrace or kRadioTrace
  /// @throws StartError when the file cannot be written
  TraceFile(std::filesystem::path file, const std::string& part, std::uint32_t robots);

  /// @param step  in canonical byte order
  void record(std::span<const std::uint8_t> step);
  /// A new session began: what was recorded belongs to no run any more.
  void restart();
  /// To be called at least twice a second of wall time: what was recorded a second ago survives the death of
  /// the process.
  /// @throws WriteError when the file cannot be written any more
  void keep_up();

 private:
  void open();
  /// Keeps why the stream broke; a later call may change errno.
  void note_reason();

  std::filesystem::path file_;
  std::string heading_;
  std::vector<char> buffer_;  // before the stream, which uses it to the last
  std::ofstream out_;
  int reason_ = 0;
  std::chrono::steady_clock::time_point flushed_;
};

/// The trace that a command line asks for: the last of `files`; null when there is none.
/// @throws StartError when the file cannot be written
[[nodiscard]] std::unique_ptr<TraceFile> open_trace(const std::vector<std::string>& files,
                                                    const std::string& part, std::uint32_t robots);

}  // namespace caravan::runtime
