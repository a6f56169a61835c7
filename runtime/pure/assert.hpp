// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdio>
#include <cstdlib>

/// A breached precondition is a bug of the caller: prints its location and aborts, in every build type.
#define CARAVAN_ASSERT(condition)                                                                 \
  do {                                                                                            \
    if (!(condition)) {                                                                           \
      std::fprintf(stderr, "%s:%d: assertion failed: %s\n", __FILE_NAME__, __LINE__, #condition); \
      std::abort();                                                                               \
    }                                                                                             \
  } while (false)
