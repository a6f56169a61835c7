// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace caravan::python {

/// Starts Python in this process, unless it is a Python program, with the package of this library in its
/// path. From any thread, as often as you like. The interpreter runs until the process ends.
///
/// Its hashes are not randomised, so that sets of strings have one order in all processes. It installs no
/// signal handlers, writes no files, and keeps no output back.
///
/// @throws std::runtime_error when it does not start
void start_interpreter();

}  // namespace caravan::python
