// SPDX-License-Identifier: Apache-2.0
#include "deploy/cli/new_project.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <fstream>
#include <string_view>

#include "experiment/metrics/text_file.hpp"
#include "runtime/config/start_error.hpp"
#include "runtime/config/write_error.hpp"

namespace caravan::deploy {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kModel = "my_swarm";
constexpr std::string_view kModelClass = "MySwarm";
constexpr std::size_t kLongestName = 40;

/// Words with a meaning of their own: targets of CMake, and the controller that is a part of Caravan.
constexpr std::array<std::string_view, 10> kReserved{"all",           "clean",   "edit_cache",     "help",
                                                     "install",       "package", "package_source", "paper",
                                                     "rebuild_cache", "test"};

/// my_swarm -> MySwarm
std::string class_name(const std::string& name) {
  std::string text;
  bool begins = true;
  for (const char letter : name) {
    if (letter != '_')
      text += begins ? static_cast<char>(std::toupper(static_cast<unsigned char>(letter))) : letter;
    begins = letter == '_';
  }
  return text;
}

std::string replace_all(std::string text, std::string_view from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
  return text;
}

std::vector<fs::path> files_in(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator{folder, error})
    files.push_back(entry.path());
  if (files.empty())
    throw runtime::StartError{"caravan new: " + folder.string() + " is missing: install Caravan anew"};
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

std::string complaint_about_project(const std::string& name) {
  const auto is_allowed = [](char letter) {
    return (letter >= 'a' && letter <= 'z') || (letter >= '0' && letter <= '9') || letter == '_';
  };
  if (name.empty() || name.size() > kLongestName || name.front() < 'a' || name.front() > 'z' ||
      !std::all_of(name.begin(), name.end(), is_allowed))
    return "is not a name for a project: use 1 to 40 lower-case letters, digits and _, a letter first";
  if (std::find(kReserved.begin(), kReserved.end(), name) != kReserved.end())
    return "is reserved: choose another name";
  return "";
}

std::string renamed(std::string text, const std::string& name) {
  return replace_all(replace_all(std::move(text), kModel, name), kModelClass, class_name(name));
}

std::vector<fs::path> write_project(const std::string& name, const fs::path& templates) {
  const std::string wrong = complaint_about_project(name);
  if (!wrong.empty()) throw runtime::StartError{"caravan new: \"" + name + "\" " + wrong};
  const std::vector<fs::path> models = files_in(templates);
  const fs::path folder = name;
  std::error_code error;
  (void)fs::current_path(error);
  if (error)
    throw runtime::StartError{
        "caravan new: the folder in which you are no longer exists: change to another one (cd ~)"};
  if (fs::exists(fs::symlink_status(folder, error)))
    throw runtime::StartError{"caravan new: " + name + " exists already: choose another name, or remove it"};
  fs::create_directory(folder, error);
  if (error) throw runtime::StartError{"caravan new: " + name + ": " + error.message()};
  std::vector<fs::path> written;
  for (const fs::path& model : models) {
    const auto text = experiment::text_in(model);
    written.push_back(folder / renamed(model.filename(), name));
    std::ofstream out{written.back(), std::ios::binary};
    out << renamed(text.value_or(""), name) << std::flush;
    if (!out) throw runtime::cannot_write(written.back(), errno);
  }
  return written;
}

}  // namespace caravan::deploy
