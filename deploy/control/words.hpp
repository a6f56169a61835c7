// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "idl/control_types.hpp"

namespace caravan::deploy {

/// A syntax error: one line that describes it.
struct WordsError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The highest step that a request can name, as in scripts: four years of simulated time.
inline constexpr std::uint64_t kHighestStep = 4'294'967'295;

/// The words of one line, read from left to right.
class Words {
 public:
  explicit Words(std::vector<std::string> words) : words_{std::move(words)} {}

  [[nodiscard]] bool is_empty() const { return next_ >= words_.size(); }
  /// The next word without taking it; empty when there is none.
  [[nodiscard]] std::string peek() const { return is_empty() ? "" : words_[next_]; }
  /// Takes the next word if it is `word`.
  bool take_if(std::string_view word);
  /// These take the next word. @throws WordsError when there is none or it is of the wrong kind; `what` names
  /// it
  std::string word(const std::string& what);
  double number(const std::string& what);
  std::uint64_t count(const std::string& what, std::uint64_t lowest);  ///< up to kHighestStep
  std::uint32_t robot();
  /// `3`, `1,2`, `1-4` or `all`, which is empty.
  std::vector<std::uint32_t> robots();
  /// @throws WordsError when a word is left
  void end() const;

 private:
  std::vector<std::string> words_;
  std::size_t next_ = 0;
};

/// Splits at spaces; text between double quotes is one word.
[[nodiscard]] std::vector<std::string> split(const std::string& line);

/// One request to a running emulation.
struct ControlForm {
  std::string_view form;  ///< `teleport ROBOT X Y [YAW]`
  std::string_view meaning;
};
/// All requests, as written for `caravan ctl` and in scripts. Each may end in `at STEP`.
[[nodiscard]] std::span<const ControlForm> control_forms();

/// Parses a request; the caller sets its requester, id and session.
/// @return none if the first word belongs to no form
/// @throws WordsError
[[nodiscard]] std::optional<caravan_interfaces::msg::ControlRequest> read_control(Words words);

}  // namespace caravan::deploy
