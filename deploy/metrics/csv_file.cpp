// SPDX-License-Identifier: Apache-2.0
#include "deploy/metrics/csv_file.hpp"

#include <array>
#include <cstdio>
#include <stdexcept>

#include "runtime/config/start_error.hpp"

namespace caravan::deploy {
namespace {

std::string quoted(const std::string& field) {
  if (field.find_first_of(",\"\r\n") == std::string::npos) return field;
  std::string result = "\"";
  for (const char letter : field) {
    if (letter == '"') result += '"';
    result += letter;
  }
  return result + '"';
}

}  // namespace

std::string fixed(double value, int decimals) {
  std::array<char, 400> text{};
  const int length = std::snprintf(text.data(), text.size(), "%.*f", decimals, value);
  return {text.data(), static_cast<std::size_t>(length)};
}

std::string csv_row(const std::vector<std::string>& fields) {
  std::string line;
  const char* separator = "";
  for (const std::string& field : fields) {
    line += separator + quoted(field);
    separator = ",";
  }
  return line + '\n';
}

CsvFile::CsvFile(const std::filesystem::path& file, const std::vector<std::string>& header)
    : name_{file.string()}, out_{file} {
  if (!out_) throw runtime::StartError{file.string() + ": cannot be written"};
  row(header);
  flush();
}

void CsvFile::flush() {
  out_.flush();
  if (!out_) throw std::runtime_error{name_ + ": cannot be written any more"};
}

void CsvFile::row(const std::vector<std::string>& fields) { out_ << csv_row(fields); }

}  // namespace caravan::deploy
