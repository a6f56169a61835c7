// SPDX-License-Identifier: Apache-2.0
#include "tests/system/bridge/support/field.hpp"

#include <signal.h>

#include <algorithm>
#include <cmath>

namespace caravan::test {
namespace {

std::uint16_t number_after(const std::string& text, const std::string& mark) {
  const std::size_t place = text.find(mark);
  if (place == std::string::npos) return 0;
  return static_cast<std::uint16_t>(std::strtoul(text.c_str() + place + mark.size(), nullptr, 10));
}

}  // namespace

std::string room(std::uint32_t robots, std::uint32_t items) {
  return "name = \"field\"\n[robots]\ncount = " + std::to_string(robots) +
         "\nsource_m = [-1.5, -1.5]\ndestination_m = [1.2, 1.2]\n"
         "[algorithm]\ncruise_mps = 0.5\nslow_mps = 0.25\nsharing_starts_s = 5.0\nrecontact_after_s = "
         "600.0\ngripper_patience_s = 3.0\n"
         "[experiment]\nitems = " +
         std::to_string(items) +
         "\nmax_time_s = 900.0\npacing = \"free\"\n"
         "[world]\narena_m = [8.0, 8.0]\nstart_low_m = [-2.3, -2.3]\nstart_high_m = [-0.7, -0.7]\n"
         "[bridge]\norigin_latitude_deg = 48.137\norigin_longitude_deg = 11.575\nx_axis_rad = "
         "0.3\n";
}

void Field::kill_at_once(Process& process) {
  leftovers_.note(process.pid());
  process.signal(SIGKILL);
  (void)process.wait(kPatience);
}

std::unique_ptr<Process> Field::start(const std::string& program, std::vector<std::string> options) const {
  std::vector<std::string> line{program,
                                "--scenario",
                                scenario_file(),
                                "--domain",
                                std::to_string(lock_.domain()),
                                "--lease",
                                std::to_string(short_lease_s())};
  line.insert(line.end(), options.begin(), options.end());
  return std::make_unique<Process>(line, folder_ / (std::to_string(++started_) + "_" + program + ".log"));
}

std::unique_ptr<Process> Field::start_world(const std::string& scenario_text, const std::string& bodies) {
  write_file(scenario_file(), scenario_text);
  if (bodies.empty()) return start("world_server", {});
  return start("world_server", {"--bodies", bodies});
}

Field::Robot Field::start_robot(std::uint32_t number, const Robot* again) const {
  Robot robot;
  robot.process = start("arcos_robot", {"--robot", std::to_string(number), "--port",
                                        std::to_string(again == nullptr ? 0 : again->port), "--gps-port",
                                        std::to_string(again == nullptr ? 0 : again->gps_port)});
  EXPECT_TRUE(robot.process->prints("NMEA 0183) on 127.0.0.1:", kPatience)) << robot.process->output();
  robot.port = number_after(robot.process->output(), "hosts on 127.0.0.1:");
  robot.gps_port = number_after(robot.process->output(), "NMEA 0183) on 127.0.0.1:");
  return robot;
}

std::unique_ptr<Process> Field::start_agent(std::uint32_t number) const {
  return start("robot_agent", {"--robot", std::to_string(number)});
}

Field::BridgedRobot Field::start_bridged(std::uint32_t number) const {
  BridgedRobot made;
  made.robot = start_robot(number);
  made.bridge = start("pioneer_bridge", {"--robot", std::to_string(number), "--port",
                                         "tcp:127.0.0.1:" + std::to_string(made.robot.port), "--gps",
                                         "tcp:127.0.0.1:" + std::to_string(made.robot.gps_port)});
  made.agent = start_agent(number);
  return made;
}

std::optional<caravan_interfaces::msg::RobotTruth> Truth::of(std::uint32_t robot) const {
  const auto samples = truths_.samples();
  if (samples.empty()) return std::nullopt;
  return samples.back().robots().at(robot - 1);
}

std::chrono::nanoseconds Truth::now() const {
  const auto samples = truths_.samples();
  return samples.empty() ? std::chrono::nanoseconds{0} : idl::to_time(samples.back().stamp());
}

std::chrono::nanoseconds Truth::rest_after(std::uint32_t robot, std::chrono::nanoseconds since) const {
  const auto samples = truths_.samples();
  std::chrono::nanoseconds last_moved = since;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const auto& before = samples[i - 1].robots().at(robot - 1);
    const auto& after = samples[i].robots().at(robot - 1);
    const double way = std::hypot(after.x_m() - before.x_m(), after.y_m() - before.y_m());
    const double turn = std::abs(after.yaw_rad() - before.yaw_rad());
    if (way > 1e-4 || turn > 1e-3) last_moved = std::max(last_moved, idl::to_time(samples[i].stamp()));
  }
  return last_moved - since;
}

std::uint32_t Truth::items_delivered() const {
  const auto samples = truths_.samples();
  return samples.empty() ? 0 : samples.back().items_delivered();
}

std::optional<double> Truth::moved_m(std::uint32_t robot, std::chrono::nanoseconds span) const {
  const auto samples = truths_.samples();
  if (samples.empty()) return std::nullopt;
  const auto& now = samples.back();
  const auto& here = now.robots().at(robot - 1);
  const auto then = std::find_if(samples.rbegin(), samples.rend(), [&](const auto& one) {
    return idl::to_time(now.stamp()) - idl::to_time(one.stamp()) >= span;
  });
  if (then == samples.rend()) return std::nullopt;
  const auto& there = then->robots().at(robot - 1);
  return std::hypot(here.x_m() - there.x_m(), here.y_m() - there.y_m());
}

}  // namespace caravan::test
