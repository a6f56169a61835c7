// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace caravan::pure {

/// A visitor made of lambdas; without a catch-all, a new alternative of the variant does not compile.
template <typename... Functions>
struct Overload : Functions... {
  using Functions::operator()...;
};
template <typename... Functions>
Overload(Functions...) -> Overload<Functions...>;

}  // namespace caravan::pure
