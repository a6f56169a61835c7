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

/// Names of the traced chains.
inline constexpr const char* kWorldTrace = "world";
inline constexpr const char* kRadioTrace = "radio";

/// The first line of a trace file, its line end included.
[[nodiscard]] std::string trace_heading(const std::string& part, std::uint32_t robots);

/// File of the data that a run adds to one of its hash chains, step by step; docs/digest.md describes it.
///
/// Not thread-safe.
class TraceFile {
 public:
  /// @param part  kWorldTrace or kRadioTrace
  /// @throws StartError when the file cannot be written
  TraceFile(std::filesystem::path file, const std::string& part, std::uint32_t robots);

  /// @param step  in canonical byte order
  void record(std::span<const std::uint8_t> step);
  /// A new session began: discards what was recorded.
  void restart();
  /// Call at least twice a second of wall time: what was recorded a second ago then survives the death of the
  /// process.
  /// @throws WriteError when the file can no longer be written
  void keep_up();

 private:
  void open();
  /// Keeps the reason of a stream error; a later call may change errno.
  void note_reason();

  std::filesystem::path file_;
  std::string heading_;
  std::vector<char> buffer_;  // declared before the stream, which uses it until destroyed
  std::ofstream out_;
  int reason_ = 0;
  std::chrono::steady_clock::time_point flushed_;
};

/// The trace given on the command line: the last of `files`; null when there is none.
/// @throws StartError when the file cannot be written
[[nodiscard]] std::unique_ptr<TraceFile> open_trace(const std::vector<std::string>& files,
                                                    const std::string& part, std::uint32_t robots);

}  // namespace caravan::runtime
