// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "runtime/config/start_error.hpp"

namespace toml {
inline namespace v3 {
class table;
class node;
}  // namespace v3
}  // namespace toml

namespace caravan::runtime {

/// A value for one key of a scenario that takes the place of the file's, as an option of a command line gives
/// it.
struct Setting {
  std::string key;     ///< tables and key, joined by dots: `radio.range_m`
  std::string value;   ///< as TOML; a text that is_word() may stand without its quotes
  std::string origin;  ///< names it in errors, and ends with `key=value`: `--set radio.range_m=4`,
                       ///< `plan.toml:3: a.b=4`
};
using Settings = std::vector<Setting>;

/// A key and its values, as in `radio.range_m=2,4`; at least one.
struct KeyValues {
  std::string key;
  std::vector<std::string> values;  ///< each as Setting::value
};

/// Whether a text is a key: one or more bare keys of TOML, joined by dots.
[[nodiscard]] bool is_key(std::string_view text);
/// Whether a text needs no quotes in a Setting: it begins with a letter, a dot, a slash or an underline, goes
/// on with these, digits and dashes, and is no value of TOML such as true or nan.
[[nodiscard]] bool is_word(std::string_view text);
/// A text as Setting::value.
[[nodiscard]] std::string value_of_text(std::string_view text);
/// A node as Setting::value; empty for a table, a date or a time.
[[nodiscard]] std::string value_of_node(const toml::node& node);

/// Reads `key=value,value`. Commas inside brackets, braces and quotes do not separate.
/// @param option  as the user wrote it, such as --set: errors begin with it
/// @throws StartError for another form, no value, an empty one, or one that is named twice
[[nodiscard]] KeyValues read_key_values(const std::string& text, const std::string& option);

/// Reads `key=value`. @throws StartError as read_key_values(), and for more than one value
[[nodiscard]] Setting read_setting(const std::string& text, const std::string& option);

/// Puts the value into the tree in the place of the one that is there. Tables that are missing are made; a
/// value that is itself a table is laid over the one that is there, key by key. The nodes that it puts there
/// have the setting's origin as the path of their source.
/// @throws StartError when the value is not TOML, or the key leads through something that is not a table
void apply(const Setting& setting, toml::table& tree);

}  // namespace caravan::runtime
