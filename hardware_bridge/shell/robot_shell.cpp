// SPDX-License-Identifier: Apache-2.0
#include "hardware_bridge/shell/robot_shell.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <array>
#include <utility>

#include "runtime/config/start_error.hpp"
#include "runtime/process/data_folder.hpp"
#include "runtime/process/run_process.hpp"

namespace caravan::bridge {
namespace msg = caravan_interfaces::msg;
using runtime::Polled;
using namespace std::chrono_literals;

RobotShell::RobotShell(const RobotConfig& config, std::uint32_t robot, const Ports& ports,
                       const runtime::BusConfig& bus, runtime::Loop& loop)
    : config_{config},
      number_{robot},
      domain_{bus.domain},
      loop_{loop},
      began_{std::chrono::steady_clock::now()},
      robot_port_{ports.robot},
      gps_port_{ports.gps},
      robot_{config},
      gps_{config.arena},
      bus_{bus, [this](const runtime::Discovery& news) { mailbox_.post(news); }},
      sole_{bus_, bus.lease_s, idl::kBodyCommand, robot} {
  commands_ = bus_.writer<msg::RobotCommandPubSubType>(idl::kBodyCommand, robot);
  bus_.reader<msg::SensorFramePubSubType>(
      idl::kBodySensors, robot, [this, robot](const msg::SensorFrame& frame, const runtime::Sender& sender) {
        const std::lock_guard lock{mutex_};
        if (world_.claim(sender) != runtime::Tenure::Standing::kRefused) return on_body(frame);
        bus_.refuse(sender, idl::kBodySensors, robot);
        world_.keep(sender, [this, frame] { on_body(frame); });
      });
  spdlog::info("robot={} hosts on 127.0.0.1:{}, GPS (NMEA 0183) on 127.0.0.1:{}", robot, robot_port_.port(),
               gps_port_.port());
}

RobotShell::~RobotShell() { bus_.close(); }

void RobotShell::read_mailbox() {
  using Kind = runtime::Discovery::Kind;
  for (const runtime::Discovery& news : mailbox_.take()) {
    sole_.see(news, false);  // every process receives the body's frames
    const bool has_left = news.kind == Kind::kGone || news.kind == Kind::kWriterGone;
    if (!has_left || !world_.release(news.participant)) continue;
    for (const runtime::Tenure::Later& take : world_.hand_over()) take();
    if (const auto holder = world_.holder()) bus_.forgive(*holder);
  }
  if (const std::string lost = sole_.lost(); !lost.empty()) throw runtime::StartError{lost};
}

void RobotShell::on_body(const msg::SensorFrame& frame) {
  if (frame.session() < session_) return;
  body_watch_.heard(now());
  if (frame.session() > session_) {
    spdlog::info("switched on: session={}", frame.session());
    session_ = frame.session();
    robot_ = Microcontroller{config_};
    rebooted_ = true;
    loop_.notify();
  }
  robot_.sense({.sonar_range_m = frame.sonar_range_m(),
                .yaw_WB_rad = frame.compass_yaw_rad(),
                .left_wheel_rad = frame.left_wheel_rad(),
                .right_wheel_rad = frame.right_wheel_rad(),
                .holding = frame.holding(),
                .measured = idl::to_time(frame.stamp())},
               now());
  const Pose pose{{frame.gps_x_m(), frame.gps_y_m()}, frame.compass_yaw_rad()};
  gps_.sense(antenna_place(pose, config_.antenna_B), idl::to_time(frame.stamp()));
  answer(frame);
}

void RobotShell::answer(const msg::SensorFrame& frame) {
  if (sole_.must_be_silent()) return;
  const BodyDrive drive = robot_.drive(now());
  msg::RobotCommand command;
  command.stamp(frame.stamp());
  command.session(frame.session());
  command.left_mps(drive.left_mps);
  command.right_mps(drive.right_mps);
  command.gripper_closed(drive.gripper_closed);
  if (!commands_.write(command) && refused_writes_++ == 0)
    spdlog::error("DDS refused a sample: the body stops");
}

int RobotShell::run() {
  for (;;) {
    std::array<Polled, 4> watched{robot_port_.watched(), gps_port_.watched(), host_.watched(),
                                  gps_client_.watched()};
    if (loop_.wait(next_deadline(), watched) == runtime::Loop::Woken::kStop) return runtime::kDone;
    tell_whether_a_body_is_there();
    attend_robot(watched[0].ready, watched[2].ready);
    attend_gps(watched[1].ready, watched[3].ready);
  }
}

runtime::WallTime RobotShell::next_deadline() const {
  const std::lock_guard lock{mutex_};
  Time due = body_watch_.next_look();
  if (const auto clash = sole_.next_deadline()) due = std::min(due, Time{*clash - began_});
  if (robot_.is_open()) due = std::min(due, robot_.next_deadline());
  if (const auto packet = robot_.expects_packet_by()) due = std::min(due, *packet);
  if (gps_client_.is_open()) due = std::min(due, gps_.next_deadline());
  return began_ + due;
}

void RobotShell::tell_whether_a_body_is_there() {
  const std::lock_guard lock{mutex_};
  const auto news = body_watch_.look(now());
  if (!news) return;
  const std::string topic = idl::name_for(idl::kBodySensors, number_);
  if (*news == BodyWatch::News::kNoBody) {
    spdlog::warn(
        "nobody serves {} in DDS domain {}, hosts are turned away: start world_server there with --bodies {} "
        "(without --bodies it serves {})",
        topic, domain_, number_, idl::name_for(idl::kSensors, number_));
  } else {
    spdlog::warn(
        "no frames arrive on {} any more: the world has ended, is paused, or waits for other processes",
        topic);
  }
}

void RobotShell::tell_ignored_commands() {
  for (const std::uint8_t number : robot_.unknown_commands()) {
    if (told_unknown_.insert(number).second)
      spdlog::warn("the host sends command {}, which this robot does not know: ignored, see {}", number,
                   runtime::page("arcos.md"));
  }
  for (const std::uint8_t number : robot_.malformed_commands()) {
    if (told_malformed_.insert(number).second)
      spdlog::warn("the host sends command {} with an argument of a wrong kind or length: ignored", number);
  }
}

void RobotShell::let_in_a_host() {
  auto another = robot_port_.accept();
  if (!another) return;
  // One host at a time; none while the robot has no body, as if switched off.
  if (!host_.is_open() && session_ != 0) {
    host_.adopt(std::move(another->connection));
    host_peer_ = another->peer;
    has_host_ = true;
    robot_.connected(now());
    told_unknown_.clear();
    told_malformed_.clear();
    told_turned_away_ = false;
    spdlog::info("a host has connected: {}", host_peer_);
  } else if (!std::exchange(told_turned_away_, true)) {
    spdlog::info("a host was turned away: {}",
                 host_.is_open() ? host_peer_ + " is connected" : "the robot has no body yet");
  }
}

void RobotShell::let_go_of_a_silent_host() {
  const auto due = robot_.expects_packet_by();
  if (!has_host_ || !due || now() < *due) return;
  spdlog::warn("host {} has sent no ARCOS packet for {} s: disconnected, others may connect", host_peer_,
               Microcontroller::kHostPatience / 1s);
  host_.close();
  has_host_ = false;
  robot_.disconnected();
}

void RobotShell::attend_robot(bool host_waits, bool ready) {
  const std::lock_guard lock{mutex_};
  read_mailbox();
  if (std::exchange(rebooted_, false) && host_.is_open()) {
    spdlog::info("the host's connection ends");
    host_.close();
    has_host_ = false;
  }
  if (ready && host_.is_open()) {
    robot_.receive(host_.attend(), now());
    tell_ignored_commands();
  }
  let_go_of_a_host_that_has_gone();
  let_go_of_a_silent_host();
  // After the end of the previous host, so that a host may reconnect at once.
  if (host_waits) let_in_a_host();
  robot_.tick(now());
  const Bytes output = robot_.take_output();
  if (host_.is_open()) host_.write(output);
  let_go_of_a_host_that_has_gone();
}

void RobotShell::let_go_of_a_host_that_has_gone() {
  if (!has_host_ || host_.is_open()) return;
  has_host_ = false;
  robot_.disconnected();
  spdlog::info("the host has gone: {}", host_.failure());
}

void RobotShell::let_in_a_gps_client() {
  auto another = gps_port_.accept();
  if (!another) return;
  if (!gps_client_.is_open()) {
    gps_client_.adopt(std::move(another->connection));
    gps_peer_ = another->peer;
    told_gps_turned_away_ = false;
  } else if (!std::exchange(told_gps_turned_away_, true)) {
    spdlog::info("a client of the GPS receiver was turned away: {} is connected", gps_peer_);
  }
}

void RobotShell::attend_gps(bool client_waits, bool ready) {
  if (ready) (void)gps_client_.attend();
  // After the end of the previous client, as for hosts.
  if (client_waits) let_in_a_gps_client();
  const std::lock_guard lock{mutex_};
  const std::string lines = gps_.take_lines(now());
  if (session_ != 0 && gps_client_.is_open()) gps_client_.write({lines.begin(), lines.end()});
}

}  // namespace caravan::bridge
