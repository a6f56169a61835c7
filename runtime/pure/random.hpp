// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <caravan/random.hpp>

/// All parts use the generator that controllers use.
namespace caravan::pure {

using caravan::mix;
using caravan::mix_all;
using caravan::Random;
using caravan::unit_interval;

}  // namespace caravan::pure
