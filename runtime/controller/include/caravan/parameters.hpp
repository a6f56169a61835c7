// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace caravan {

/// A key of the table `[controller]` has a value that the controller cannot use. The program that loads the
/// controller adds file and line.
class ParameterError : public std::runtime_error {
 public:
  ParameterError(std::string key, const std::string& reason)
      : std::runtime_error{reason}, key_{std::move(key)} {}
  [[nodiscard]] const std::string& key() const { return key_; }

 private:
  std::string key_;
};

/// What a number may be, ends included. It is finite in any case.
struct Limits {
  double low = -std::numeric_limits<double>::max();
  double high = std::numeric_limits<double>::max();
};

/// The keys of the scenario's table `[controller]` that are the controller's own. Each function gives the
/// value of a key, or `otherwise` when the scenario does not have it.
///
/// The constructor of a controller asks for every key that it knows. A key of the scenario that it has not
/// asked for ends the program before the run: it may be misspelt.
///
/// @throws ParameterError for a value of another type, one that is not finite, or one outside the limits, and
/// for a default outside them
class Parameters {
 public:
  using Value = std::variant<bool, std::int64_t, double, std::string, std::vector<double>>;

  Parameters() = default;
  explicit Parameters(std::map<std::string, Value> values) : values_{std::move(values)} {}

  [[nodiscard]] double number(const std::string& key, double otherwise, Limits limits = {}) {
    check_default(key, otherwise, limits);
    const Value* value = find(key);
    if (value == nullptr) return otherwise;
    if (const auto* whole = std::get_if<std::int64_t>(value))
      return within(key, static_cast<double>(*whole), limits);
    if (const auto* real = std::get_if<double>(value)) return within(key, *real, limits);
    throw ParameterError{key, "must be a number"};
  }
  [[nodiscard]] std::int64_t integer(const std::string& key, std::int64_t otherwise, Limits limits = {}) {
    check_default(key, static_cast<double>(otherwise), limits);
    const Value* value = find(key);
    if (value == nullptr) return otherwise;
    const auto* whole = std::get_if<std::int64_t>(value);
    if (whole == nullptr) throw ParameterError{key, "must be an integer"};
    (void)within(key, static_cast<double>(*whole), limits);
    return *whole;
  }
  [[nodiscard]] bool flag(const std::string& key, bool otherwise) {
    return get(key, otherwise, "must be true or false");
  }
  [[nodiscard]] std::string text(const std::string& key, const std::string& otherwise) {
    return get(key, otherwise, "must be a string");
  }
  [[nodiscard]] std::vector<double> numbers(const std::string& key, const std::vector<double>& otherwise,
                                            Limits limits = {}) {
    for (const double value : otherwise) check_default(key, value, limits);
    std::vector<double> values = get(key, otherwise, "must be a list of numbers");
    if (values_.contains(key)) {
      for (const double value : values) (void)within(key, value, limits);
    }
    return values;
  }

  /// Keys that somebody has asked for.
  [[nodiscard]] const std::set<std::string>& known() const { return asked_; }
  /// Keys that nobody has asked for.
  [[nodiscard]] std::vector<std::string> unknown() const {
    std::vector<std::string> keys;
    for (const auto& [key, value] : values_) {
      if (!asked_.contains(key)) keys.push_back(key);
    }
    return keys;
  }

 private:
  const Value* find(const std::string& key) {
    asked_.insert(key);
    const auto found = values_.find(key);
    return found == values_.end() ? nullptr : &found->second;
  }
  template <typename T>
  T get(const std::string& key, const T& otherwise, const char* demand) {
    const Value* value = find(key);
    if (value == nullptr) return otherwise;
    if (const T* right = std::get_if<T>(value)) return *right;
    throw ParameterError{key, demand};
  }
  /// A limit that was not given does not count.
  static void check_default(const std::string& key, double value, Limits limits) {
    const bool is_low = limits.low > Limits{}.low && value < limits.low;
    const bool is_high = limits.high < Limits{}.high && value > limits.high;
    if (is_low || is_high)
      throw ParameterError{key, "its default is " + short_text(value) + ", outside its own limits: " +
                                    short_text(limits.low) + " to " + short_text(limits.high)};
  }
  static double within(const std::string& key, double value, Limits limits) {
    if (!std::isfinite(value)) throw ParameterError{key, "must be a finite number"};
    if (value >= limits.low && value <= limits.high) return value;
    throw ParameterError{key, "must be " + in_words(limits) + ", is " + short_text(value)};
  }
  static std::string in_words(Limits limits) {
    constexpr Limits kAny;
    if (limits.high >= kAny.high) return "at least " + short_text(limits.low);
    if (limits.low <= kAny.low) return "at most " + short_text(limits.high);
    return "from " + short_text(limits.low) + " to " + short_text(limits.high);
  }
  static std::string short_text(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.9g", value);
    return text;
  }

  std::map<std::string, Value> values_;
  std::set<std::string> asked_;
};

}  // namespace caravan
