// SPDX-License-Identifier: Apache-2.0
#include "experiment/python/scenario_text.hpp"

#include <toml++/toml.h>

#include <sstream>

#include "radio_emulator/config/radio_config.hpp"
#include "robot_agent/config/agent_config.hpp"
#include "robot_agent/controller/controllers.hpp"
#include "runtime/config/toml_table.hpp"
#include "world_server/world.hpp"

namespace caravan::experiment {
namespace py = pybind11;
namespace {

[[noreturn]] void refuse(const std::string& key, const std::string& reason) {
  throw runtime::StartError{key + ": " + reason};
}

void set(toml::table& table, const std::string& name, const std::string& key, const py::handle& value);
void add(toml::array& array, const std::string& key, const py::handle& value);

/// Calls `put` with the value as TOML has it.
template <typename Put>
void convert(const std::string& key, const py::handle& value, Put put) {
  if (py::isinstance<py::bool_>(value)) {
    put(value.cast<bool>());
  } else if (PyIndex_Check(value.ptr()) != 0) {  // also NumPy's integers
    put(py::int_(py::reinterpret_borrow<py::object>(value)).cast<std::int64_t>());
  } else if (py::isinstance<py::float_>(value)) {
    put(value.cast<double>());
  } else if (py::isinstance<py::str>(value)) {
    put(value.cast<std::string>());
  } else if (py::isinstance<py::dict>(value)) {
    toml::table table;
    for (const auto& entry : value.cast<py::dict>()) {
      const std::string name = py::str(entry.first);
      set(table, name, key + "." + name, entry.second);
    }
    put(table);
  } else if (PySequence_Check(value.ptr()) != 0) {  // also NumPy's arrays
    toml::array array;
    for (const py::handle one : value) add(array, key, one);
    put(array);
  } else {
    refuse(key, "must be a number, True or False, a string, a list or a dict");
  }
}

void set(toml::table& table, const std::string& name, const std::string& key, const py::handle& value) {
  convert(key, value, [&](const auto& converted) { table.insert_or_assign(name, converted); });
}

void add(toml::array& array, const std::string& key, const py::handle& value) {
  convert(key, value, [&](const auto& converted) { array.push_back(converted); });
}

/// Sets "radio.range_m" in the table `[radio]`, which is made when it is not there.
void set_dotted(toml::table& root, const std::string& key, const py::handle& value) {
  toml::table* table = &root;
  std::size_t begin = 0;
  for (std::size_t dot = key.find('.'); dot != std::string::npos; dot = key.find('.', begin)) {
    const std::string name = key.substr(begin, dot - begin);
    if (!table->contains(name)) table->insert(name, toml::table{});
    table = table->get_as<toml::table>(name);
    if (table == nullptr) refuse(key, "\"" + key.substr(0, dot) + "\" is not a table of the scenario");
    begin = dot + 1;
  }
  set(*table, key.substr(begin), key, value);
}

}  // namespace

std::string changed_text(const std::string& text, const std::string& file, const py::dict& changes) {
  const auto scenario = runtime::TomlDocument::parse(text, file);
  toml::table tree = scenario.tree();
  if (const std::string controller = agent::controller_in(scenario); controller != agent::kPaper)
    tree.get_as<toml::table>("controller")->insert_or_assign("library", controller);
  for (const auto& entry : changes) set_dotted(tree, py::str(entry.first), entry.second);
  std::ostringstream changed;
  changed << tree << "\n";
  return changed.str();
}

void check_text(const std::string& text, const std::string& file) {
  const auto scenario = runtime::TomlDocument::parse(text, file);
  const world::World trial{world::load_world_config(scenario)};
  (void)radio::load_radio_config(scenario);
  (void)agent::load_config(scenario, 1);
  (void)agent::controller_in(scenario);
}

}  // namespace caravan::experiment
