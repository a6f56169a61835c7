// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ode/ode.h>

namespace caravan::world {

/// An ODE world with a group for the contacts of one physics step. Several may live in one process, each used
/// by one thread at a time.
class OdeSession {
 public:
  OdeSession();
  ~OdeSession();
  OdeSession(const OdeSession&) = delete;
  OdeSession& operator=(const OdeSession&) = delete;

  /// ODE keeps scratch space for each thread that it is used from: to be called before a series of calls.
  static void prepare_thread();

  [[nodiscard]] dWorldID world() const { return world_; }
  [[nodiscard]] dJointGroupID contacts() const { return contacts_; }

 private:
  dWorldID world_;
  dJointGroupID contacts_;
  dThreadingImplementationID
      threading_;  // its own: the one that worlds share by default is for one thread alone
};

}  // namespace caravan::world
