// SPDX-License-Identifier: Apache-2.0
#include "deploy/control/words.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>

namespace caravan::deploy {
namespace {

namespace msg = caravan_interfaces::msg;
namespace kind = msg::ControlRequest_Constants;

template <typename Number>
std::optional<Number> parsed(const std::string& text) {
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return number;
}

/// Parses `3` or `1-4` and appends the robots.
void append_robots(const std::string& part, std::vector<std::uint32_t>& robots) {
  const std::size_t dash = part.find('-');
  const auto first = parsed<std::uint32_t>(part.substr(0, dash));
  const auto last = dash == std::string::npos ? first : parsed<std::uint32_t>(part.substr(dash + 1));
  if (!first || !last || *first < 1 || *last < *first || *last - *first > 10'000)
    throw WordsError{"\"" + part + "\" is not a robot: write 3, 1,2, 1-4 or all"};
  for (std::uint32_t robot = *first; robot <= *last; ++robot) robots.push_back(robot);
}

void read_links(Words& words, msg::ControlRequest& request) {
  if (words.take_if("area")) {
    request.in_area(true);
    request.area_low_x_m(words.number("the area's lower left x"));
    request.area_low_y_m(words.number("the area's lower left y"));
    request.area_high_x_m(words.number("the area's upper right x"));
    request.area_high_y_m(words.number("the area's upper right y"));
    return;
  }
  request.robots(words.robots());
  if (!words.is_empty() && words.peek() != "at") request.others(words.robots());
  if (request.robots().size() == 1 && request.others() == request.robots())
    throw WordsError{"robot " + std::to_string(request.robots()[0]) +
                     " has no link to itself: name two robots"};
}

double read_loss(Words& words) {
  const std::string text = words.word("the loss");
  const auto loss = parsed<double>(text);
  if (!loss || !(*loss >= 0.0 && *loss <= 1.0))
    throw WordsError{"the loss must be a number from 0 to 1, is \"" + text + "\""};
  return *loss;
}

void read_radio(Words& words, msg::ControlRequest& request) {
  request.action(kind::RADIO_OVERRIDE);
  if (words.take_if("clear")) {
    request.action(kind::RADIO_CLEAR);
    return;
  }
  if (words.take_if("cut")) {
    request.loss_probability(1.0);
  } else if (words.take_if("degrade")) {
    request.loss_probability(read_loss(words));
  } else if (words.take_if("heal")) {
    request.loss_probability(std::numeric_limits<double>::quiet_NaN());
  } else {
    throw WordsError{"radio must be followed by cut, degrade, heal or clear, not \"" + words.peek() + "\""};
  }
  read_links(words, request);
}

template <std::uint8_t action>
void read_place(Words& words, msg::ControlRequest& request) {
  request.action(action);
  request.robots({words.robot()});
  request.x_m(words.number("x"));
  request.y_m(words.number("y"));
  if (!words.is_empty() && words.peek() != "at") request.yaw_rad(words.number("the yaw"));
}

void read_speed(Words& words, msg::ControlRequest& request) {
  request.action(kind::SPEED);
  if (!words.take_if("max")) request.speed_factor(words.number("the speed"));
}

void read_steps(Words& words, msg::ControlRequest& request) {
  request.action(kind::STEP);
  const std::uint64_t steps =
      words.is_empty() || words.peek() == "at" ? 1 : words.count("the number of steps", 1);
  request.steps(static_cast<std::uint32_t>(steps));
}

template <std::uint8_t action>
void read_plain(Words& /*words*/, msg::ControlRequest& request) {
  request.action(action);
}

template <std::uint8_t action>
void read_robot(Words& words, msg::ControlRequest& request) {
  request.action(action);
  request.robots({words.robot()});
}

struct Verb {
  std::string_view verb;
  void (*read)(Words&, msg::ControlRequest&);
};

constexpr std::array kVerbs{Verb{"pause", read_plain<kind::PAUSE>},
                            Verb{"resume", read_plain<kind::RESUME>},
                            Verb{"step", read_steps},
                            Verb{"speed", read_speed},
                            Verb{"teleport", read_place<kind::TELEPORT>},
                            Verb{"hold", read_robot<kind::HOLD>},
                            Verb{"release", read_robot<kind::RELEASE>},
                            Verb{"spawn", read_place<kind::SPAWN>},
                            Verb{"remove", read_robot<kind::REMOVE>},
                            Verb{"radio", read_radio}};

constexpr std::array kForms{
    ControlForm{"pause", "no step starts until resume or step"},
    ControlForm{"resume", "continues with the steps"},
    ControlForm{"step [N]", "a paused world takes N steps (default 1) and is paused again"},
    ControlForm{"speed X", "X times real time, 0.001 to 1000; `speed max`: as fast as possible"},
    ControlForm{"teleport ROBOT X Y [YAW]", "moves a robot to another place, at rest; metres, radians"},
    ControlForm{"hold ROBOT", "blocks a robot's wheels, whatever it commands"},
    ControlForm{"release ROBOT", "ends `hold`"},
    ControlForm{"spawn ROBOT X Y [YAW]", "puts a removed robot back into the world, at rest"},
    ControlForm{"remove ROBOT", "takes a robot out of the world; its agent waits until it is spawned"},
    ControlForm{"radio cut ROBOTS [ROBOTS]",
                "no frame passes between the two sets; with one set, none between it and any robot"},
    ControlForm{"radio cut area X0 Y0 X1 Y1", "the same for links with an end in a rectangle"},
    ControlForm{"radio degrade LOSS ROBOTS [ROBOTS]",
                "loses each frame with this probability; `area` as in cut"},
    ControlForm{"radio heal ROBOTS [ROBOTS]", "restores the scenario's radio; `area` as in cut"},
    ControlForm{"radio clear", "heals all links"},
};

}  // namespace

bool Words::take_if(std::string_view word) {
  if (is_empty() || words_[next_] != word) return false;
  ++next_;
  return true;
}

std::string Words::word(const std::string& what) {
  if (is_empty()) throw WordsError{what + " is missing"};
  return words_[next_++];
}

double Words::number(const std::string& what) {
  const std::string text = word(what);
  const auto value = parsed<double>(text);
  if (!value || !std::isfinite(*value)) throw WordsError{what + " must be a number, is \"" + text + "\""};
  return *value;
}

std::uint64_t Words::count(const std::string& what, std::uint64_t lowest) {
  const std::string text = word(what);
  const auto value = parsed<std::uint64_t>(text);
  if (!value || *value < lowest || *value > kHighestStep)
    throw WordsError{what + " must be a whole number from " + std::to_string(lowest) + " to " +
                     std::to_string(kHighestStep) + ", is \"" + text + "\""};
  return *value;
}

std::uint32_t Words::robot() {
  const std::string text = word("the robot's number");
  const auto value = parsed<std::uint32_t>(text);
  if (!value || *value < 1) throw WordsError{"\"" + text + "\" is not a robot's number"};
  return *value;
}

std::vector<std::uint32_t> Words::robots() {
  const std::string text = word("a robot's number, a list or all");
  std::vector<std::uint32_t> robots;
  if (text == "all") return robots;
  std::istringstream parts{text};
  for (std::string part; std::getline(parts, part, ',');) append_robots(part, robots);
  if (robots.empty()) throw WordsError{"a list of robots is empty"};
  return robots;
}

void Words::end() const {
  if (!is_empty()) throw WordsError{"\"" + peek() + "\" is one word too many"};
}

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> words;
  std::string word;
  bool quoted = false;
  bool has_word = false;
  for (const char one : line) {
    if (one == '"') {
      quoted = !quoted;
      has_word = true;
    } else if (one == ' ' && !quoted) {
      if (has_word) words.push_back(std::exchange(word, ""));
      has_word = false;
    } else {
      word += one;
      has_word = true;
    }
  }
  if (quoted) throw WordsError{"a quote is not closed"};
  if (has_word) words.push_back(word);
  return words;
}

std::span<const ControlForm> control_forms() { return kForms; }

std::optional<msg::ControlRequest> read_control(Words words) {
  for (const Verb& verb : kVerbs) {
    if (!words.take_if(verb.verb)) continue;
    msg::ControlRequest request;
    verb.read(words, request);
    if (words.take_if("at")) request.at_step(words.count("the step after `at`", 1));
    words.end();
    return request;
  }
  return std::nullopt;
}

}  // namespace caravan::deploy
