// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pybind11.h>

#include <caravan/robot.hpp>
#include <caravan/types.hpp>

/// Between the values of the C++ interface and those of the package caravan_controller. The caller holds
/// Python's lock.
namespace caravan::python {

[[nodiscard]] pybind11::object to_python(const Robot& robot);
/// Its two arrays of sonars are read-only views of one copy, which lives as long as they do.
[[nodiscard]] pybind11::object to_python(const Inputs& inputs);
/// @throws std::runtime_error for a value of another type, with its name
[[nodiscard]] Outputs to_outputs(const pybind11::object& decided);

}  // namespace caravan::python
