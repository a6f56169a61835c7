// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <caravan/controller.hpp>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "robot_agent/core/config.hpp"
#include "runtime/config/toml_table.hpp"
#include "runtime/controller/guarded.hpp"

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

  /// @param library  kPaper or the path of a shared library
  /// @throws StartError when the library cannot be loaded
  Controllers(const runtime::TomlDocument& scenario, const std::string& library, TraceFolder trace = {});
  explicit Controllers(const runtime::TomlDocument& scenario)
      : Controllers{scenario, controller_in(scenario)} {}

  /// kPaper, or the name that the library gives.
  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] bool is_paper() const { return library_ == nullptr; }

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
  const ControllerLibrary* library_ = nullptr;  // owned by the process; null: the paper's agent
};

}  // namespace caravan::agent
