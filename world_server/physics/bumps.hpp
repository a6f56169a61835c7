// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ode/ode.h>

#include <cstdint>
#include <span>
#include <vector>

#include "world_server/physics/ode_session.hpp"

namespace caravan::world {

/// Contacts of one hull: at the height of the centre of mass, normals horizontal and pointing into the hull.
///
/// All hulls are upright, so contacts above each other are redundant and are merged: an impact turns a robot
/// but does not tip it, and the solver has half as many contacts, none of which depend on each other.
class Bumps {
 public:
  explicit Bumps(double height) : height_{height} {}

  /// Adds the contacts of `hull` and `thing`. @return whether they touch
  bool add(dGeomID hull, dGeomID thing);
  [[nodiscard]] std::span<const dContactGeom> all() const { return contacts_; }
  void clear() { contacts_.clear(); }

 private:
  void merge(dContactGeom contact);

  double height_;
  std::vector<dContactGeom> contacts_;
};

/// Makes the contacts hard for the next physics step: the solver finds the forces that prevent penetration.
void hold_apart(const OdeSession& ode, std::span<const dContactGeom> contacts);

/// A spring and a damper that push two hulls apart in the next physics step.
struct Spring {
  double stiffness_n_per_m = 0.0;
  double damping_ns_per_m = 0.0;
};

/// The stiffest spring that is stable when five others press a body of this mass.
[[nodiscard]] Spring calm_spring(double mass_kg, double substep_s);

void push_apart(std::span<const dContactGeom> contacts, const Spring& spring);

}  // namespace caravan::world
