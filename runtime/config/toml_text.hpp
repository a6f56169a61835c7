// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace toml {
inline namespace v3 {
class table;
}  // namespace v3
}  // namespace toml

namespace caravan::runtime {

/// The text of a TOML file.
/// @param kind  kind of file, for messages, such as "scenario file"
/// @throws StartError when it is missing, not a regular file, unreadable, or longer than 4 MB
[[nodiscard]] std::string read_toml_file(const std::filesystem::path& file, const std::string& kind);

/// Parses text that may be hostile: tables nested deeply enough to exhaust the stack are refused before the
/// parser sees them.
/// @throws StartError `name:line: reason`
[[nodiscard]] toml::table parse_toml(std::string_view text, const std::string& name);

/// The same for `key = value`, written in one line somewhere else than in a file. The nodes of the tree have
/// `origin` as the path of their source.
/// @throws StartError `origin: reason`
[[nodiscard]] toml::table parse_toml_line(std::string_view line, const std::string& origin);

}  // namespace caravan::runtime
