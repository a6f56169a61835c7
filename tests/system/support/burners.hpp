// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <vector>

namespace caravan::test {

/// Keeps every core busy with a useless computation during its lifetime.
class Burners {
 public:
  Burners();
  ~Burners();
  Burners(const Burners&) = delete;
  Burners& operator=(const Burners&) = delete;

 private:
  std::vector<pid_t> pids_;
};

}  // namespace caravan::test
