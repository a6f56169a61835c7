// SPDX-License-Identifier: Apache-2.0
// A controller library whose controllers are written in Python. The file is the parameter `library`. The same
// library is the extension module of the package caravan_controller.
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <caravan/controller.hpp>
#include <stdexcept>

#include "runtime/controller/python/interpreter.hpp"
#include "runtime/controller/python/values.hpp"

namespace caravan::python {
namespace py = pybind11;
using py::literals::operator""_a;
namespace {

/// Parameters that a controller can ask for while it is made.
class AskedParameters {
 public:
  explicit AskedParameters(Parameters& parameters) : parameters_{&parameters} {}
  void close() { parameters_ = nullptr; }
  Parameters& get() {
    if (parameters_ == nullptr)
      throw std::runtime_error{"parameters are asked for in __init__; later they are no longer there"};
    return *parameters_;
  }

 private:
  Parameters* parameters_;
};

/// Its message is one line: mine.py:12: ValueError: too far.
[[noreturn]] void translate(py::error_already_set& error, const std::string& file) {
  const py::module_ package = py::module_::import("caravan_controller");
  const py::object value = error.value();
  if (error.matches(package.attr("ParameterError"))) {
    throw ParameterError{py::str(value.attr("key")), py::str(value.attr("reason"))};
  }
  if (error.trace()) PyException_SetTraceback(value.ptr(), error.trace().ptr());
  const py::object text = py::module_::import("caravan_controller._loading").attr("describe")(value, file);
  throw std::runtime_error{text.cast<std::string>()};
}

/// A controller in Python. Any thread may call it, one at a time.
class PythonController final : public Controller {
 public:
  PythonController(const Robot& robot, Parameters& parameters) : file_{parameters.text("library", "")} {
    start_interpreter();
    const py::gil_scoped_acquire lock;
    const auto asked = std::make_shared<AskedParameters>(parameters);
    try {
      const py::module_ loading = py::module_::import("caravan_controller._loading");
      step_ = loading.attr("make")(file_, to_python(robot), asked).attr("step");
    } catch (py::error_already_set& error) {
      asked->close();
      translate(error, file_);
    }
    asked->close();
  }
  ~PythonController() override {
    const py::gil_scoped_acquire lock;
    step_ = {};
  }
  [[nodiscard]] Outputs step(const Inputs& inputs) override {
    const py::gil_scoped_acquire lock;
    try {
      return to_outputs(step_(to_python(inputs)));
    } catch (py::error_already_set& error) {
      translate(error, file_);
    }
  }

 private:
  std::string file_;
  py::object step_;
};

void raise_in_python(std::exception_ptr thrown) {
  try {
    if (thrown) std::rethrow_exception(thrown);
  } catch (const ParameterError& error) {
    const py::object type = py::module_::import("caravan_controller").attr("ParameterError");
    PyErr_SetObject(type.ptr(), type(error.key(), error.what()).ptr());
  }
}

}  // namespace

PYBIND11_MODULE(_host, module) {
  py::register_exception_translator(&raise_in_python);
  py::class_<Random>(module, "Random",
                     "A seeded stream of random numbers, equal to that of the C++ interface.")
      .def(py::init<std::uint64_t, std::uint64_t>(), "seed"_a, "stream"_a = 0)
      .def_static("of_robot",
                  [](std::uint64_t seed, std::uint32_t id, std::uint64_t stream) {
                    Robot robot;
                    robot.id = id;
                    robot.seed = seed;
                    return robot.random(stream);
                  })
      .def("word", &Random::word, "64 random bits as an integer.")
      .def("unit", &Random::unit, "Uniform in [0, 1).")
      .def("uniform", &Random::uniform, "low"_a, "high"_a, "Uniform in [low, high).")
      .def("chance", &Random::chance, "probability"_a, "True with the given probability.")
      .def("normal", &Random::normal, "Standard normal.");
  constexpr Limits kAny;
  const py::arg_v from{"low", kAny.low, "lowest"};  // with its text in messages
  const py::arg_v to{"high", kAny.high, "highest"};
  py::class_<AskedParameters, std::shared_ptr<AskedParameters>>(
      module, "Parameters",
      "The keys of the scenario's table [controller]. Each function gives the value of a key, or "
      "`otherwise`.\n"
      "A key of the scenario that the constructor has not asked for ends the program before the run.")
      .def(
          "number",
          [](AskedParameters& asked, const std::string& key, double otherwise, double low, double high) {
            return asked.get().number(key, otherwise, {low, high});
          },
          "key"_a, "otherwise"_a, from, to)
      .def(
          "integer",
          [](AskedParameters& asked, const std::string& key, std::int64_t otherwise, double low,
             double high) {
            return asked.get().integer(key, otherwise, {low, high});
          },
          "key"_a, "otherwise"_a, from, to)
      .def(
          "flag",
          [](AskedParameters& asked, const std::string& key, bool otherwise) {
            return asked.get().flag(key, otherwise);
          },
          "key"_a, "otherwise"_a)
      .def(
          "text",
          [](AskedParameters& asked, const std::string& key, const std::string& otherwise) {
            return asked.get().text(key, otherwise);
          },
          "key"_a, "otherwise"_a)
      .def(
          "numbers",
          [](AskedParameters& asked, const std::string& key, const std::vector<double>& otherwise, double low,
             double high) {
            return asked.get().numbers(key, otherwise, {low, high});
          },
          "key"_a, "otherwise"_a, from, to);
}

}  // namespace caravan::python

CARAVAN_CONTROLLER(caravan::python::PythonController, "python")
