// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "hardware_bridge/shell/descriptor.hpp"

namespace caravan::bridge {

/// The sole use of a device among the bridges of this machine, whoever runs them. Two hosts on one serial
/// line take each other's bytes, and on TCP most devices drop the first for the second.
///
/// It is a name that the kernel forgets with its owner, however this ends (an abstract Unix socket).
class Claim {
 public:
  /// @param device  see canonical()
  /// @param option  of the command line, for the message
  /// @throws StartError with the process that has the device
  Claim(const std::string& device, const std::string& option);

 private:
  Descriptor held_;
};

}  // namespace caravan::bridge
