// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace caravan::runtime {

/// Takes a name that only one process on this machine can have at a time, whoever its user is: the abstract
/// name of a local socket (AF_UNIX), which is in no folder. The kernel removes it when the process ends.
///
/// @return the descriptor that holds the name until it is closed; -1: another process has the name
/// @throws StartError when local sockets are not available
[[nodiscard]] int hold_local_name(const std::string& name);

/// The names currently held that begin with `beginning`, without that prefix.
[[nodiscard]] std::vector<std::string> local_names(const std::string& beginning);

}  // namespace caravan::runtime
