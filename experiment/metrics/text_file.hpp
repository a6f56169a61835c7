// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>

#include "runtime/config/start_error.hpp"

namespace caravan::experiment {

/// The content of a file; none if it does not exist.
/// @throws runtime::StartError when the path exists but cannot be read as one of our files: a folder, a
/// device,
///         no permission, or too long
[[nodiscard]] inline std::optional<std::string> text_in(const std::filesystem::path& file) {
  namespace fs = std::filesystem;
  constexpr std::uintmax_t kMostBytes = 256'000'000;
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (status.type() == fs::file_type::not_found) return std::nullopt;
  if (error) throw runtime::StartError{file.string() + ": cannot be read: " + error.message()};
  if (status.type() != fs::file_type::regular)
    throw runtime::StartError{
        file.string() + (fs::is_directory(status) ? ": is a folder, not a file" : ": is not a regular file")};
  if (fs::file_size(file, error) > kMostBytes) throw runtime::StartError{file.string() + ": is too long"};
  std::ifstream in{file, std::ios::binary};
  if (!in) throw runtime::StartError{file.string() + ": cannot be read"};
  return std::string{std::istreambuf_iterator<char>{in}, {}};
}

}  // namespace caravan::experiment
