// SPDX-License-Identifier: Apache-2.0
#include "runtime/config/toml_text.hpp"

#include <toml++/toml.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <system_error>

#include "runtime/config/start_error.hpp"

namespace caravan::runtime {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kMostBytes = 4'000'000;
// A key `a.b.c` nests one table per dot. The parser, which limits only the depth of arrays and
// inline tables (256), walks them recursively.
constexpr int kMostDots = 16;

[[noreturn]] void fail(const std::string& name, std::size_t line, const std::string& reason) {
  throw StartError{name + ":" + std::to_string(line) + ": " + reason};
}

/// Scans TOML and counts the dots of each key. Dots in strings and comments do not count.
class DotCounter {
 public:
  DotCounter(std::string_view text, const std::string& name) : text_{text}, name_{name} {}

  void run() {
    while (place_ < text_.size()) {
      const char one = text_[place_];
      if (one == '"' || one == '\'') {
        pass_text(one);
      } else if (one == '#') {
        place_ = std::min(text_.find('\n', place_), text_.size());
      } else {
        count(one);
        ++place_;
      }
    }
  }

 private:
  void count(char one) {
    if (one == '.' && ++dots_ > kMostDots) {
      fail(name_, line_, "a key has more than " + std::to_string(kMostDots) + " dots");
    }
    if (std::string_view{"[]{},=\n"}.find(one) != std::string_view::npos) dots_ = 0;
    if (one == '\n') ++line_;
  }
  /// Skips a quoted string; an unclosed one ends with its line or, in triple quotes, with the file.
  void pass_text(char quote) {
    const std::string triple(3, quote);
    const bool is_long = text_.substr(place_, 3) == triple;
    place_ += is_long ? 3 : 1;
    while (place_ < text_.size()) {
      const char one = text_[place_];
      if (is_long ? text_.substr(place_, 3) == triple : one == quote) {
        place_ += is_long ? 3 : 1;
        return;
      }
      if (one == '\n' && !is_long) return;
      if (one == '\n') ++line_;
      place_ += one == '\\' && quote == '"' && place_ + 1 < text_.size() && text_[place_ + 1] != '\n' ? 2 : 1;
    }
  }

  std::string_view text_;
  const std::string& name_;
  std::size_t place_ = 0;
  std::size_t line_ = 1;
  int dots_ = 0;  // of the key so far
};

}  // namespace

std::string read_toml_file(const fs::path& file, const std::string& kind) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (status.type() == fs::file_type::not_found) throw StartError{file.string() + ": no such " + kind};
  if (error) throw StartError{file.string() + ": " + error.message()};
  if (status.type() != fs::file_type::regular)
    throw StartError{file.string() + ": is " + (fs::is_directory(status) ? "a folder" : "a device or pipe") +
                     ", not a " + kind};
  errno = 0;
  std::ifstream in{file, std::ios::binary};
  if (!in) throw StartError{file.string() + ": cannot be read: " + std::strerror(errno)};
  if (fs::file_size(file, error) > kMostBytes) {
    throw StartError{file.string() + ": is longer than " + std::to_string(kMostBytes / 1'000'000) +
                     " MB: not a " + kind};
  }
  return {std::istreambuf_iterator<char>{in}, {}};
}

toml::table parse_toml(std::string_view text, const std::string& name) {
  DotCounter{text, name}.run();
  try {
    return toml::parse(text);
  } catch (const toml::parse_error& wrong) {
    fail(name, wrong.source().begin.line, std::string{wrong.description()});
  }
}

toml::table parse_toml_line(std::string_view line, const std::string& origin) {
  DotCounter{line, origin}.run();
  try {
    return toml::parse(line, std::string{origin});
  } catch (const toml::parse_error& wrong) {
    throw StartError{origin + ": is not a value of TOML: " + std::string{wrong.description()}};
  }
}

}  // namespace caravan::runtime
