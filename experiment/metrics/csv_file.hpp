// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace caravan::experiment {

/// A number with a fixed number of decimals.
[[nodiscard]] std::string fixed(double value, int decimals);

/// One row of a CSV file (RFC 4180 quoting), its line end included.
[[nodiscard]] std::string csv_row(const std::vector<std::string>& fields);

/// A CSV file (RFC 4180 quoting, \n line ends) that is written row by row. If its last row was written only
/// in part, because the disk is full, that part is removed: a reader finds whole rows.
class CsvFile {
 public:
  /// Overwrites an existing file. @throws runtime::StartError when the file cannot be written
  CsvFile(const std::filesystem::path& file, const std::vector<std::string>& header);
  ~CsvFile();
  CsvFile(const CsvFile&) = delete;
  CsvFile& operator=(const CsvFile&) = delete;

  void row(const std::vector<std::string>& fields);
  /// What was written so far then survives the death of this process.
  /// @throws runtime::WriteError when not all of it could be written; the rest waits for the next call
  void flush();

 private:
  /// @return the error number that stopped it; 0: everything is written
  int write_pending();
  /// How many of the first `bytes` pending bytes belong to whole rows.
  [[nodiscard]] std::size_t whole_rows(std::size_t bytes) const;
  /// Cuts off the end of the file. @return the number of bytes removed
  [[nodiscard]] std::size_t take_back(std::size_t bytes) const;

  std::filesystem::path file_;
  int descriptor_;
  std::string pending_;  // rows not yet in the file
};

}  // namespace caravan::experiment
