// SPDX-License-Identifier: Apache-2.0
// Flocking: robots that start in all directions come to drive in one. After A. E. Turgut, H. Celikkanat,
// F. Gokce, E. Sahin, "Self-organized flocking in mobile robot swarms", Swarm Intelligence 2 (2008), 97-120:
// each robot tells its neighbours its heading by radio (their virtual heading sensor) and turns to the mean
// of the headings it hears, while its sonars keep it off whatever is near. docs/flocking.md.
#include <algorithm>
#include <caravan/controller.hpp>
#include <cmath>
#include <complex>
#include <map>
#include <optional>

namespace {

using Vector = std::complex<double>;  // in frame W or B: x + iy; std::polar(1.0, yaw) is a direction

/// What a robot tells its neighbours: 13 bytes, numbers with the least significant byte first.
struct Presence {
  std::uint16_t robot = 0;
  double yaw_rad = 0.0;    // sent in units of 0.1 mrad
  Vector position_m{0.0};  // sent in mm
};

constexpr std::uint8_t kPresence = 0xf1;  // the first byte; other frames are not ours
constexpr std::size_t kPresenceSize = 13;

void append(std::vector<std::uint8_t>& bytes, std::int64_t number, int size) {
  for (int i = 0; i < size; ++i) bytes.push_back(static_cast<std::uint8_t>(number >> (8 * i)));
}

std::vector<std::uint8_t> encode(const Presence& presence) {
  std::vector<std::uint8_t> bytes{kPresence};
  append(bytes, presence.robot, 2);
  append(bytes, std::lround(presence.yaw_rad * 1e4), 2);
  append(bytes, std::lround(presence.position_m.real() * 1e3), 4);
  append(bytes, std::lround(presence.position_m.imag() * 1e3), 4);
  return bytes;
}

std::optional<Presence> decode(const std::vector<std::uint8_t>& bytes) {
  if (bytes.size() != kPresenceSize || bytes[0] != kPresence) return std::nullopt;
  const auto word = [&bytes](std::size_t at, int size) {
    std::uint32_t number = 0;
    for (int i = size; i-- > 0;) number = number << 8U | bytes[at + static_cast<std::size_t>(i)];
    return number;
  };
  return Presence{
      static_cast<std::uint16_t>(word(1, 2)), static_cast<std::int16_t>(word(3, 2)) * 1e-4,
      Vector{static_cast<std::int32_t>(word(5, 4)) * 1e-3, static_cast<std::int32_t>(word(9, 4)) * 1e-3}};
}

Vector unit(Vector vector) { return std::abs(vector) > 0.0 ? vector / std::abs(vector) : Vector{0.0}; }

class Flocking final : public caravan::Controller {
 public:
  Flocking(const caravan::Robot& robot, caravan::Parameters& parameters)
      : robot_{robot},
        cruise_mps_{parameters.number("cruise_mps", 0.4, {0.01, 1.6})},
        turn_gain_per_s_{parameters.number("turn_gain_per_s", 3.0, {0.0, 10.0})},
        sight_m_{parameters.number("sight_m", 1.2, {0.1, 5.0})},
        repulsion_{parameters.number("repulsion", 6.0, {0.0, 100.0})},
        cohesion_{parameters.number("cohesion", 0.3, {0.0, 100.0})},
        period_s_{parameters.number("period_s", 0.1, {0.0, 10.0})},
        memory_s_{parameters.number("memory_s", 0.5, {0.0, 60.0})} {}

  caravan::Outputs step(const caravan::Inputs& inputs) override {
    const double yaw_rad = inputs.sensors.yaw_rad;
    const Vector position_m{inputs.sensors.position.x_m, inputs.sensors.position.y_m};
    const double now_s = std::chrono::duration<double>(inputs.now).count();
    caravan::Outputs outputs;
    // Without compass or GPS there is nothing to tell, and no frame to steer in: it stands.
    if (!std::isfinite(yaw_rad) || !std::isfinite(std::abs(position_m))) return outputs;
    listen(inputs.heard, now_s);
    if (now_s >= next_s_) {
      next_s_ = now_s + period_s_;
      outputs.frames.push_back({0, encode({static_cast<std::uint16_t>(robot_.id), yaw_rad, position_m})});
    }
    const Vector ahead = std::polar(1.0, yaw_rad);
    const Vector wanted = alignment(ahead) + cohesion_ * cohesion(position_m) +
                          repulsion_ * ahead * repulsion(inputs.sensors.sonar_range_m);
    drive(unit(wanted) / ahead, outputs);  // in frame B
    // Without a report the metrics count it as idle. One is enough, because it is driving from now on.
    if (!has_reported_) outputs.report = caravan::Report{};
    has_reported_ = true;
    return outputs;
  }

 private:
  struct Neighbour {
    Presence presence;
    double heard_s = 0.0;
  };

  void listen(const std::vector<caravan::ReceivedFrame>& heard, double now_s) {
    for (const caravan::ReceivedFrame& frame : heard) {
      if (const auto presence = decode(frame.bytes)) neighbours_[presence->robot] = {*presence, now_s};
    }
    std::erase_if(neighbours_, [&](const auto& one) { return now_s - one.second.heard_s > memory_s_; });
  }
  /// The mean heading of the robot and those that it hears.
  [[nodiscard]] Vector alignment(Vector ahead) const {
    Vector sum = ahead;
    for (const auto& [id, one] : neighbours_) sum += std::polar(1.0, one.presence.yaw_rad);
    return unit(sum);
  }
  /// Towards the middle of those that it hears; 1 at a metre.
  [[nodiscard]] Vector cohesion(Vector position_m) const {
    Vector sum{0.0};
    for (const auto& [id, one] : neighbours_) sum += one.presence.position_m - position_m;
    return neighbours_.empty() ? sum : sum / static_cast<double>(neighbours_.size());
  }
  /// Away from what the sonars see, in frame B: robots and walls alike.
  [[nodiscard]] Vector repulsion(const std::array<double, caravan::kSonarCount>& range_m) const {
    Vector sum{0.0};
    for (std::size_t i = 0; i < range_m.size(); ++i) {
      if (!(range_m[i] < sight_m_)) continue;  // nothing in sight, or not known
      const double closeness = 1.0 - range_m[i] / sight_m_;
      sum -= std::polar(closeness * closeness, robot_.sonars.mounts[i].heading_rad);
    }
    return sum;
  }
  /// Turns to the direction `wanted`, the faster the farther it is, and drives as far as it already looks
  /// there.
  void drive(Vector wanted, caravan::Outputs& outputs) const {
    const double speed_mps = cruise_mps_ * std::max(0.0, wanted.real());
    const double turn_mps = turn_gain_per_s_ * std::arg(wanted) * robot_.body.track_m / 2.0;
    outputs.left_mps =
        std::clamp(speed_mps - turn_mps, -robot_.body.wheel_limit_mps, robot_.body.wheel_limit_mps);
    outputs.right_mps =
        std::clamp(speed_mps + turn_mps, -robot_.body.wheel_limit_mps, robot_.body.wheel_limit_mps);
  }

  caravan::Robot robot_;
  double cruise_mps_;
  double turn_gain_per_s_;
  double sight_m_;
  double repulsion_;
  double cohesion_;
  double period_s_;
  double memory_s_;
  double next_s_ = 0.0;
  bool has_reported_ = false;
  std::map<std::uint16_t, Neighbour> neighbours_;
};

}  // namespace

CARAVAN_CONTROLLER(Flocking, "flocking")
