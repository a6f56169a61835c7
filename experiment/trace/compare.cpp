// SPDX-License-Identifier: Apache-2.0
#include "experiment/trace/compare.hpp"

#include <algorithm>
#include <bit>

#include "experiment/trace/text_of.hpp"

namespace caravan::experiment {
namespace {

const std::string kNone = "none";

bool same(double one, double other) {
  return std::bit_cast<std::uint64_t>(one) == std::bit_cast<std::uint64_t>(other);
}
template <typename Value>
bool same(const Value& one, const Value& other) {
  return one == other;
}

/// Collects the differences of one robot.
class Finder {
 public:
  explicit Finder(std::vector<Difference>& found, std::uint64_t robot = 0) : found_{found}, robot_{robot} {}

  template <typename Value>
  void compare(const std::string& quantity, const Value& one, const Value& other) {
    if (!same(one, other)) found_.push_back({robot_, quantity, text_of(one), text_of(other)});
  }
  void compare(const std::string& quantity, const std::vector<TracedFrame>& one,
               const std::vector<TracedFrame>& other) {
    compare(quantity + ".frames", std::uint64_t{one.size()}, std::uint64_t{other.size()});
    for (std::size_t i = 0; i < std::min(one.size(), other.size()); ++i) {
      const std::string frame = quantity + ".frame_" + std::to_string(i + 1);
      compare(frame + ".channel", one[i].channel, other[i].channel);
      compare(frame + ".bytes", one[i].bytes, other[i].bytes);
    }
  }
  void compare(const std::string& quantity, const TracedTransmission& one, const TracedTransmission& other) {
    compare(quantity + ".tuned_channel", one.tuned, other.tuned);
    compare(quantity, one.frames, other.frames);
  }

 private:
  std::vector<Difference>& found_;
  std::uint64_t robot_;
};

std::string frames_text(const std::vector<TracedFrame>& frames) {
  return std::to_string(frames.size()) + " frames";
}
std::string frames_text(const TracedTransmission& sent) { return frames_text(sent.frames); }

/// Reports robots that only one of the two has, and the differences of those that both have.
template <typename Value>
void compare_by_robot(std::vector<Difference>& found, const std::string& quantity,
                      const std::map<std::uint64_t, Value>& ones,
                      const std::map<std::uint64_t, Value>& others) {
  auto one = ones.begin();
  auto other = others.begin();
  while (one != ones.end() || other != others.end()) {
    if (other == others.end() || (one != ones.end() && one->first < other->first)) {
      found.push_back({one->first, quantity, frames_text(one->second), kNone});
      ++one;
    } else if (one == ones.end() || other->first < one->first) {
      found.push_back({other->first, quantity, kNone, frames_text(other->second)});
      ++other;
    } else {
      Finder{found, one->first}.compare(quantity, one->second, other->second);
      ++one;
      ++other;
    }
  }
}

void compare_poses(std::vector<Difference>& found, const std::string& when,
                   const std::vector<TracedPose>& ones, const std::vector<TracedPose>& others) {
  for (std::size_t i = 0; i < std::min(ones.size(), others.size()); ++i) {
    Finder finder{found, i + 1};
    finder.compare(when + "pose.x_m", ones[i].x_m, others[i].x_m);
    finder.compare(when + "pose.y_m", ones[i].y_m, others[i].y_m);
    finder.compare(when + "pose.yaw_rad", ones[i].yaw_rad, others[i].yaw_rad);
  }
}

void compare_placements(std::vector<Difference>& found, const std::vector<TracedPlacement>& ones,
                        const std::vector<TracedPlacement>& others) {
  Finder{found}.compare("placements", std::uint64_t{ones.size()}, std::uint64_t{others.size()});
  for (std::size_t i = 0; i < std::min(ones.size(), others.size()); ++i) {
    const std::string placement = "placement_" + std::to_string(i + 1) + ".";
    Finder{found}.compare(placement + "robot", ones[i].robot, others[i].robot);
    compare_poses(found, placement, ones[i].poses, others[i].poses);
  }
}

void compare_commands(std::vector<Difference>& found, const WorldStep& one, const WorldStep& other) {
  Finder{found}.compare("step.number", one.number, other.number);
  for (std::size_t i = 0; i < std::min(one.commands.size(), other.commands.size()); ++i) {
    Finder finder{found, i + 1};
    finder.compare("command.given", one.commands[i].given, other.commands[i].given);
    finder.compare("command.left_mps", one.commands[i].left_mps, other.commands[i].left_mps);
    finder.compare("command.right_mps", one.commands[i].right_mps, other.commands[i].right_mps);
    finder.compare("command.gripper_closed", one.commands[i].gripper_closed,
                   other.commands[i].gripper_closed);
  }
}

void compare_air(std::vector<Difference>& found, const RadioStep& one, const RadioStep& other) {
  Finder{found}.compare("step.stamp_ns", one.stamp_ns, other.stamp_ns);
  compare_by_robot(found, "transmission", one.sent, other.sent);
  compare_by_robot(found, "delivery", one.heard, other.heard);
}

TracedTransmission to_transmission(const caravan::Outputs& outputs) {
  TracedTransmission transmission{outputs.tuned_channel, {}};
  for (const caravan::Frame& frame : outputs.frames)
    transmission.frames.push_back({frame.channel, frame.bytes});
  return transmission;
}

}  // namespace

std::vector<Difference> differences(const TracedStep& one, const TracedStep& other) {
  std::vector<Difference> found;
  compare_placements(found, one.world.placements, other.world.placements);
  compare_commands(found, one.world, other.world);
  compare_air(found, one.radio, other.radio);
  compare_poses(found, "", one.world.poses, other.world.poses);
  return found;
}

std::vector<Difference> differences(std::uint64_t robot, const caravan::Outputs& one,
                                    const caravan::Outputs& other) {
  std::vector<Difference> found;
  Finder finder{found, robot};
  // + 0.0 makes -0 to +0: the wheels do the same.
  finder.compare("answer.left_mps", one.left_mps + 0.0, other.left_mps + 0.0);
  finder.compare("answer.right_mps", one.right_mps + 0.0, other.right_mps + 0.0);
  finder.compare("answer.gripper_closed", one.gripper_closed, other.gripper_closed);
  finder.compare("answer", to_transmission(one), to_transmission(other));
  return found;
}

}  // namespace caravan::experiment
