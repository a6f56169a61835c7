// SPDX-License-Identifier: Apache-2.0
/// Fast DDS of the release built on: 3.1 (Debian 13) or 2.9 (Debian 12), under the same names, those of 3.1
/// where it has one. No other file depends on the version.
#pragma once

#if __has_include(<fastdds/config.hpp>)
#include "runtime/bus/fastdds_3.hpp"
#else
#include "runtime/bus/fastdds_2.hpp"
#endif
