// SPDX-License-Identifier: Apache-2.0
#include "world_server/physics/ode_session.hpp"

#include "runtime/pure/assert.hpp"

namespace caravan::world {
namespace {

/// ODE is opened once for a process and stays open: closing it would pull it away from other worlds. Its
/// random numbers are those of the process; the solver that we use draws none.
void open_ode() {
  static const bool opened = [] {
    const int result = dInitODE2(0);
    dRandSetSeed(1);
    return result != 0;
  }();
  CARAVAN_ASSERT(opened);
}

}  // namespace

OdeSession::OdeSession()
    : world_{(open_ode(), dWorldCreate())},
      contacts_{dJointGroupCreate(0)},
      threading_{dThreadingAllocateSelfThreadedImplementation()} {
  dWorldSetStepThreadingImplementation(world_, dThreadingImplementationGetFunctions(threading_), threading_);
}

OdeSession::~OdeSession() {
  dJointGroupDestroy(contacts_);
  dWorldDestroy(world_);
  dThreadingFreeImplementation(threading_);
}

void OdeSession::prepare_thread() {
  thread_local const int prepared =
      (open_ode(), dAllocateODEDataForThread(static_cast<unsigned>(dAllocateMaskAll)));
  static_cast<void>(prepared);
}

}  // namespace caravan::world
