// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ode/ode.h>

#include <string>

namespace caravan::world {

/// An ODE world with a group for the contacts of one physics step. Several may exist in one process, each
/// used by one thread at a time.
///
/// Where ODE would end the process, the called function throws PhysicsError.
class OdeSession {
 public:
  OdeSession();
  ~OdeSession();
  OdeSession(const OdeSession&) = delete;
  OdeSession& operator=(const OdeSession&) = delete;

  /// ODE keeps scratch space per thread: call this before a series of calls on a thread.
  static void prepare_thread();

  /// One physics step; removes the contacts afterwards.
  void step(double seconds);

  /// The first warning of ODE's solver in this thread since the last call; empty: none.
  [[nodiscard]] static std::string take_complaint();

  [[nodiscard]] dWorldID world() const { return world_; }
  [[nodiscard]] dJointGroupID contacts() const { return contacts_; }

 private:
  dWorldID world_;
  dJointGroupID contacts_;
  bool is_broken_ = false;  // a step was aborted
  dThreadingImplementationID
      threading_;  // its own: the one that worlds share by default supports only one thread
};

}  // namespace caravan::world
