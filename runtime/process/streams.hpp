// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace caravan::runtime {

/// Call this first in every main: whatever happens to the standard streams, the program continues and its
/// records stay whole.
///
/// A closed stream becomes /dev/null; otherwise the next opened file would get its number and receive what is
/// printed. Printing into a pipe without a reader fails, instead of raising SIGPIPE, which would end the
/// program.
void prepare_streams();

/// Call this last: the text printed on standard output is a result, too.
/// @return why not all of it could be written; empty: it was, or its reader has closed the pipe
[[nodiscard]] std::string failure_of_output();

}  // namespace caravan::runtime
