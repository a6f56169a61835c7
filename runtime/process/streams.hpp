// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace caravan::runtime {

/// To be called first in every main: whatever becomes of the standard streams, the program goes on, and what
/// it records is whole.
///
/// A stream that is closed becomes /dev/null; otherwise the next file that is opened would take its number,
/// and receive what is printed. Printing into a pipe that nobody reads any more fails, in place of SIGPIPE,
/// which would end the program wherever it is.
void prepare_streams();

/// To be called last: what a program has printed on standard output is a result, too.
/// @return why not all of it could be written; empty: it was, or its reader has left the pipe and wants no
///         more
[[nodiscard]] std::string failure_of_output();

}  // namespace caravan::runtime
