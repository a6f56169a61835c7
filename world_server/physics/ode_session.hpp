// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ode/ode.h>

#include <string>

namespace caravan::world {

/// An ODE world with a group for the contacts of one physics step. Several may live in one process, each used
/// by one thread at a time.
///
/// Where ODE would end the process it throws PhysicsError from whatever function of it was called.
class OdeSession {
 public:
  OdeSession();
  ~OdeSession();
  OdeSession(const OdeSession&) = delete;
  OdeSession& operator=(const OdeSession&) = delete;

  /// ODE keeps scratch space for each thread that it is used from: to be called before a series of calls.
  static void prepare_thread();

  /// One physics step, after which the contacts are gone.
  void step(double seconds);

  /// What ODE's solver has complained of in this thread since the last call, the first of it; empty: nothing.
  [[nodiscard]] static std::string take_complaint();

  [[nodiscard]] dWorldID world() const { return world_; }
  [[nodiscard]] dJointGroupID contacts() const { return contacts_; }

 private:
  dWorldID world_;
  dJointGroupID contacts_;
  bool is_broken_ = false;  // a step of it was left in the middle
  dThreadingImplementationID
      threading_;  // its own: the one that worlds share by default is for one thread alone
};

}  // namespace caravan::world
