// SPDX-License-Identifier: Apache-2.0
#include "tests/system/hosts/fleet.hpp"

#include <gtest/gtest.h>
#include <signal.h>

#include <regex>

namespace caravan::test {

using namespace std::chrono_literals;

namespace {

std::string name_of(const std::string& program, const std::string& robots) {
  return robots.empty() ? program : program + "_" + robots;
}

}  // namespace

FleetStatus read_status(const std::string& text) {
  static const std::regex kHead{
      R"((\w+)  steps (\d+)  simulated [0-9.]+ s  members (\d+)  items \d+(  disturbed)?)"};
  static const std::regex kGone{R"(gone (.*))"};
  FleetStatus status;
  std::smatch head, gone;
  status.answered = std::regex_search(text, head, kHead) && std::regex_search(text, gone, kGone);
  if (!status.answered) return status;
  status.state = head[1];
  status.steps = std::stoull(head[2]);
  status.members = static_cast<std::uint32_t>(std::stoul(head[3]));
  status.disturbed = head[4].matched;
  status.gone = gone[1];
  return status;
}

void Fleet::start(const Starter& starter, const std::string& program, const std::string& robots) {
  std::vector<std::string> line{program, "--scenario", scenario_};
  line.insert(line.end(), options_.begin(), options_.end());
  if (!robots.empty()) line.insert(line.end(), {"--robots", robots});
  const std::string name = name_of(program, robots);
  processes_[name] = starter(line, name);
}

void Fleet::kill(const std::string& program, const std::string& robots) {
  PatientProcess& victim = process(program, robots);
  victim.signal(SIGKILL);
  EXPECT_EQ(victim.wait(20s), 128 + SIGKILL);
}

PatientProcess& Fleet::process(const std::string& program, const std::string& robots) {
  return *processes_.at(name_of(program, robots));
}

FleetStatus Fleet::watch(const Starter& starter, const std::function<bool(const FleetStatus&)>& wanted) {
  Patience patience{kPatience};
  FleetStatus newest;
  while (!patience.is_over() && has_world()) {
    std::vector<std::string> line{"caravan", "ctl"};
    for (std::size_t i = 0; i + 1 < options_.size(); i += 2) {
      if (options_[i] != "--lease") line.insert(line.end(), {options_[i], options_[i + 1]});
    }
    line.emplace_back("status");
    const auto ctl = starter(line, "ctl");
    (void)ctl->wait(30s);
    newest = read_status(ctl->output());
    if (wanted(newest)) break;
  }
  return newest;
}

std::string Fleet::digest(std::chrono::milliseconds patience) {
  const PatientProcess& world = process("world_server");
  static const std::regex kFinished{R"(finished sim_s=.* digest=([0-9a-f]+))"};
  std::smatch found;
  std::string text;
  const auto has_finished = [&] {
    text = world.output();
    return std::regex_search(text, found, kFinished);
  };
  (void)eventually([&] { return has_finished() || !has_world(); }, patience);
  return has_finished() ? found[1].str() : "";
}

bool Fleet::has_world() {
  PatientProcess& world = process("world_server");
  const auto code = world.wait(0ms);
  if (code) ADD_FAILURE() << "the world has ended with exit code " << *code << ":\n" << world.output();
  return !code;
}

std::vector<std::string> Fleet::ended() {
  std::vector<std::string> names;
  for (const auto& [name, process] : processes_) {
    if (process->wait(0ms)) names.push_back(name + ": " + process->output());
  }
  return names;
}

}  // namespace caravan::test
