// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace caravan::deploy {

/// What a process of ours said of its end: the message of the last line of severity error or critical, or of
/// a line that names a crashing controller. Empty: there is none.
///
/// @param log  text of its log file, or the end of it
[[nodiscard]] std::string last_error_in(std::string_view log);

/// The same of a file, of which only the end is read. A file that cannot be read has none.
[[nodiscard]] std::string last_error_of(const std::filesystem::path& file);

}  // namespace caravan::deploy
