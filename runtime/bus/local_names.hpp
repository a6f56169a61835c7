// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace caravan::runtime {

/// Takes a name on this machine that one process at a time can have, whoever its user is: the abstract name
/// of a local socket (AF_UNIX), which is in no folder. The kernel takes it away when the process has ended.
///
/// @return what holds it until it is closed; -1: another process has the name
/// @throws StartError when there are no local sockets
[[nodiscard]] int hold_local_name(const std::string& name);

/// The names that are held now and begin with `beginning`, without it.
[[nodiscard]] std::vector<std::string> local_names(const std::string& beginning);

}  // namespace caravan::runtime
