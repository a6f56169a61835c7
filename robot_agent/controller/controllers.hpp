// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <caravan/controller.hpp>
#include <functional>
#include <string>
#include <vector>

#include "robot_agent/core/config.hpp"
#include "runtime/config/toml_table.hpp"
#include "runtime/controller/guarded.hpp"

namespace caravan::agent {

/// "paper": the paper's agent, which needs no library.
inline constexpr const char* kPaper = "paper";

/// What the scenario names in `[controller] library`: kPaper, the default, or an absolute path. A relative
/// path starts from the scenario's folder.
[[nodiscard]] std::string controller_in(const runtime::TomlDocument& scenario);

/// The controller of a scenario's robots.
class Controllers {
 public:
  /// @param library  kPaper or the path of a shared library
  /// @throws StartError when the library cannot be loaded
  Controllers(const runtime::TomlDocument& scenario, const std::string& library);
  explicit Controllers(const runtime::TomlDocument& scenario)
      : Controllers{scenario, controller_in(scenario)} {}

  /// "paper", or what the library calls itself.
  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] bool is_paper() const { return library_ == nullptr; }

  /// A new controller for a robot. @throws StartError when it cannot be made
  [[nodiscard]] std::unique_ptr<Controller> make(const Config& config) const;
  /// The same with faults named. @throws StartError
  [[nodiscard]] runtime::GuardedController make_guarded(const Config& config) const {
    return {make(config), name_, config.id.value};
  }
  /// Inputs::destination; none where the controller finds it by itself.
  [[nodiscard]] std::optional<Position> destination_in_sight(const caravan::Sensors& sensors,
                                                             const Config& config) const;

 private:
  runtime::TomlDocument scenario_;
  std::string name_ = kPaper;
  const ControllerLibrary* library_ = nullptr;  // of the process; null: the paper's agent
};

}  // namespace caravan::agent
