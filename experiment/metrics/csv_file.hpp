// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace caravan::experiment {

/// A number with a fixed count of decimals.
[[nodiscard]] std::string fixed(double value, int decimals);

/// One row of a CSV file (RFC 4180 quoting), its line end included.
[[nodiscard]] std::string csv_row(const std::vector<std::string>& fields);

/// A CSV file (RFC 4180 quoting, \n line ends) that is written row by row. Once its last row was written in
/// part only, because the disk is full, the part is taken back: a reader finds whole rows.
class CsvFile {
 public:
  /// Overwrites. @throws runtime::StartError when the file cannot be written
  CsvFile(const std::filesystem::path& file, const std::vector<std::string>& header);
  ~CsvFile();
  CsvFile(const CsvFile&) = delete;
  CsvFile& operator=(const CsvFile&) = delete;

  void row(const std::vector<std::string>& fields);
  /// What is written so far survives the death of this process.
  /// @throws runtime::WriteError when not all of it could be written; the rest waits for the next call
  void flush();

 private:
  /// @return the error number that stopped it, 0: everything is written
  int write_pending();
  /// Of the first `bytes` that are pending, those of whole rows.
  [[nodiscard]] std::size_t whole_rows(std::size_t bytes) const;
  /// Cuts the end of the file off. @return how many bytes
  [[nodiscard]] std::size_t take_back(std::size_t bytes) const;

  std::filesystem::path file_;
  int descriptor_;
  std::string pending_;  // rows that are not in the file yet
};

}  // namespace caravan::experiment
