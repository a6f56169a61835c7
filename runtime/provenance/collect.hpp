// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "runtime/provenance/provenance.hpp"

namespace caravan::runtime {

[[nodiscard]] Build this_build();
/// What cannot be found out is "unknown".
[[nodiscard]] Host this_host();
/// @throws StartError when the file cannot be read
[[nodiscard]] HashedFile hashed(const std::filesystem::path& file);

/// The model in the text of /proc/cpuinfo; where it names none, as on many ARM boards, the board.
[[nodiscard]] std::string processor_in(std::string_view cpuinfo);
/// The distribution's name and release in the text of /etc/os-release.
[[nodiscard]] std::string release_in(std::string_view os_release);

}  // namespace caravan::runtime
