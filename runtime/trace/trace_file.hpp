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

/// Parts of a trace: the two hash chains, and what one robot's controller was given and answered.
inline constexpr const char* kWorldTrace = "world";
inline constexpr const char* kRadioTrace = "radio";
inline constexpr const char* kRobotTrace = "robot";

/// The first line of a trace file, its line end included.
/// @param number  of robots; in a kRobotTrace, the robot's
[[nodiscard]] std::string trace_heading(const std::string& part, std::uint32_t number);

/// The file of a robot's part, in the folder of a trace.
[[nodiscard]] std::filesystem::path robot_trace_in(const std::filesystem::path& folder, std::uint32_t robot);

/// File of one part of a trace, step by step; docs/digest.md describes it.
///
/// Not thread-safe.
class TraceFile {
 public:
  /// @param part, number  as in trace_heading()
  /// @throws StartError when the file cannot be written
  TraceFile(std::filesystem::path file, const std::string& part, std::uint32_t number);

  /// @param step  in canonical byte order
  void record(std::span<const std::uint8_t> step);
  /// A new session began: discards what was recorded.
  void restart();
  /// Call at least twice a second of wall time: what was recorded a second ago then survives the death of the
  /// process.
  /// @throws WriteError when the file can no longer be written
  void keep_up();
  /// What was recorded survives the death of the process.
  /// @throws WriteError when the file can no longer be written
  void flush();

 private:
  void open();
  /// Keeps the reason of a stream error; a later call may change errno.
  void note_reason();

  std::filesystem::path file_;
  std::string heading_;
  std::unique_ptr<char[]> buffer_;  // declared before the stream, which uses it until destroyed
  std::ofstream out_;
  int reason_ = 0;
  std::chrono::steady_clock::time_point flushed_;
};

/// The trace given on the command line: the last of `files`; null when there is none.
/// @throws StartError when the file cannot be written
[[nodiscard]] std::unique_ptr<TraceFile> open_trace(const std::vector<std::string>& files,
                                                    const std::string& part, std::uint32_t robots);

}  // namespace caravan::runtime
