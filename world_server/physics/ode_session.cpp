// SPDX-License-Identifier: Apache-2.0
#include "world_server/physics/ode_session.hpp"

#include <array>
#include <cstdarg>
#include <cstdio>
#include <string>
#include <utility>

#include "runtime/pure/assert.hpp"
#include "world_server/physics/physics_error.hpp"

namespace caravan::world {
namespace {

// ODE's warnings in this thread since the last call. ODE reports them only to a handler, not by return
// values.
thread_local std::string complaint;

std::string to_text(const char* format, va_list values) {
  std::array<char, 400> text{};
  (void)std::vsnprintf(text.data(), text.size(), format, values);
  return std::string{"ODE: "} + text.data();
}

/// The solver's problem is not determined; ODE continues with an approximate result.
void on_message(int /*number*/, const char* format, va_list values) {
  if (complaint.empty()) complaint = to_text(format, values);
}

/// A failed assertion or an error. If this returned, ODE would end the process.
[[noreturn]] void on_failure(int /*number*/, const char* format, va_list values) {
  throw PhysicsError{to_text(format, values)};
}

/// ODE is opened once per process and stays open: closing it would affect other worlds. Its random numbers
/// are global to the process; the solver in use draws none.
void open_ode() {
  static const bool opened = [] {
    const int result = dInitODE2(0);
    dRandSetSeed(1);
    dSetMessageHandler(on_message);
    dSetErrorHandler(on_failure);
    dSetDebugHandler(on_failure);
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
  if (is_broken_) return;  // ODE's jobs of the step are still queued: it would fail its assertions again
  dJointGroupDestroy(contacts_);
  dWorldDestroy(world_);
  dThreadingFreeImplementation(threading_);
}

void OdeSession::step(double seconds) {
  try {
    dWorldStep(world_, seconds);
  } catch (const PhysicsError&) {
    is_broken_ = true;
    throw;
  }
  dJointGroupEmpty(contacts_);
}

std::string OdeSession::take_complaint() { return std::exchange(complaint, ""); }

void OdeSession::prepare_thread() {
  thread_local const int prepared =
      (open_ode(), dAllocateODEDataForThread(static_cast<unsigned>(dAllocateMaskAll)));
  static_cast<void>(prepared);
}

}  // namespace caravan::world
