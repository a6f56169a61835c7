// SPDX-License-Identifier: Apache-2.0
// The checks of the bridge on positions, lines and addresses, with real processes and real bytes. The tests
// of its reaction times are in tests/unit/bridge.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <cmath>
#include <iostream>

#include "tests/system/bridge/support/cable.hpp"
#include "tests/system/bridge/support/field.hpp"
#include "tests/system/bridge/support/played_agent.hpp"
#include "tests/system/bridge/support/serial_cable.hpp"

namespace caravan::test {
namespace {

using namespace std::chrono_literals;
using ::testing::HasSubstr;
using ::testing::Not;

std::string tcp(std::uint16_t port) { return "tcp:127.0.0.1:" + std::to_string(port); }

class BridgeLine : public Field {
 protected:
  void put_robot_into_world() {
    world_ = start_world(room(1, 0), "1");
    robot_ = start_robot(1);
    ASSERT_TRUE(truth_.is_there()) << world_->output() << robot_.process->output();
    cable_.emplace(robot_.port);
    gps_cable_.emplace(robot_.gps_port);
  }
  /// Starts a bridge on `port` and drives the robot in a circle.
  void drive_by(const std::string& port) {
    agent_.emplace(bus(), 1, drives(0.15, 0.35));
    bridge_ = start_bridge(port, tcp(gps_cable_->port()));
    ASSERT_TRUE(truth_.drives(1)) << bridge_->output() << robot_.process->output();
  }
  void drive() {
    put_robot_into_world();
    drive_by(tcp(cable_->port()));
  }
  [[nodiscard]] std::unique_ptr<Process> start_bridge(const std::string& port, const std::string& gps) const {
    return start("pioneer_bridge", {"--robot", "1", "--port", port, "--gps", gps});
  }
  /// Starts a bridge that must refuse to start. @return its output
  [[nodiscard]] std::string refused(const std::string& port, const std::string& gps) const {
    auto bridge = start_bridge(port, gps);
    EXPECT_EQ(bridge->wait(kPatience), 2) << bridge->output();
    return bridge->output();
  }

  std::unique_ptr<Process> world_;
  Robot robot_;
  Truth truth_{bus()};
  std::optional<Cable> cable_;
  std::optional<Cable> gps_cable_;
  std::optional<PlayedAgent> agent_;
  std::unique_ptr<Process> bridge_;
};

/// The same sentences with the latitude 48 changed to 01 and with correct checksums.
std::vector<std::uint8_t> in_the_south(const std::vector<std::uint8_t>& bytes) {
  std::string text{bytes.begin(), bytes.end()};
  for (std::size_t at = 0; (at = text.find(",48", at)) != std::string::npos; ++at) {
    const std::size_t begin = text.rfind('$', at);
    const std::size_t star = text.find('*', at);
    if (begin == std::string::npos || star == std::string::npos || star + 2 >= text.size()) continue;
    text.replace(at, 3, ",01");
    unsigned sum = 0;
    for (std::size_t i = begin + 1; i < star; ++i) sum ^= static_cast<unsigned char>(text[i]);
    const char* const digits = "0123456789ABCDEF";
    text[star + 1] = digits[sum / 16];
    text[star + 2] = digits[sum % 16];
  }
  return {text.begin(), text.end()};
}

TEST_F(BridgeLine, AWrongLatitudeWithARightChecksumStopsTheRobotAndIsTold) {
  drive();
  gps_cable_->change(in_the_south);
  EXPECT_TRUE(bridge_->prints("km from the arena's origin refused", kPatience)) << bridge_->output();
  EXPECT_TRUE(truth_.rests(1)) << bridge_->output();
  for (const auto& frame : agent_->frames())
    EXPECT_FALSE(std::abs(frame.gps_x_m()) >= 100.0) << "NaN or near";
  gps_cable_->change([](const auto& bytes) { return bytes; });
  EXPECT_TRUE(truth_.drives(1)) << bridge_->output();
}

TEST_F(BridgeLine, CutFromHostToRobotAloneIsToldAndTheRobotRests) {
  drive();
  cable_->set(Cable::State::kOneWay);
  EXPECT_TRUE(bridge_->prints("does not receive ours (cut from host to robot?)", kPatience))
      << bridge_->output();
  EXPECT_TRUE(truth_.rests(1)) << bridge_->output();
  cable_->set(Cable::State::kWhole);
  EXPECT_TRUE(truth_.drives(1)) << bridge_->output();
}

TEST_F(BridgeLine, TooSlowForTheRobotsPacketsIsToldAndTheRobotRests) {
  drive();
  const auto before = truth_.of(1);
  cable_->set(Cable::State::kSlow);
  EXPECT_TRUE(bridge_->prints("late or not at all: its line is too slow", kPatience)) << bridge_->output();
  EXPECT_TRUE(truth_.rests(1)) << bridge_->output();
  const auto after = truth_.of(1);
  std::cout << "came " << std::hypot(after->x_m() - before->x_m(), after->y_m() - before->y_m())
            << " m away\n";
}

TEST_F(BridgeLine, IsNotSharedWithAnotherBridgeOfThisMachine) {
  drive();
  EXPECT_THAT(refused(tcp(cable_->port()), "none"), HasSubstr("is in use by another bridge (pid "));
  EXPECT_THAT(refused("tcp:127.0.0.1:1", tcp(gps_cable_->port())), HasSubstr("--gps: tcp:127.0.0.1:"));
  EXPECT_THAT(bridge_->output(), Not(HasSubstr("trying again"))) << "the first one goes on";
  EXPECT_TRUE(truth_.drives(1)) << bridge_->output();
}

TEST_F(BridgeLine, OfTwoBridgesForOneRobotTheSecondEndsAndNamesTheFirst) {
  drive();
  EXPECT_THAT(
      refused("tcp:127.0.0.1:1", "none"),
      HasSubstr("robot 1 is already served by pioneer_bridge 1, pid " + std::to_string(bridge_->pid())));
  EXPECT_TRUE(truth_.drives(1)) << bridge_->output();
  EXPECT_THAT(bridge_->output(), Not(HasSubstr("sample refused")));
}

TEST_F(BridgeLine, ATerminalIsNotSharedWithAnotherBridgeEither) {
  if (const std::string reason = no_terminals_because(); !reason.empty()) {
    GTEST_SKIP() << "no pseudo-terminals here: " << reason;
  }
  put_robot_into_world();
  const SerialCable serial{robot_.port, B9600};
  drive_by(serial.path());
  const std::string link = folder_ / "ttyRobot";
  std::filesystem::create_symlink(serial.path(), link);
  EXPECT_THAT(refused(link, "none"), HasSubstr("is in use by another bridge (pid "));
  EXPECT_TRUE(truth_.drives(1)) << bridge_->output();
}

// Root may open the terminal regardless, except as root of its own user namespace.
TEST_F(BridgeLine, ATerminalIsNotOpenedByOtherPrograms) {
  if (const std::string reason = no_terminals_because(); !reason.empty()) {
    GTEST_SKIP() << "no pseudo-terminals here: " << reason;
  }
  const std::vector<std::string> as_no_root{"/usr/bin/unshare", "--user", "--map-root-user", "/bin/sh", "-c"};
  const auto ended = [&](const std::string& script) {
    std::vector<std::string> command = as_no_root;
    command.push_back(script);
    deploy::Process other{command, folder_ / "other.log"};
    return std::pair{other.wait(kPatience), other.output()};
  };
  if (ended("true").first != 0) GTEST_SKIP() << "no namespaces of users here";
  put_robot_into_world();
  const SerialCable serial{robot_.port, B9600};
  ASSERT_EQ(ended(": < " + serial.path().string()).first, 0) << "before the bridge has it";
  drive_by(serial.path());
  EXPECT_THAT(ended(": < " + serial.path().string()).second, HasSubstr("busy"));
}

class Addresses : public BridgeLine {
 protected:
  void SetUp() override { write_file(scenario_file(), room(1, 0)); }
};

TEST_F(Addresses, ThatCannotBeAreRefused) {
  EXPECT_THAT(refused("tcp:127.0.0.1:99999", "none"), HasSubstr("the port must be 1 to 65535, is \"99999\""));
  EXPECT_THAT(refused("tcp:127.0.0.1:0", "none"), HasSubstr("--port"));
  EXPECT_THAT(refused("tcp:127.0.0.1:81o1", "none"), HasSubstr("--port"));
  EXPECT_THAT(refused("/dev/x", "tcp:127.0.0.1:-1"), HasSubstr("--gps"));
  EXPECT_THAT(refused("/dev/x", "/dev/x"), HasSubstr("--gps: /dev/x is the robot's --port;"));
  EXPECT_THAT(refused("tcp:localhost:8101", "tcp:127.0.0.1:8101"),
              HasSubstr("--gps: tcp:127.0.0.1:8101 is the robot's --port (tcp:localhost:8101)"));
  EXPECT_THAT(refused("tcp:no.such.host.invalid:8101", "none"),
              HasSubstr("unknown host no.such.host.invalid"));
}

TEST_F(Addresses, ThatAreNoSerialLineAreRefused) {
  const std::string file = folder_ / "file";
  write_file(file, "");
  for (const std::string& path : {std::string{"/dev/null"}, std::string{"/"}, file}) {
    EXPECT_THAT(refused(path, "none"), HasSubstr(path + ": not a serial line"));
    EXPECT_THAT(refused("tcp:127.0.0.1:1", path), HasSubstr("GPS " + path + ": not a serial line"));
    const auto modem = start("radio_modem_bridge", {"--robot", "1", "--modem", path});
    EXPECT_EQ(modem->wait(kPatience), 2) << modem->output();
    EXPECT_THAT(modem->output(), HasSubstr("modem " + path + ": not a serial line"));
  }
  const auto bridge = start_bridge(folder_ / "not_plugged_in_yet", "none");
  EXPECT_TRUE(bridge->prints("No such file or directory, trying again", kPatience)) << bridge->output();
}

/// The accept queue of the port is full, so the kernel drops new connections.
TEST_F(Addresses, ThatDropConnectionsAreToldWithinSeconds) {
  const Socket listener{socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)};
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  auto* name = reinterpret_cast<sockaddr*>(&address);
  ASSERT_EQ(bind(listener.descriptor(), name, size), 0);
  ASSERT_EQ(listen(listener.descriptor(), 0), 0);
  ASSERT_EQ(getsockname(listener.descriptor(), name, &size), 0);
  std::vector<Socket> crowd;
  for (int i = 0; i < 4; ++i) {
    crowd.emplace_back(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
    (void)connect(crowd.back().descriptor(), name, size);
  }
  auto bridge = start_bridge(tcp(ntohs(address.sin_port)), "none");
  EXPECT_TRUE(bridge->prints("no answer to the connection within 1 s", kPatience)) << bridge->output();
}

}  // namespace
}  // namespace caravan::test
