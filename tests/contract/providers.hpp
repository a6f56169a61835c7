// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <iosfwd>
#include <memory>
#include <string>
#include <vector>

#include "tests/system/bridge/support/field.hpp"

namespace caravan::test {

/// A program that provides rt/robot_1/sensors and executes rt/robot_1/command.
struct Provider {
  std::string name;
  /// Starts the provider and what it needs. They end when the returned processes are destroyed.
  std::vector<std::unique_ptr<Process>> (*start)(class ContractField& field) = nullptr;
};

std::ostream& operator<<(std::ostream& out, const Provider& provider);

/// A room with one robot near the source, and its truth.
class ContractField : public Field, public ::testing::WithParamInterface<Provider> {
 public:
  using Field::start;
  using Field::start_robot;
  using Field::start_world;

 protected:
  void SetUp() override;
  std::vector<std::unique_ptr<Process>> programs_;
  Truth truth_{bus()};
};

/// The providers of this project; add yours.
[[nodiscard]] std::vector<Provider> providers();

}  // namespace caravan::test
