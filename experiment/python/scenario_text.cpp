// SPDX-License-Identifier: Apache-2.0
#include "experiment/python/scenario_text.hpp"

#include <toml++/toml.h>

#include <sstream>

#include "experiment/check/check_tables.hpp"
#include "robot_agent/controller/controllers.hpp"
#include "runtime/config/toml_table.hpp"
#include "world_server/config/world_config.hpp"
#include "world_server/world.hpp"

namespace caravan::experiment {
namespace py = pybind11;
namespace {

/// Writes values of Python into tables of TOML.
class Writer {
 public:
  /// @param file  begins the messages
  explicit Writer(const std::string& file) : file_{file} {}

  /// Sets "radio.range_m" in the table `[radio]`, which is made when it is not there.
  void set_dotted(toml::table& root, const std::string& key, const py::handle& value) const {
    toml::table* table = &root;
    std::size_t begin = 0;
    for (std::size_t dot = key.find('.'); dot != std::string::npos; dot = key.find('.', begin)) {
      table = &table_in(*table, key.substr(begin, dot - begin));
      begin = dot + 1;
    }
    set(*table, key.substr(begin), key, value);
  }

 private:
  /// What stands there and is not a table is replaced: whoever reads the key says that it must not be one.
  [[nodiscard]] static toml::table& table_in(toml::table& above, const std::string& name) {
    if (above.get_as<toml::table>(name) == nullptr) above.insert_or_assign(name, toml::table{});
    return *above.get_as<toml::table>(name);
  }

  void set(toml::table& table, const std::string& name, const std::string& key,
           const py::handle& value) const {
    if (py::isinstance<py::dict>(value)) {
      fill(table_in(table, name), key, value);
    } else {
      convert(key, value, [&](const auto& converted) { table.insert_or_assign(name, converted); });
    }
  }

  void add(toml::array& array, const std::string& key, const py::handle& value) const {
    if (py::isinstance<py::dict>(value)) {
      toml::table table;
      fill(table, key, value);
      array.push_back(std::move(table));
    } else {
      convert(key, value, [&](const auto& converted) { array.push_back(converted); });
    }
  }

  void fill(toml::table& table, const std::string& key, const py::handle& values) const {
    for (const auto& entry : py::reinterpret_borrow<py::dict>(values)) {
      const std::string name = py::str(entry.first);
      set(table, name, key + "." + name, entry.second);
    }
  }

  /// Calls `put` with the value in TOML.
  template <typename Put>
  void convert(const std::string& key, const py::handle& value, Put put) const {
    if (py::hasattr(value, "tolist")) {  // NumPy's numbers and arrays
      convert(key, value.attr("tolist")(), put);
    } else if (py::isinstance<py::bool_>(value)) {
      put(value.cast<bool>());
    } else if (py::isinstance<py::int_>(value)) {
      put(whole(key, value));
    } else if (py::isinstance<py::float_>(value)) {
      put(value.cast<double>());
    } else if (py::isinstance<py::str>(value)) {
      put(value.cast<std::string>());
    } else if (py::hasattr(value, "__fspath__")) {
      put(value.attr("__fspath__")().cast<std::string>());
    } else if (py::isinstance<py::list>(value) || py::isinstance<py::tuple>(value)) {
      toml::array array;
      for (const py::handle one : value) add(array, key, one);
      put(array);
    } else {
      refuse(key, "must be a number, True or False, a string, a path, a list or a dict");
    }
  }

  [[nodiscard]] std::int64_t whole(const std::string& key, const py::handle& value) const {
    int overflow = 0;
    const std::int64_t number = PyLong_AsLongLongAndOverflow(value.ptr(), &overflow);
    if (overflow != 0) refuse(key, "must be between -2^63 and 2^63 - 1");
    return number;
  }

  [[noreturn]] void refuse(const std::string& key, const std::string& reason) const {
    throw runtime::StartError{file_ + ": " + key + ": " + reason};
  }

  const std::string& file_;
};

}  // namespace

std::string changed_text(const std::string& text, const std::string& file, const py::dict& changes,
                         const std::string& changed_file) {
  const auto scenario = runtime::TomlDocument::parse(text, file);
  toml::table tree = scenario.tree();
  if (const std::string controller = agent::controller_in(scenario); controller != agent::kPaper)
    tree.get_as<toml::table>("controller")->insert_or_assign("library", controller);
  const Writer writer{changed_file};
  for (const auto& entry : changes) writer.set_dotted(tree, py::str(entry.first), entry.second);
  std::ostringstream changed;
  changed << tree << "\n";
  return changed.str();
}

RunFacts check_text(const std::string& text, const std::string& file) {
  const auto scenario = runtime::TomlDocument::parse(text, file);
  RunFacts facts = check_tables(scenario);
  (void)agent::controller_in(scenario);
  const world::World trial{world::load_world_config(scenario)};
  return facts;
}

}  // namespace caravan::experiment
