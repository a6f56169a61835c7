// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/controller/controllers.hpp"

#include "robot_agent/controller/paper_controller.hpp"
#include "runtime/controller/make.hpp"

namespace caravan::agent {
namespace fs = std::filesystem;

std::string controller_in(const runtime::TomlDocument& scenario) {
  std::string library = kPaper;
  runtime::TomlTable table = scenario.table("controller");
  table.read("library", library);
  if (library == kPaper) return library;
  if (library.empty())
    table.fail("library", "must be \"paper\", or the path of a shared library or of a file of Python");
  return fs::absolute(fs::path{scenario.file()}.parent_path() / library).lexically_normal();
}

Controllers::Controllers(const runtime::TomlDocument& scenario, const std::string& library, TraceFolder trace)
    : scenario_{scenario}, trace_{std::move(trace)} {
  if (library != kPaper) {
    loaded_ = runtime::load_controller(library);
    name_ = loaded_->name;
    return;
  }
  runtime::TomlTable table = scenario_.table("controller");
  table.read("library", name_);
  for (const auto& [key, value] : table.rest())
    table.fail(key, "unknown key; controller " + std::string{kPaper} + " has no keys");
  name_ = kPaper;
}

std::unique_ptr<Controller> Controllers::make(const Config& config) const {
  if (!loaded_) return std::make_unique<PaperController>(config);
  runtime::TomlTable table = scenario_.table("controller");
  std::string library;
  table.read("library", library);
  return runtime::make_controller(*loaded_, robot_of(config), std::move(table));
}

runtime::GuardedController Controllers::make_guarded(const Config& config) const {
  auto controller = make(config);
  const std::uint32_t robot = config.id.value;
  auto trace = trace_ ? std::make_unique<runtime::StepTrace>(*trace_, robot) : nullptr;
  return {std::move(controller), name_, robot, {robot_of(config).radio, said_of_radio_}, std::move(trace)};
}

std::optional<Position> Controllers::destination_in_sight(const caravan::Sensors& sensors,
                                                          const Config& config) const {
  return !loaded_ ? std::nullopt : agent::destination_in_sight(sensors, config);
}

}  // namespace caravan::agent
