// SPDX-License-Identifier: Apache-2.0
#include "experiment/sweep/plan_file.hpp"

#include <toml++/toml.h>

#include <algorithm>
#include <utility>

#include "runtime/config/toml_table.hpp"
#include "runtime/config/toml_text.hpp"

namespace caravan::experiment {
namespace {

enum class Kind : std::size_t { kFactorial, kOneAtATime, kLatinHypercube, kRows };

/// `plan.toml:4: `, which the key and its value follow.
std::string place_of(const runtime::TomlTable& table, std::string_view key) {
  return table.place_of(key) + ": ";
}

void refuse_non_key(const runtime::TomlTable& table, std::string_view key, const std::string& value) {
  if (!runtime::is_key(value)) table.fail(key, value + " is not a key such as radio.range_m");
}

void refuse_repeated(const runtime::TomlTable& table, std::string_view key,
                     const std::vector<std::string>& values) {
  for (auto one = values.begin(); one != values.end(); ++one) {
    if (std::find(values.begin(), one, *one) != one) table.fail(key, "names " + *one + " twice");
  }
}

void read_range(runtime::TomlTable& table, Factor& factor) {
  if (!table.has("low") || !table.has("high")) table.fail("key", "needs values, or low and high");
  constexpr runtime::Range kExact{-1e15, 1e15};  // whole numbers in it are exact
  table.read("low", factor.low, kExact);
  table.read("high", factor.high, kExact);
  if (factor.high < factor.low) table.fail("high", "must be at least low");
  const auto is_whole = [&table](std::string_view key) {
    return table.value(key).find_first_of(".e") == std::string::npos;
  };
  factor.whole = is_whole("low") && is_whole("high");
}

Factor read_factor(runtime::TomlTable table, Kind kind) {
  Factor factor;
  table.read("key", factor.axis.key);
  if (factor.axis.key.empty())
    table.fail("key", "a factor needs the key that it varies, such as \"radio.range_m\"");
  refuse_non_key(table, "key", factor.axis.key);
  factor.axis.place = place_of(table, "key");
  factor.values = table.values("values");
  if (factor.values.empty() && kind != Kind::kLatinHypercube) table.fail("values", "a factor needs values");
  if (factor.values.empty()) read_range(table, factor);
  refuse_repeated(table, "values", factor.values);
  if (kind == Kind::kOneAtATime) {
    factor.base = table.value("base");
    if (factor.base.empty()) table.fail("base", "each factor needs the value that it has while others vary");
  }
  table.refuse_unknown();
  return factor;
}

std::vector<Factor> read_factors(runtime::TomlTable& root, Kind kind) {
  std::vector<Factor> factors;
  for (const runtime::TomlTable& table : root.tables("factor")) factors.push_back(read_factor(table, kind));
  if (factors.empty()) root.fail("factor", "the plan needs at least one [[factor]]");
  return factors;
}

Design read_rows(runtime::TomlTable& root) {
  std::vector<Axis> axes;
  for (const std::string& key : root.values("keys")) {
    refuse_non_key(root, "keys", key);
    axes.push_back({key, place_of(root, "keys")});
  }
  if (axes.empty()) root.fail("keys", "a plan of rows needs the keys of their values");
  std::vector<std::vector<std::string>> rows = root.rows("rows");
  if (rows.empty()) root.fail("rows", "the plan needs at least one row");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].size() != axes.size()) {
      root.fail("rows", "row " + std::to_string(i + 1) + " has " + std::to_string(rows[i].size()) +
                            " values, and there are " + std::to_string(axes.size()) + " keys");
    }
  }
  return explicit_points(std::move(axes), std::move(rows));
}

Design read_hypercube(runtime::TomlTable& root) {
  std::uint32_t points = 0;
  root.read("points", points, {1, static_cast<double>(kMostPoints)});
  if (points == 0) root.fail("points", "a Latin hypercube needs the number of its points");
  std::uint64_t seed = 1;
  root.read("seed", seed);
  return latin_hypercube(read_factors(root, Kind::kLatinHypercube), points, seed);
}

}  // namespace

Design read_plan(const std::filesystem::path& file) {
  const toml::table tree = runtime::parse_toml(runtime::read_toml_file(file, "plan"), file.string());
  runtime::TomlTable root{file.string(), "", &tree};
  if (!root.has("design"))
    root.fail("design", "a plan needs a design: factorial, one_at_a_time, latin_hypercube or rows");
  std::size_t choice = 0;
  root.read_choice("design", choice, {"factorial", "one_at_a_time", "latin_hypercube", "rows"});
  const auto kind = static_cast<Kind>(choice);
  Design design = [&] {
    switch (kind) {
      case Kind::kFactorial:
        return full_factorial(read_factors(root, kind));
      case Kind::kOneAtATime:
        return one_at_a_time(read_factors(root, kind));
      case Kind::kLatinHypercube:
        return read_hypercube(root);
      case Kind::kRows:
        return read_rows(root);
    }
    return Design{};
  }();
  root.refuse_unknown();
  return design;
}

}  // namespace caravan::experiment
