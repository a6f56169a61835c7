// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace caravan::experiment {

/// Reads a file written by runtime::TraceFile, step by step.
class TraceReader {
 public:
  /// @param part  as in runtime::trace_heading()
  /// @throws runtime::StartError when the file does not exist, is no regular file, or is not a trace of this
  /// part
  TraceReader(std::filesystem::path file, const std::string& part);

  /// Reads the bytes of the next step into `step`. @return false: no whole step is left
  bool next(std::vector<std::uint8_t>& step);
  /// After the last step: whether a part of another follows. The process that wrote it was killed.
  [[nodiscard]] bool cut_off() const { return cut_off_; }
  /// Number of robots; in a robot's part, the robot.
  [[nodiscard]] std::uint32_t number() const { return number_; }
  [[nodiscard]] const std::filesystem::path& file() const { return file_; }

 private:
  std::filesystem::path file_;
  std::ifstream in_;
  std::uint32_t number_ = 0;
  bool cut_off_ = false;
};

}  // namespace caravan::experiment
