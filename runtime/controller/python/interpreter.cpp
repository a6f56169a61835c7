// SPDX-License-Identifier: Apache-2.0
#include "runtime/controller/python/interpreter.hpp"

#include <dlfcn.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <cstdlib>
#include <filesystem>
#include <mutex>
#include <stdexcept>
#include <string>

namespace caravan::python {
namespace py = pybind11;
namespace {

/// The interpreter whose packages are used: that of an active virtual environment of this version of Python,
/// otherwise Debian's, whatever comes first in PATH.
std::string interpreter() {
  if (const char* environment = std::getenv("VIRTUAL_ENV"); environment != nullptr) {
    const std::filesystem::path folder{environment};
    const std::string version =
        "python" + std::to_string(PY_MAJOR_VERSION) + "." + std::to_string(PY_MINOR_VERSION);
    if (std::filesystem::exists(folder / "lib" / version)) return folder / "bin/python3";
  }
  return "/usr/bin/python3";
}

void initialise() {
  PyConfig config;
  PyConfig_InitPythonConfig(&config);
  config.install_signal_handlers = 0;
  config.parse_argv = 0;
  config.use_hash_seed = 1;
  config.hash_seed = 0;
  config.buffered_stdio = 0;
  config.write_bytecode = 0;
  PyStatus status = PyConfig_SetBytesString(&config, &config.program_name, interpreter().c_str());
  if (PyStatus_Exception(status) == 0) status = Py_InitializeFromConfig(&config);
  PyConfig_Clear(&config);
  if (PyStatus_Exception(status) != 0)
    throw std::runtime_error{std::string{"Python does not start: "} +
                             (status.err_msg == nullptr ? "no reason given" : status.err_msg)};
  // The lock is free between the calls of controllers, whatever thread they come from.
  (void)PyEval_SaveThread();
}

/// The folder that has this library's package.
std::string package_folder() {
  Dl_info info{};
  if (dladdr(reinterpret_cast<const void*>(&start_interpreter), &info) == 0 || info.dli_fname == nullptr)
    throw std::runtime_error{"the folder of the Python host cannot be found"};
  return std::filesystem::absolute(info.dli_fname).parent_path().parent_path();
}

void add_to_path(const std::string& folder) {
  auto path = py::reinterpret_borrow<py::list>(py::module_::import("sys").attr("path"));
  if (!path.contains(folder)) path.insert(0, folder);
}

}  // namespace

void start_interpreter() {
  static std::once_flag once;
  std::call_once(once, [] {
    if (Py_IsInitialized() == 0) initialise();
    const py::gil_scoped_acquire lock;
    add_to_path(package_folder());
    // pybind11 imports NumPy while it initialises a static variable. The import gives Python's lock away: no
    // other thread may have it and wait for that variable.
    (void)py::dtype::of<double>();
  });
}

}  // namespace caravan::python
