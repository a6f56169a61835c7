// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <algorithm>
#include <cctype>
#include <fstream>

#include "build_paths.hpp"
#include "robot_agent/config/agent_config.hpp"

namespace caravan::agent {
namespace {

using runtime::StartError;
using runtime::TomlDocument;
using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(AgentConfig, EveryShippedScenarioIsReadForItsFirstRobot) {
  for (const char* name : {"paper", "paper_code", "small", "scaling", "one_robot"}) {
    SCOPED_TRACE(name);
    const auto file = std::string{CARAVAN_SOURCE_DIR "/deploy/scenarios/"} + name + ".toml";
    EXPECT_NO_THROW((void)load_config(TomlDocument::load(file), 1));
  }
}

TEST(AgentConfig, ThePapersTextAndItsCodeDifferAsTheFactsSay) {
  const std::string folder = CARAVAN_SOURCE_DIR "/deploy/scenarios/";
  const Config text = load_config(TomlDocument::load(folder + "paper.toml"), 3);
  const Config code = load_config(TomlDocument::load(folder + "paper_code.toml"), 3);
  EXPECT_EQ(text.id, RobotId{3});
  EXPECT_DOUBLE_EQ(text.recording.spacing_m, 1.0);
  EXPECT_DOUBLE_EQ(code.recording.spacing_m, 0.3);
  EXPECT_DOUBLE_EQ(text.smoothing.vision_radius_m, 6.0);
  EXPECT_DOUBLE_EQ(code.smoothing.vision_radius_m, 4.0);
  EXPECT_DOUBLE_EQ(text.exploration.detection_radius_m, 4.0);
  EXPECT_DOUBLE_EQ(code.exploration.detection_radius_m, 2.0);
  EXPECT_EQ(text.wait.period, std::chrono::nanoseconds{0});
  EXPECT_EQ(code.wait.period, std::chrono::seconds{1});
  EXPECT_EQ(code.sharing.accept_period, std::chrono::milliseconds{500});
}

TEST(AgentConfig, ARobotThatTheScenarioDoesNotHaveIsRefusedByName) {
  const auto scenario = TomlDocument::parse("[robots]\ncount = 4\n", "a.toml");
  EXPECT_THAT([&] { (void)load_config(scenario, 0); }, ThrowsMessage<StartError>(HasSubstr("robot")));
  EXPECT_THAT([&] { (void)load_config(scenario, 5); }, ThrowsMessage<StartError>(HasSubstr("1 to 4")));
  EXPECT_NO_THROW((void)load_config(scenario, 4));
}

TEST(AgentConfig, TrafficAndStopsToExchangeCanBeSwitchedOff) {
  const auto scenario =
      TomlDocument::parse("[robots]\nsolid = false\n[algorithm]\nstop_to_exchange = false\n", "a.toml");
  EXPECT_FALSE(load_config(scenario, 1).robots_are_solid);
  EXPECT_FALSE(load_config(scenario, 1).sharing.stop_to_exchange);
  EXPECT_TRUE(Config{}.robots_are_solid);
  EXPECT_TRUE(Config{}.sharing.stop_to_exchange);
}

/// A key of `[algorithm]` or one of its tables, as docs/scenario.md lists it.
struct Documented {
  std::string table;
  std::string key;
  std::string value;  // the default
  [[nodiscard]] std::string line(const std::string& other) const {
    return "[" + table + "]\n" + key + " = " + other + "\n";
  }
  [[nodiscard]] bool is_list() const { return value.front() == '['; }
  [[nodiscard]] bool is_number() const { return std::isdigit(value.back()) != 0; }
  /// A valid value other than the default.
  [[nodiscard]] std::string another_value() const {
    if (value == "true") return "false";
    if (value == "\"full\"") return "\"none\"";
    if (is_list()) return "[0.35]";
    if (value.find('.') == std::string::npos) return std::to_string(std::stoi(value) + 1);
    return std::to_string(1.01 * std::stod(value));
  }
};

/// Splits a cell at the commas outside brackets.
std::vector<std::string> parts_of(const std::string& cell) {
  std::vector<std::string> parts(1);
  int depth = 0;
  for (const char c : cell) {
    if (c == '[') ++depth;
    if (c == ']') --depth;
    if (c == ',' && depth == 0) parts.emplace_back();
    if (c == '`' || (c == ' ' && depth == 0) || (c == ',' && depth == 0)) continue;
    parts.back() += c;
  }
  return parts;
}

std::vector<Documented> documented_keys() {
  std::ifstream page{CARAVAN_SOURCE_DIR "/docs/scenario.md"};
  std::vector<Documented> found;
  std::string table;
  for (std::string line; std::getline(page, line);) {
    if (line.starts_with("#")) {
      const std::size_t begin = line.find("[algorithm");
      table = begin == std::string::npos ? "" : line.substr(begin + 1, line.find(']') - begin - 1);
    }
    if (table.empty() || !line.starts_with("| `")) continue;
    const std::size_t first = line.find(" | ");
    const std::size_t second = line.find(" | ", first + 1);
    const auto keys = parts_of(line.substr(2, first - 2));
    const auto values = parts_of(line.substr(first + 3, second - first - 3));
    EXPECT_EQ(keys.size(), values.size()) << line;
    for (std::size_t i = 0; i < std::min(keys.size(), values.size()); ++i) {
      found.push_back({table, keys[i], values[i]});
    }
  }
  EXPECT_GT(found.size(), 100U) << "the page has another form";
  return found;
}

Config load(const std::string& text) { return load_config(TomlDocument::parse(text, "a.toml"), 1); }

TEST(AgentConfig, TheDefaultsAreThoseOfThePage) {
  for (const Documented& one : documented_keys()) {
    EXPECT_TRUE(load(one.line(one.value)) == load("")) << one.line(one.value);
  }
}

TEST(AgentConfig, EveryKeyOfThePageChangesSomethingOfItsOwn) {
  std::vector<Config> seen{load("")};
  for (const Documented& one : documented_keys()) {
    const Config changed = load(one.line(one.another_value()));
    EXPECT_FALSE(std::ranges::find(seen, changed) != seen.end()) << one.table << "." << one.key;
    seen.push_back(changed);
  }
}

TEST(AgentConfig, EveryNumberIsBounded) {
  for (const Documented& one : documented_keys()) {
    if (!one.is_number() && !one.is_list()) continue;
    for (const std::string value : {"1e150", "-1e150"}) {
      EXPECT_THAT([&] { (void)load(one.line(one.is_list() ? "[" + value + "]" : value)); },
                  ThrowsMessage<StartError>(HasSubstr("a.toml:2: " + one.table + "." + one.key + ": must ")));
    }
  }
}

struct Refused {
  const char* text;
  const char* message;
};
class AgentConfigRefuses : public testing::TestWithParam<Refused> {};

TEST_P(AgentConfigRefuses, WithFileLineAndKey) {
  const auto scenario = TomlDocument::parse(GetParam().text, "a.toml");
  EXPECT_THAT([&] { (void)load_config(scenario, 1); },
              ThrowsMessage<StartError>(HasSubstr(GetParam().message)));
}

INSTANTIATE_TEST_SUITE_P(
    Lines, AgentConfigRefuses,
    testing::Values(
        Refused{"[algorithm]\nspeed = 1.0\n", "a.toml:2: algorithm.speed: unknown key"},
        Refused{"[algorithm]\nmode = \"some\"\n", "a.toml:2: algorithm.mode: must be one of"},
        Refused{"[algorithm]\ncruise_mps = \"fast\"\n", "a.toml:2: algorithm.cruise_mps: must be a number"},
        Refused{"[algorithm]\nvision_radius_m = -6.0\n",
                "a.toml:2: algorithm.vision_radius_m: must be above 0"},
        Refused{"[algorithm]\ncruise_mps = 1.7\n", "a.toml:2: algorithm.cruise_mps: must not exceed"},
        Refused{"[algorithm]\narrival_radius_m = 1.6\n", "algorithm.arrival_radius_m: must not exceed"},
        Refused{"[algorithm]\ntoo_close_m = 1.1\n", "algorithm.too_close_m: must not exceed"},
        Refused{"[algorithm]\nkeep_clear_m = -0.1\n", "a.toml:2: algorithm.keep_clear_m: must"},
        Refused{"[algorithm]\nwait_tells_place = 1\n", "a.toml:2: algorithm.wait_tells_place: must be"},
        Refused{"[algorithm]\ncorridor_m = 0.3\n", "algorithm.corridor_m: must not be less"},
        Refused{"[algorithm]\nsurface_memory_s = 19.0\n", "algorithm.surface_memory_s: must not be less"},
        Refused{"[algorithm.driving]\nspeed = 1.0\n", "a.toml:2: algorithm.driving.speed: unknown key"},
        Refused{"[algorithm]\ndriving = 1.0\n", "a.toml:2: algorithm.driving: must be a table"},
        Refused{"[algorithm.keep_clear]\nturns_radps = []\n",
                "a.toml:2: algorithm.keep_clear.turns_radps: must be a list of 1 to 32 numbers"},
        Refused{"[algorithm.keep_clear]\nturns_radps = [0.7, \"left\"]\n",
                "a.toml:2: algorithm.keep_clear.turns_radps: must be a number"},
        Refused{"[algorithm.sharing]\nrest_s = 0.05\n", "a.toml:2: algorithm.sharing.rest_s: must be 0.1"}));

TEST(AgentConfig, TheWorldIsNotRead) {
  const auto scenario = TomlDocument::parse("[world]\nthis_is_nobodys_business = true\n", "a.toml");
  EXPECT_NO_THROW((void)load_config(scenario, 1));
}

}  // namespace
}  // namespace caravan::agent
