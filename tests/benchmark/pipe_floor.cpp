// SPDX-License-Identifier: Apache-2.0
// A lower bound for the cost of the lockstep: the same processes, messages and barrier over pipes instead of
// DDS.
//
// Each receiver has one pipe to which all its senders write. A message is a small header and as many bytes as
// the DDS sample has. World, radio and agents compute nothing, unless --world-us makes the world compute.
// Prints steps per second.
#include <sys/wait.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <array>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using Clock = std::chrono::steady_clock;

enum class Kind : std::uint8_t { kSensors, kCommand, kTransmit, kReceive, kTruth, kRadioStep };

struct Header {
  std::uint32_t stamp;
  std::uint16_t bytes;
  Kind kind;
  bool radio_due;
};

// Serialized sizes of the DDS samples with 15 robots, in bytes.
constexpr std::uint16_t kSensorBytes = 332;
constexpr std::uint16_t kCommandBytes = 44;
constexpr std::uint16_t kTransmitBytes = 52;
constexpr std::uint16_t kReceiveBytes = 60;
constexpr std::uint16_t kRadioStepBytes = 56;
constexpr std::uint16_t truth_bytes(unsigned robots) { return static_cast<std::uint16_t>(60 + 36 * robots); }

struct Options {
  unsigned robots = 15;
  unsigned steps = 3000;
  unsigned world_us = 0;
  double receiving_share = 0.3;  // of the robots, in each step
};

class Pipe {
 public:
  Pipe() {
    if (pipe(ends_.data()) != 0) throw std::runtime_error{"pipe"};
  }
  void send(Header header) const {
    std::array<char, 4096> buffer{};
    std::copy_n(reinterpret_cast<const char*>(&header), sizeof header, buffer.data());
    const std::size_t size = sizeof header + header.bytes;
    if (write(ends_[1], buffer.data(), size) != static_cast<ssize_t>(size)) std::_Exit(1);
  }
  [[nodiscard]] Header receive() const {
    Header header{};
    read_fully(&header, sizeof header);
    std::array<char, 4096> buffer{};
    read_fully(buffer.data(), header.bytes);
    return header;
  }

 private:
  void read_fully(void* to, std::size_t size) const {
    auto* bytes = static_cast<char*>(to);
    while (size > 0) {
      const ssize_t got = read(ends_[0], bytes, size);
      if (got <= 0) std::_Exit(1);
      bytes += got;
      size -= static_cast<std::size_t>(got);
    }
  }
  std::array<int, 2> ends_{};
};

bool receives(unsigned robot, std::uint32_t stamp, const Options& options) {
  const unsigned share = static_cast<unsigned>(options.receiving_share * 100.0);
  return stamp > 0 && (robot * 37U + stamp * 61U) % 100U < share;
}

void run_agent(unsigned robot, const Options& options, const Pipe& own, const Pipe& world,
               const Pipe& radio) {
  for (std::uint32_t stamp = 0; stamp < options.steps; ++stamp) {
    bool sensed = false;
    bool heard = !receives(robot, stamp, options);
    while (!sensed || !heard) {
      (own.receive().kind == Kind::kSensors ? sensed : heard) = true;
    }
    world.send({stamp, kCommandBytes, Kind::kCommand, false});
    radio.send({stamp, kTransmitBytes, Kind::kTransmit, false});
  }
}

void run_radio(const Options& options, const Pipe& own, const Pipe& world, const std::vector<Pipe>& agents) {
  for (std::uint32_t stamp = 0; stamp < options.steps; ++stamp) {
    for (unsigned samples = 0; samples < options.robots + 1; ++samples) (void)own.receive();
    world.send({stamp, kRadioStepBytes, Kind::kRadioStep, false});
    for (unsigned robot = 0; robot < options.robots; ++robot) {
      if (receives(robot, stamp + 1, options) && stamp + 1 < options.steps) {
        agents[robot].send({stamp + 1, kReceiveBytes, Kind::kReceive, false});
      }
    }
  }
}

void spend(std::chrono::microseconds time) {
  const auto until = Clock::now() + time;
  while (Clock::now() < until) {
  }
}

void run_world(const Options& options, const Pipe& own, const Pipe& radio, const std::vector<Pipe>& agents) {
  for (std::uint32_t stamp = 0; stamp < options.steps; ++stamp) {
    for (unsigned robot = 0; robot < options.robots; ++robot) {
      agents[robot].send({stamp, kSensorBytes, Kind::kSensors, receives(robot, stamp, options)});
    }
    radio.send({stamp, truth_bytes(options.robots), Kind::kTruth, false});
    for (unsigned samples = 0; samples < options.robots + 1; ++samples) (void)own.receive();
    spend(std::chrono::microseconds{options.world_us});
  }
}

double steps_per_second(const Options& options) {
  const Pipe world;
  const Pipe radio;
  const std::vector<Pipe> agents(options.robots);
  const auto in_child = [](auto&& work) {
    if (fork() != 0) return;
    work();
    std::_Exit(0);
  };
  for (unsigned robot = 0; robot < options.robots; ++robot) {
    in_child([&] { run_agent(robot, options, agents[robot], world, radio); });
  }
  in_child([&] { run_radio(options, radio, world, agents); });
  const auto began = Clock::now();
  run_world(options, world, radio, agents);
  const double seconds = std::chrono::duration<double>(Clock::now() - began).count();
  while (wait(nullptr) > 0) {
  }
  return options.steps / seconds;
}

int run(int argc, const char* const* argv) {
  Options options;
  CLI::App app{"Steps per second of the lockstep over pipes: the floor that DDS is measured against"};
  app.add_option("--robots", options.robots, "Agents, one process each")->check(CLI::Range(1, 110));
  app.add_option("--steps", options.steps, "Steps to run");
  app.add_option("--world-us", options.world_us, "Microseconds that the world computes in each step");
  app.add_option("--receiving-share", options.receiving_share,
                 "Share of the robots that hear something in a step")
      ->check(CLI::Range(0.0, 1.0));
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error);
  }
  std::printf("%.0f\n", steps_per_second(options));
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
