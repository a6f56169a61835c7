// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "runtime/config/setting.hpp"
#include "runtime/config/start_error.hpp"

namespace caravan::runtime {

/// Valid range of a number, ends included.
struct Range {
  double low = -std::numeric_limits<double>::max();
  double high = std::numeric_limits<double>::max();
};
inline constexpr Range kNotNegative{0.0, std::numeric_limits<double>::max()};
/// Above zero by more than rounding.
inline constexpr Range kPositive{1e-9, std::numeric_limits<double>::max()};
/// Seconds that fit into 64 bits as nanoseconds, as does a sum of some of them; on the wire a stamp has 31
/// bits for its seconds.
inline constexpr Range kTime_s{1e-9, 1e9};
/// Metres; squares and cell counts of such lengths are far from overflow.
inline constexpr Range kLength_m{1e-9, 1e6};
inline constexpr Range kPlace_m{-1e6, 1e6};

/// One table of a scenario, read strictly. A value of the wrong type or out of range, and after reading any
/// key that no read named, is a StartError `file:line: table.key: reason`, and for a key of a Setting
/// `origin: reason`. A missing key leaves the default.
class TomlTable {
 public:
  TomlTable(std::string file, std::string name, const toml::table* table);

  void read(std::string_view key, double& value, Range range = {});
  void read(std::string_view key, std::uint32_t& value, Range range = {0, 4294967295.0});
  void read(std::string_view key, std::uint64_t& value);
  void read(std::string_view key, bool& value);
  void read(std::string_view key, std::string& value);
  /// A pair of numbers [x, y].
  void read(std::string_view key, std::array<double, 2>& value, Range range = {});
  /// A list of such pairs.
  void read(std::string_view key, std::vector<std::array<double, 2>>& value, Range range = {});
  /// A list of 1 to 32 numbers.
  void read(std::string_view key, std::vector<double>& value, Range range = {});
  /// One of the given words; sets `value` to its index.
  void read_choice(std::string_view key, std::size_t& value, std::initializer_list<std::string_view> words);

  using Value = std::variant<bool, std::int64_t, double, std::string, std::vector<double>>;
  /// Every key that nobody has asked for yet, for a reader who will refuse unknown keys itself.
  /// @throws StartError for a value of another kind
  [[nodiscard]] std::map<std::string, Value> rest();

  /// A value of any kind as Setting::value; empty when the key is absent. @throws StartError for a table or
  /// date
  [[nodiscard]] std::string value(std::string_view key);
  /// A list of such values. @throws StartError when it has none
  [[nodiscard]] std::vector<std::string> values(std::string_view key);
  /// A list of lists of such values. @throws StartError when it or one of its lists has none
  [[nodiscard]] std::vector<std::vector<std::string>> rows(std::string_view key);

  [[nodiscard]] bool has(std::string_view key) const;
  /// `file:line` of the key, for messages.
  [[nodiscard]] std::string place_of(std::string_view key) const;
  /// The sub-table `[name.key]`; empty when absent.
  [[nodiscard]] TomlTable table(std::string_view key);
  /// The array of tables `[[name.key]]`; empty when absent.
  [[nodiscard]] std::vector<TomlTable> tables(std::string_view key);

  /// To be called when all keys have been read. @throws StartError for a key that none of the reads named
  void refuse_unknown() const;
  /// For checks across keys. @throws StartError at the line of `key`
  [[noreturn]] void fail(std::string_view key, const std::string& reason) const;

 private:
  const toml::node* find(std::string_view key);
  [[nodiscard]] std::vector<std::string> values_in(const toml::node& node, std::string_view key) const;
  [[noreturn]] void fail_at(const toml::node* node, std::string_view key, const std::string& reason) const;

  std::string file_;
  std::string name_;          // "" for the root
  const toml::table* table_;  // null: absent in the file
  std::set<std::string, std::less<>> asked_;
};

/// A parsed scenario file. Cheap to copy.
class TomlDocument {
 public:
  /// @throws StartError when the file cannot be read or parsed, or has a root key or table that no scenario
  /// has
  /// @param settings  applied in this order
  static TomlDocument load(const std::filesystem::path& file, const Settings& settings = {});
  /// The same from text; messages name it `name`.
  static TomlDocument parse(std::string_view text, std::string name, const Settings& settings = {});

  [[nodiscard]] TomlTable root() const;
  [[nodiscard]] TomlTable table(std::string_view name) const;
  /// The file's name as used in messages.
  [[nodiscard]] const std::string& file() const { return file_; }
  /// The parsed tree, for a program that writes a changed scenario back.
  [[nodiscard]] const toml::table& tree() const { return *tree_; }

 private:
  TomlDocument(std::string file, std::shared_ptr<const toml::table> tree);
  std::string file_;
  std::shared_ptr<const toml::table> tree_;
};

}  // namespace caravan::runtime
