// SPDX-License-Identifier: Apache-2.0
#include "runtime/controller/python/values.hpp"

#include <pybind11/numpy.h>

#include <memory>
#include <stdexcept>

namespace caravan::python {
namespace py = pybind11;
namespace {

/// Classes of the package. Never destroyed: Python may end first.
struct Package {
  py::module_ module = py::module_::import("caravan_controller");
  py::object position = module.attr("Position");
  py::object sensors = module.attr("Sensors");
  py::object received_frame = module.attr("ReceivedFrame");
  py::object inputs = module.attr("Inputs");
  py::object frame = module.attr("Frame");
  py::object report = module.attr("Report");
  py::object exchange = module.attr("Exchange");
  py::object event = module.attr("Event");
  py::object outputs = module.attr("Outputs");
};

const Package& package() {
  static const Package* found = nullptr;  // under Python's lock
  if (found == nullptr) found = new Package;
  return *found;
}

py::object to_python(const Position& position) { return package().position(position.x_m, position.y_m); }

py::list to_python(const std::vector<ReceivedFrame>& heard) {
  py::list frames{heard.size()};
  for (std::size_t i = 0; i < heard.size(); ++i) {
    const py::bytes bytes{reinterpret_cast<const char*>(heard[i].bytes.data()), heard[i].bytes.size()};
    frames[i] = package().received_frame(heard[i].channel, bytes, heard[i].signal_strength_dbm);
  }
  return frames;
}

py::array view(const std::array<double, kSonarCount>& numbers, const py::object& owner) {
  py::array array{py::dtype::of<double>(), {kSonarCount}, {sizeof(double)}, numbers.data(), owner};
  py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return array;
}

py::object to_python(const Sensors& sensors) {
  // The engine reuses its memory; a controller may keep what it was given.
  auto copy = std::make_unique<Sensors>(sensors);
  const py::capsule owner{copy.get(), [](void* kept) { delete static_cast<Sensors*>(kept); }};
  const Sensors& kept = *copy.release();
  return package().sensors(view(kept.sonar_range_m, owner), view(kept.sonar_age_s, owner),
                           to_python(kept.position), kept.yaw_rad, kept.left_wheel_rad, kept.right_wheel_rad,
                           kept.holding);
}

std::string text_of(const py::handle& value) {
  try {
    return py::repr(value);
  } catch (const py::error_already_set&) {
    return "of type " + std::string{Py_TYPE(value.ptr())->tp_name};
  }
}

/// Reads the attributes of one object of the package.
class Reader {
 public:
  /// @param name  of the class, for messages
  Reader(py::handle object, const py::object& type, const char* name) : object_{object}, name_{name} {
    if (!py::isinstance(object, type))
      throw std::runtime_error{std::string{"TypeError: step() returned "} + Py_TYPE(object.ptr())->tp_name +
                               " where " + name + " is needed"};
  }
  [[nodiscard]] double number(const char* key) const { return read<double>(key, "a number", true); }
  [[nodiscard]] bool flag(const char* key) const { return read<bool>(key, "True or False", false); }
  [[nodiscard]] std::string text(const char* key) const { return read<std::string>(key, "a string", true); }
  template <typename T>
  [[nodiscard]] T integer(const char* key) const {
    return read<T>(key, std::is_signed_v<T> ? "an integer" : "an integer from 0 on, and not too large", true);
  }
  template <typename Enumeration>
  [[nodiscard]] Enumeration one_of(const char* key, Enumeration last) const {
    const auto number = integer<std::uint32_t>(key);
    if (number > static_cast<std::uint32_t>(last)) fail(key, object_.attr(key), "one of its enumeration");
    return static_cast<Enumeration>(number);
  }
  [[nodiscard]] std::vector<std::uint8_t> bytes(const char* key) const {
    const py::object value = object_.attr(key);
    if (!PyBytes_Check(value.ptr())) fail(key, value, "bytes");
    const auto* first = reinterpret_cast<const std::uint8_t*>(PyBytes_AS_STRING(value.ptr()));
    return {first, first + PyBytes_GET_SIZE(value.ptr())};
  }
  /// Calls `take` with each element of a list or tuple.
  template <typename Take>
  void each(const char* key, Take take) const {
    const py::object value = object_.attr(key);
    if (!PyList_Check(value.ptr()) && !PyTuple_Check(value.ptr())) fail(key, value, "a list");
    for (const py::handle element : value) take(element);
  }
  [[nodiscard]] bool is_none(const char* key) const { return object_.attr(key).is_none(); }
  [[nodiscard]] py::object object(const char* key) const { return object_.attr(key); }

 private:
  template <typename T>
  [[nodiscard]] T read(const char* key, const char* demand, bool convert) const {
    const py::object value = object_.attr(key);
    py::detail::make_caster<T> caster;
    if (!caster.load(value, convert)) fail(key, value, demand);
    return py::detail::cast_op<T>(caster);
  }
  [[noreturn]] void fail(const char* key, const py::handle& value, const char* demand) const {
    throw std::runtime_error{std::string{"TypeError: step() returned "} + name_ + "." + key + " = " +
                             text_of(value) + ", must be " + demand};
  }

  py::handle object_;
  const char* name_;
};

Exchange to_exchange(py::handle object) {
  const Reader read{object, package().exchange, "Exchange"};
  return {.partner = read.integer<std::uint32_t>("partner"),
          .session = read.integer<std::uint32_t>("session"),
          .primary = read.flag("primary"),
          .completed = read.flag("completed"),
          .began = Time{read.integer<std::int64_t>("began_ns")},
          .ended = Time{read.integer<std::int64_t>("ended_ns")}};
}

Report to_report(py::handle object) {
  const Reader read{object, package().report, "Report"};
  Report report{.mode = read.one_of("mode", Mode::kTransport),
                .activity = read.one_of("activity", Activity::kExchanging),
                .origin = read.one_of("origin", Origin::kReceived),
                .towards_destination = read.flag("towards_destination"),
                .trips = read.integer<std::uint32_t>("trips"),
                .malformed_frames = read.integer<std::uint64_t>("malformed_frames"),
                .path = {},
                .exchanges = {},
                .events = {}};
  if (!read.is_none("path")) {
    report.path.emplace();
    read.each("path", [&](py::handle element) {
      const Reader place{element, package().position, "Position"};
      report.path->push_back({place.number("x_m"), place.number("y_m")});
    });
  }
  read.each("exchanges", [&](py::handle element) { report.exchanges.push_back(to_exchange(element)); });
  read.each("events", [&](py::handle element) {
    const Reader event{element, package().event, "Event"};
    report.events.push_back({event.text("name"), event.text("detail")});
  });
  return report;
}

}  // namespace

py::object to_python(const Robot& robot) {
  const py::module_& module = package().module;
  py::list mounts;
  for (const SonarMount& mount : robot.sonars.mounts)
    mounts.append(module.attr("SonarMount")(mount.x_m, mount.y_m, mount.heading_rad));
  const Body& body = robot.body;
  return module.attr("Robot")(robot.id, robot.seed,
                              module.attr("Body")(body.length_m, body.ahead_m, body.width_m, body.track_m,
                                                  body.wheel_radius_m, body.wheel_limit_mps),
                              mounts, robot.sonars.aperture_rad, robot.sonars.range_m,
                              module.attr("Radio")(robot.radio.channel_count, robot.radio.mtu_bytes),
                              to_python(robot.source), robot.service_radius_m);
}

py::object to_python(const Inputs& inputs) {
  const py::object destination = inputs.destination ? to_python(*inputs.destination) : py::none();
  return package().inputs(inputs.now.count(), to_python(inputs.sensors), to_python(inputs.heard),
                          destination);
}

Outputs to_outputs(const py::object& decided) {
  const Reader read{decided, package().outputs, "Outputs"};
  Outputs outputs{.left_mps = read.number("left_mps"),
                  .right_mps = read.number("right_mps"),
                  .gripper_closed = read.flag("gripper_closed"),
                  .tuned_channel = read.integer<std::uint32_t>("tuned_channel"),
                  .frames = {},
                  .report = {}};
  read.each("frames", [&](py::handle element) {
    const Reader frame{element, package().frame, "Frame"};
    outputs.frames.push_back({frame.integer<std::uint32_t>("channel"), frame.bytes("bytes")});
  });
  if (!read.is_none("report")) outputs.report = to_report(read.object("report"));
  return outputs;
}

}  // namespace caravan::python
