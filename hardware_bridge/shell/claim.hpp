// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "hardware_bridge/shell/descriptor.hpp"

namespace caravan::bridge {

/// Exclusive use of a device among the bridges of this machine, for all users. Two hosts on one serial line
/// take each other's bytes; on TCP most devices drop the first host when a second connects.
///
/// The claim is an abstract Unix socket: the kernel removes it when its process ends, however it ends.
class Claim {
 public:
  /// @param device  from canonical()
  /// @param option  command-line option, for the message
  /// @throws StartError naming the process that has the device
  Claim(const std::string& device, const std::string& option);

 private:
  Descriptor held_;
};

}  // namespace caravan::bridge
