// SPDX-License-Identifier: Apache-2.0
#include "experiment/sweep/design.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numeric>
#include <set>
#include <utility>

#include "runtime/config/start_error.hpp"
#include "runtime/pure/hash_chain.hpp"
#include "runtime/pure/random.hpp"

namespace caravan::experiment {
namespace {

constexpr std::size_t kLongestName = 120;

std::vector<Axis> axes_of(std::span<const Factor> factors) {
  std::vector<Axis> axes;
  for (const Factor& factor : factors) axes.push_back(factor.axis);
  return axes;
}

/// @throws runtime::StartError for a key that appears twice
void refuse_same_keys(const std::vector<Axis>& axes) {
  std::set<std::string> keys;
  for (const Axis& axis : axes) {
    if (!keys.insert(axis.key).second)
      throw runtime::StartError{axis.place + axis.key + ": two axes have this key"};
  }
}

[[noreturn]] void refuse_size() {
  throw runtime::StartError{"the sweep has more than " + std::to_string(kMostPoints) + " points"};
}

std::string number_text(double value, bool whole) {
  std::array<char, 40> text{};
  if (whole) return std::to_string(std::llround(value));
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

/// The factor's value at a place in [0, 1) of its range or list.
std::string value_at(const Factor& factor, double place) {
  if (!factor.values.empty()) {
    const auto index = static_cast<std::size_t>(place * static_cast<double>(factor.values.size()));
    return factor.values[std::min(index, factor.values.size() - 1)];
  }
  if (!factor.whole) return number_text(factor.low + place * (factor.high - factor.low), false);
  const double step = std::floor(place * (factor.high - factor.low + 1.0));
  return number_text(std::min(factor.low + step, factor.high), true);
}

std::uint64_t hash_of(const std::string& text) {
  pure::HashChain chain;
  chain.link(std::vector<std::uint8_t>(text.begin(), text.end()));
  return chain.value();
}

bool may_be_in_a_name(char one) {
  return (one >= 'a' && one <= 'z') || (one >= 'A' && one <= 'Z') || (one >= '0' && one <= '9') ||
         std::string_view{".=,_+-"}.find(one) != std::string_view::npos;
}

/// The text itself if it can be a folder's name; else a name made of its beginning and its hash.
std::string as_name(const std::string& text) {
  if (text.size() <= kLongestName && std::ranges::all_of(text, may_be_in_a_name)) return text;
  std::string name = text.substr(0, kLongestName);
  for (char& one : name) {
    if (!may_be_in_a_name(one)) one = '_';
  }
  std::array<char, 16> digits{};
  char* const end = std::to_chars(digits.data(), digits.data() + digits.size(), hash_of(text), 16).ptr;
  return name + "_" + std::string{digits.data(), end};
}

}  // namespace

Design full_factorial(std::span<const Factor> factors) {
  Design design;
  for (const Factor& factor : factors) {
    Design one{.axes = {factor.axis}, .points = {}};
    for (const std::string& value : factor.values) one.points.push_back({value});
    design = crossed(design, one);
  }
  return design;
}

Design one_at_a_time(std::span<const Factor> factors) {
  std::vector<std::string> base;
  for (const Factor& factor : factors) base.push_back(factor.base);
  std::vector<std::vector<std::string>> points = {base};
  for (std::size_t i = 0; i < factors.size(); ++i) {
    for (const std::string& value : factors[i].values) {
      points.push_back(base);
      points.back()[i] = value;
    }
  }
  return explicit_points(axes_of(factors), std::move(points));
}

Design latin_hypercube(std::span<const Factor> factors, std::size_t points, std::uint64_t seed) {
  if (points > kMostPoints) refuse_size();
  std::vector<std::vector<std::string>> all(points);
  for (std::size_t i = 0; i < factors.size(); ++i) {
    pure::Random random{seed, i};
    std::vector<std::size_t> parts(points);
    std::iota(parts.begin(), parts.end(), std::size_t{0});
    for (std::size_t left = points; left > 1; --left) {  // Fisher and Yates
      const auto chosen = static_cast<std::size_t>(random.unit() * static_cast<double>(left));
      std::swap(parts[left - 1], parts[std::min(chosen, left - 1)]);
    }
    for (std::size_t point = 0; point < points; ++point) {
      const double place = (static_cast<double>(parts[point]) + random.unit()) / static_cast<double>(points);
      all[point].push_back(value_at(factors[i], place));
    }
  }
  return explicit_points(axes_of(factors), std::move(all));
}

Design explicit_points(std::vector<Axis> axes, std::vector<std::vector<std::string>> points) {
  refuse_same_keys(axes);
  Design design{.axes = std::move(axes), .points = {}};
  std::set<std::vector<std::string>> known;
  for (std::vector<std::string>& point : points) {
    if (known.insert(point).second) design.points.push_back(std::move(point));
  }
  if (design.points.size() > kMostPoints) refuse_size();
  return design;
}

Design crossed(const Design& one, const Design& other) {
  Design both{.axes = one.axes, .points = {}};
  both.axes.insert(both.axes.end(), other.axes.begin(), other.axes.end());
  refuse_same_keys(both.axes);
  if (!other.points.empty() && one.points.size() > kMostPoints / other.points.size()) refuse_size();
  for (const auto& first : one.points) {
    for (const auto& second : other.points) {
      both.points.push_back(first);
      both.points.back().insert(both.points.back().end(), second.begin(), second.end());
    }
  }
  return both;
}

runtime::Settings settings_at(const Design& design, std::size_t point) {
  runtime::Settings settings;
  for (std::size_t i = 0; i < design.axes.size(); ++i) {
    const Axis& axis = design.axes[i];
    const std::string& value = design.points[point][i];
    settings.push_back({.key = axis.key, .value = value, .origin = axis.place + axis.key + "=" + value});
  }
  return settings;
}

std::string folder_of(const Design& design, std::size_t point) {
  std::string text;
  for (const runtime::Setting& setting : settings_at(design, point))
    text += (text.empty() ? "" : ",") + setting.key + "=" + setting.value;
  return as_name(text);
}

}  // namespace caravan::experiment
