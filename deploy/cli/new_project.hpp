// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace caravan::deploy {

/// Why this cannot be the name of a project, which becomes the name of its folder, files and CMake targets;
/// empty: it can.
[[nodiscard]] std::string complaint_about_project(const std::string& name);

/// Text or file name of the project `my_swarm` for a project of another name: replaces my_swarm and MySwarm.
/// @pre complaint_about_project(name) is empty
[[nodiscard]] std::string renamed(std::string text, const std::string& name);

/// `caravan new NAME`: a copy of the project `my_swarm` under another name, as folder NAME in the working
/// directory.
///
/// @param templates  the folder of my_swarm
/// @return the files that were written, in alphabetical order
/// @throws runtime::StartError when the name is invalid, the folder exists or cannot be made, or the
/// templates are missing; runtime::WriteError when a file cannot be written
std::vector<std::filesystem::path> write_project(const std::string& name,
                                                 const std::filesystem::path& templates);

}  // namespace caravan::deploy
