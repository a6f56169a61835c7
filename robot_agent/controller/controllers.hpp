// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <caravan/controller.hpp>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "robot_agent/core/config.hpp"
#include "runtime/config/toml_table.hpp"
#include "runtime/controller/guarded.hpp"
#include "runtime/controller/library.hpp"

namespace caravan::agent {

/// Selects the paper's agent, which needs no library.
inline constexpr const char* kPaper = "paper";

/// The value of `[controller] library` in the scenario: kPaper (the default), or an absolute path. A relative
/// path is resolved against the scenario's folder.
[[nodiscard]] std::string controller_in(const runtime::TomlDocument& scenario);

/// Makes the controllers of a scenario's robots.
class Controllers {
 public:
  /// Existing folder for what each robot's controller is given and answers; none: no trace.
  using TraceFolder = std::optional<std::filesystem::path>;

  /// @param library  kPaper or the path of a shared library or of a file of Python
  /// @throws StartError when the library cannot be loaded
  Controllers(const runtime::TomlDocument& scenario, const std::string& library, TraceFolder trace = {});
  /// A loaded controller takes the place of the scenario's.
  Controllers(const runtime::TomlDocument& scenario, runtime::LoadedController loaded)
      : scenario_{scenario}, name_{loaded.name}, loaded_{std::move(loaded)} {}
  explicit Controllers(const runtime::TomlDocument& scenario)
      : Controllers{scenario, controller_in(scenario)} {}

  /// kPaper, or the name that the library gives.
  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] bool is_paper() const { return !loaded_; }

  /// A new controller for a robot. @throws StartError when it cannot be constructed
  [[nodiscard]] std::unique_ptr<Controller> make(const Config& config) const;
  /// A new controller whose faults name it and the robot, and whose steps are recorded.
  /// @throws StartError when it cannot be constructed, or its trace cannot be written
  [[nodiscard]] runtime::GuardedController make_guarded(const Config& config) const;
  /// Value for Inputs::destination; none for the paper's agent, which finds the destination itself.
  [[nodiscard]] std::optional<Position> destination_in_sight(const caravan::Sensors& sensors,
                                                             const Config& config) const;

 private:
  runtime::TomlDocument scenario_;
  std::string name_ = kPaper;
  TraceFolder trace_;
  std::shared_ptr<runtime::RadioWatch::Said> said_of_radio_ = std::make_shared<runtime::RadioWatch::Said>();
  std::optional<runtime::LoadedController> loaded_;  // none: the paper's agent
};

}  // namespace caravan::agent
