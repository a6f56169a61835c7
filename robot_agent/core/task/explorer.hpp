// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <variant>

#include "robot_agent/core/navigation/driver.hpp"
#include "robot_agent/core/path/recording.hpp"
#include "robot_agent/core/task/notes.hpp"
#include "robot_agent/core/task/settings.hpp"

namespace caravan::agent {

struct ExplorerSettings {
  Task task;
  Exploration exploration;
  RecordingSettings recording;
  Passage passage;
  Body body;
};

/// A robot without a path: Algorithm 1, lines 3 to 10. It explores, records its path and looks for the
/// destination.
///
///   state       | destination seen | obstacle, touch      | location reached | destination reached
///   ------------+------------------+----------------------+------------------+--------------------
///   Searching   | Approaching      | new location         | new location     | -
///   Approaching | -                | Searching for a time | -                | found
///
/// A location is replaced after Exploration::location_timeout. Approaching ends when the destination has been
/// out of sight for Exploration::out_of_sight.
class Explorer {
 public:
  explicit Explorer(const ExplorerSettings& settings);

  [[nodiscard]] Motion step(const Perception& seen, Driver& driver, pure::Random& random);
  /// The path from the source to the destination, after arrival there.
  [[nodiscard]] const std::optional<Path>& found() const { return found_; }

 private:
  struct Searching {
    std::optional<Point> location;
    Time give_up{0};
  };
  struct Approaching {
    Point destination;
    Time last_seen;
  };
  [[nodiscard]] Motion search(Searching& state, const Perception& seen, Driver& driver, pure::Random& random);
  [[nodiscard]] Motion approach(Approaching& state, const Perception& seen, Driver& driver,
                                pure::Random& random);
  [[nodiscard]] std::optional<Point> look_out(const Perception& seen) const;
  void look_away(Time now);

  ExplorerSettings settings_;
  Recording record_;
  std::variant<Searching, Approaching> state_;
  Time looks_again_{0};
  std::optional<Path> found_;
};

}  // namespace caravan::agent
