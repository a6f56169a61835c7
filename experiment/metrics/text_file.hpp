// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>

#include "runtime/config/start_error.hpp"

namespace caravan::experiment {

/// Everything that a file says; none when there is none.
/// @throws runtime::StartError when something of this name is there that cannot be read as a file of ours: a
///         folder, a device, somebody else's, or longer than any of them is
[[nodiscard]] inline std::optional<std::string> text_in(const std::filesystem::path& file) {
  namespace fs = std::filesystem;
  constexpr std::uintmax_t kMostBytes = 256'000'000;
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (status.type() == fs::file_type::not_found) return std::nullopt;
  if (error) throw runtime::StartError{file.string() + ": cannot be read: " + error.message()};
  if (status.type() != fs::file_type::regular)
    throw runtime::StartError{file.string() +
                              (fs::is_directory(status) ? ": is a folder, not a file" : ": is no file")};
  if (fs::file_size(file, error) > kMostBytes) throw runtime::StartError{file.string() + ": is far too long"};
  std::ifstream in{file, std::ios::binary};
  if (!in) throw runtime::StartError{file.string() + ": cannot be read"};
  return std::string{std::istreambuf_iterator<char>{in}, {}};
}

}  // namespace caravan::experiment
