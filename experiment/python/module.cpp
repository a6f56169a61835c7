// SPDX-License-Identifier: Apache-2.0
// The extension module of the Python package caravan: the embedded engine.
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <atomic>
#include <limits>

#include "experiment/python/scenario_text.hpp"
#include "experiment/python/stepped_run.hpp"
#include "world_server/physics/physics_error.hpp"

namespace caravan::experiment {
namespace py = pybind11;
using py::literals::operator""_a;
namespace {

/// Refuses a second thread, and a controller that looks at the run that is calling it.
class Use {
 public:
  explicit Use(std::atomic<bool>& taken) : taken_{taken} {
    if (taken.exchange(true)) throw std::logic_error{"this run is being stepped: ask it afterwards"};
  }
  ~Use() { taken_ = false; }
  Use(const Use&) = delete;
  Use& operator=(const Use&) = delete;

 private:
  std::atomic<bool>& taken_;
};

class PythonRun {
 public:
  PythonRun(const std::string& text, const std::string& file)
      : run_{runtime::TomlDocument::parse(text, file)} {}

  /// At most `steps`, and as long as the time is below `until`. Python's lock is free meanwhile.
  /// @return the steps taken
  std::uint64_t step(std::uint64_t steps, Time until) {
    const Use use{taken_};
    constexpr std::uint64_t kBetweenSignals = 64;
    std::uint64_t done = 0;
    while (goes_on(done, steps, until)) {
      {
        const py::gil_scoped_release unlocked;
        const std::uint64_t stop = done + kBetweenSignals;
        for (; done < stop && goes_on(done, steps, until); ++done) run_.step();
      }
      if (PyErr_CheckSignals() != 0) throw py::error_already_set{};
    }
    return done;
  }

  template <typename Look>
  auto look(Look at) {
    const Use use{taken_};
    return at(run_);
  }

 private:
  [[nodiscard]] bool goes_on(std::uint64_t done, std::uint64_t steps, Time until) const {
    return done < steps && !run_.engine().finished() && run_.engine().now() < until;
  }

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

py::list events_of(const SteppedRun& run) {
  py::list events;
  for (const EventRow& row : run.events())
    events.append(py::make_tuple(in_seconds(row.stamp), row.robot, row.event, row.detail));
  return events;
}

}  // namespace

PYBIND11_MODULE(_engine, module) {
  py::register_exception<runtime::StartError>(module, "ScenarioError", PyExc_ValueError);
  const auto& run_error =
      py::register_exception<runtime::ControllerFault>(module, "RunError", PyExc_RuntimeError);
  py::register_exception<world::PhysicsError>(module, "PhysicsError", run_error);
  module.def("check", &check_text, "text"_a, "file"_a);
  module.def("changed", &changed_text, "text"_a, "file"_a, "changes"_a);
  py::class_<PythonRun>(module, "Run")
      .def(py::init<const std::string&, const std::string&>(), "text"_a, "file"_a)
      .def(
          "step", [](PythonRun& run, std::uint64_t steps) { return run.step(steps, Time::max()); }, "steps"_a)
      .def(
          "run_until",
          [](PythonRun& run, std::int64_t until_ns) {
            return run.step(std::numeric_limits<std::uint64_t>::max(), Time{until_ns});
          },
          "until_ns"_a)
      .def("now_ns",
           [](PythonRun& run) { return run.look([](auto& r) { return r.engine().now().count(); }); })
      .def("finished", [](PythonRun& run) { return run.look([](auto& r) { return r.engine().finished(); }); })
      .def("digest", [](PythonRun& run) { return run.look([](auto& r) { return r.engine().digest(); }); })
      .def("robots", [](PythonRun& run) { return run.look([](auto& r) { return r.robots(); }); })
      .def("items_delivered",
           [](PythonRun& run) { return run.look([](auto& r) { return r.items_delivered(); }); })
      .def("poses", [](PythonRun& run) { return run.look(poses_of); })
      .def("tracks", [](PythonRun& run) { return run.look(tracks_of); })
      .def("events", [](PythonRun& run) { return run.look(events_of); })
      .def("metrics", [](PythonRun& run) { return run.look([](auto& r) { return r.metrics(); }); });
}

}  // namespace caravan::experiment
