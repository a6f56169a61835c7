// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace caravan::deploy {

/// A number with a fixed count of decimals.
[[nodiscard]] std::string fixed(double value, int decimals);

/// One row of a CSV file (RFC 4180 quoting), its line end included.
[[nodiscard]] std::string csv_row(const std::vector<std::string>& fields);

/// A CSV file (RFC 4180 quoting, \n line ends) that is written row by row.
class CsvFile {
 public:
  /// Overwrites. @throws runtime::StartError when the file cannot be written
  CsvFile(const std::filesystem::path& file, const std::vector<std::string>& header);

  void row(const std::vector<std::string>& fields);
  /// What is written so far survives the death of this process.
  /// @throws std::runtime_error when not all of it could be written
  void flush();

 private:
  std::string name_;
  std::ofstream out_;
};

}  // namespace caravan::deploy
