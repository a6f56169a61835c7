// SPDX-License-Identifier: Apache-2.0
// The extension module of the Python package caravan: scenarios, and the embedded engine.
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <atomic>
#include <chrono>

#include "experiment/python/checked_scenario.hpp"
#include "experiment/python/stepped_run.hpp"
#include "runtime/config/toml_text.hpp"
#include "runtime/controller/library.hpp"
#include "world_server/physics/physics_error.hpp"

namespace caravan::experiment {
namespace py = pybind11;
using py::literals::operator""_a;
namespace {

/// Refuses a second thread, and a controller that looks at the run that is calling it.
class Use {
 public:
  explicit Use(std::atomic<bool>& taken) : taken_{taken} {
    if (taken.exchange(true))
      throw runtime::ControllerFault{
          "this run is being stepped, by another thread or by the caller of this "
          "controller: ask it afterwards"};
  }
  ~Use() { taken_ = false; }
  Use(const Use&) = delete;
  Use& operator=(const Use&) = delete;

 private:
  std::atomic<bool>& taken_;
};

/// @param given  file of Python that makes the controllers in place of the scenario's; empty: none does
/// @param name   of those
agent::Controllers controllers_of(const runtime::TomlDocument& scenario, const std::string& given,
                                  const std::string& name) {
  if (given.empty()) return agent::Controllers{scenario};
  runtime::LoadedController loaded = runtime::load_controller(given);
  loaded.name = name;
  return {scenario, std::move(loaded)};
}

class PythonRun {
 public:
  PythonRun(const runtime::TomlDocument& scenario, const std::string& given, const std::string& name)
      : run_{scenario, controllers_of(scenario, given, name)} {}

  /// At most `steps`, as long as the time is below `until` and no longer than 20 ms of wall time, but one at
  /// least. Python's lock must be free.
  /// @return the steps taken; 0: there is nothing left to do
  std::uint64_t go_on(std::uint64_t steps, Time until) {
    const Use use{taken_};
    const auto pause = std::chrono::steady_clock::now() + std::chrono::milliseconds{20};
    std::uint64_t done = 0;
    while (done < steps && !run_.engine().finished() && run_.engine().now() < until) {
      run_.step();
      ++done;
      if (std::chrono::steady_clock::now() >= pause) break;
    }
    return done;
  }

  template <typename Look>
  auto look(Look at) {
    const Use use{taken_};
    return at(run_);
  }

 private:
  SteppedRun run_;
  std::atomic<bool> taken_{false};
};

py::array_t<double> poses_of(const SteppedRun& run) {
  py::array_t<double> poses{{run.poses().size(), std::size_t{3}}};
  auto rows = poses.mutable_unchecked<2>();
  for (std::size_t i = 0; i < run.poses().size(); ++i) {
    const auto row = static_cast<py::ssize_t>(i);
    rows(row, 0) = run.poses()[i].place.x_m;
    rows(row, 1) = run.poses()[i].place.y_m;
    rows(row, 2) = run.poses()[i].yaw_rad;
  }
  return poses;
}

py::array_t<double> tracks_of(const SteppedRun& run) {
  const std::size_t columns = 5;
  const double* first = run.tracks().empty() ? nullptr : run.tracks().front().data();
  return py::array_t<double>{{run.tracks().size(), columns}, first};
}

/// Those from row `first` on.
py::list events_of(const SteppedRun& run, std::size_t first) {
  py::list events;
  for (std::size_t i = first; i < run.events().size(); ++i) {
    const EventRow& row = run.events()[i];
    events.append(py::make_tuple(in_seconds(row.stamp), row.robot, row.event, row.detail));
  }
  return events;
}

}  // namespace

PYBIND11_MODULE(_engine, module) {
  py::register_exception<runtime::StartError>(module, "ScenarioError", PyExc_ValueError).doc() =
      "A scenario or its controller cannot be used: file:line: key: reason.";
  const auto& run_error =
      py::register_exception<runtime::ControllerFault>(module, "RunError", PyExc_RuntimeError);
  run_error.doc() = "A run has failed and cannot go on.";
  py::register_exception<world::PhysicsError>(module, "PhysicsError", run_error);
  module.def(
      "read", [](const std::string& file) { return runtime::read_toml_file(file, "scenario file"); },
      "file"_a);
  module.def(
      "check",
      [](const std::string& text, const std::string& file, const Changes& changes) {
        const CheckedScenario checked = [&] {
          const py::gil_scoped_release unlocked;
          return check_scenario(text, file, changes);
        }();
        return py::make_tuple(checked.text, checked.facts.scenario, checked.facts.robots,
                              checked.facts.items);
      },
      "text"_a, "file"_a, "changes"_a);
  py::class_<PythonRun>(module, "Run")
      .def(py::init([](const std::string& text, const std::string& file, const std::string& given,
                       const std::string& name) {
             const py::gil_scoped_release unlocked;
             return std::make_unique<PythonRun>(runtime::TomlDocument::parse(text, file), given, name);
           }),
           "text"_a, "file"_a, "given"_a, "name"_a)
      .def(
          "go_on",
          [](PythonRun& run, std::uint64_t steps, std::int64_t until_ns) {
            return run.go_on(steps, Time{until_ns});
          },
          "steps"_a, "until_ns"_a, py::call_guard<py::gil_scoped_release>())
      .def("now_ns",
           [](PythonRun& run) { return run.look([](auto& r) { return r.engine().now().count(); }); })
      .def("finished", [](PythonRun& run) { return run.look([](auto& r) { return r.engine().finished(); }); })
      .def("digest", [](PythonRun& run) { return run.look([](auto& r) { return r.engine().digest(); }); })
      .def("robots", [](PythonRun& run) { return run.look([](auto& r) { return r.robots(); }); })
      .def("items_delivered",
           [](PythonRun& run) { return run.look([](auto& r) { return r.items_delivered(); }); })
      .def("poses", [](PythonRun& run) { return run.look(poses_of); })
      .def("tracks", [](PythonRun& run) { return run.look(tracks_of); })
      .def(
          "events",
          [](PythonRun& run, std::size_t first) {
            return run.look([first](auto& r) { return events_of(r, first); });
          },
          "first"_a)
      .def("metrics", [](PythonRun& run) { return run.look([](auto& r) { return r.metrics(); }); })
      .def("complaint", [](PythonRun& run) { return run.look([](auto& r) { return r.complaint(); }); });
}

}  // namespace caravan::experiment
