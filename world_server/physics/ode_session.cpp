// SPDX-License-Identifier: Apache-2.0
#include "world_server/physics/ode_session.hpp"

namespace caravan::world {
namespace {

/// ODE is opened once for a process and stays open: closing it would pull it away from other worlds.
void open_ode() {
  static const int opened = dInitODE2(0);
  static_cast<void>(opened);
}

}  // namespace

OdeSession::OdeSession() : world_{(open_ode(), dWorldCreate())}, contacts_{dJointGroupCreate(0)} {}

OdeSession::~OdeSession() {
  dJointGroupDestroy(contacts_);
  dWorldDestroy(world_);
}

void OdeSession::prepare_thread() {
  thread_local const int prepared = (open_ode(), dAllocateODEDataForThread(dAllocateMaskAll));
  static_cast<void>(prepared);
}

}  // namespace caravan::world
