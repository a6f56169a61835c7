// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace caravan::runtime {

/// The folder of the files that this program uses at run time: share/caravan beside the folder of the
/// program. In a build tree its entries are links to the sources.
[[nodiscard]] std::filesystem::path data_folder();

/// Path of a page of the documentation, such as "hosts.md", for messages; likewise.
[[nodiscard]] std::string page(const std::string& name);

}  // namespace caravan::runtime
