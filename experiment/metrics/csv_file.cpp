// SPDX-License-Identifier: Apache-2.0
#include "experiment/metrics/csv_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>

#include "runtime/config/start_error.hpp"
#include "runtime/config/write_error.hpp"

namespace caravan::experiment {
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
    : file_{file},
      descriptor_{open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_APPEND | O_CLOEXEC, 0644)} {
  if (descriptor_ < 0) throw runtime::StartError{runtime::cannot_write(file, errno).what()};
  row(header);
  try {
    flush();
  } catch (const runtime::WriteError& error) {
    close(descriptor_);
    throw runtime::StartError{error.what()};
  }
}

CsvFile::~CsvFile() {
  (void)write_pending();
  close(descriptor_);
}

void CsvFile::row(const std::vector<std::string>& fields) { pending_ += csv_row(fields); }

void CsvFile::flush() {
  if (const int reason = write_pending(); reason != 0) throw runtime::cannot_write(file_, reason);
}

int CsvFile::write_pending() {
  std::size_t done = 0;
  int reason = 0;
  while (done < pending_.size() && reason == 0) {
    const ssize_t written = write(descriptor_, pending_.data() + done, pending_.size() - done);
    if (written > 0) done += static_cast<std::size_t>(written);
    if (written < 0 && errno != EINTR) reason = errno;
  }
  if (reason != 0) done -= take_back(done - whole_rows(done));
  pending_.erase(0, done);
  return reason;
}

std::size_t CsvFile::whole_rows(std::size_t bytes) const {
  return bytes == 0 ? 0 : pending_.rfind('\n', bytes - 1) + 1;  // npos + 1 is 0: no whole row
}

std::size_t CsvFile::take_back(std::size_t bytes) const {
  struct stat facts {};
  if (bytes == 0 || fstat(descriptor_, &facts) != 0) return 0;
  return ftruncate(descriptor_, facts.st_size - static_cast<off_t>(bytes)) == 0 ? bytes : 0;
}

}  // namespace caravan::experiment
