// SPDX-License-Identifier: Apache-2.0
#include "world_server/physics/bumps.hpp"

#include <algorithm>
#include <cmath>

namespace caravan::world {
namespace {

constexpr int kMaxContacts = 8;  // per pair
constexpr double kSamePlace = 0.005;
constexpr double kSameWay = 0.95;  // cosine

// N, the largest friction force of one contact point of a hull. A fixed force, not a fraction of the normal
// force: with the latter the solver gets contacts that neither press nor hold, and fails on them.
constexpr double kGrip = 2.0;
// m/s per N. Hulls that lie flat against each other have more contacts than are needed to determine their
// forces; without this the solver's matrix is singular.
constexpr double kSoftness = 1e-4;
// Fraction of a penetration that one physics step corrects.
constexpr double kCorrection = 0.2;

double level(const dReal* a, const dReal* b) { return a[0] * b[0] + a[1] * b[1]; }

}  // namespace

bool Bumps::add(dGeomID hull, dGeomID thing) {
  dContactGeom found[kMaxContacts];
  const int count = dCollide(hull, thing, kMaxContacts, found, sizeof(dContactGeom));
  for (int i = 0; i < count; ++i) merge(found[i]);
  return count > 0;
}

void Bumps::merge(dContactGeom contact) {
  const double flat = std::hypot(contact.normal[0], contact.normal[1]);
  if (flat < 0.5) return;  // one hull on top of another: cannot happen in an upright world
  contact.normal[0] /= flat;
  contact.normal[1] /= flat;
  contact.normal[2] = 0.0;
  contact.pos[2] = height_;
  for (dContactGeom& known : contacts_) {
    const double apart = std::hypot(known.pos[0] - contact.pos[0], known.pos[1] - contact.pos[1]);
    if (apart > kSamePlace || level(known.normal, contact.normal) < kSameWay) continue;
    known.depth = std::max(known.depth, contact.depth);
    return;
  }
  contacts_.push_back(contact);
}

void hold_apart(const OdeSession& ode, std::span<const dContactGeom> contacts) {
  for (const dContactGeom& geom : contacts) {
    dContact contact{};
    contact.geom = geom;
    contact.surface.mode = dContactSoftCFM | dContactSoftERP | dContactFDir1 | dContactMu2;
    contact.surface.soft_cfm = kSoftness;
    contact.surface.soft_erp = kCorrection;
    contact.surface.mu = kGrip;  // horizontal; mu2, vertical: none
    contact.fdir1[0] = -geom.normal[1];
    contact.fdir1[1] = geom.normal[0];
    const dJointID joint = dJointCreateContact(ode.world(), ode.contacts(), &contact);
    dJointAttach(joint, dGeomGetBody(geom.g1), dGeomGetBody(geom.g2));
  }
}

Spring calm_spring(double mass_kg, double substep_s) {
  // The integrator is stable for (k h^2 + 2 c h) / m < 4, summed over all neighbours of a body. Off its
  // centre a body reacts as if it had half its mass, so each of five neighbours may use 0.4.
  return {.stiffness_n_per_m = 0.16 * mass_kg / (substep_s * substep_s),
          .damping_ns_per_m = 0.1 * mass_kg / substep_s};
}

void push_apart(std::span<const dContactGeom> contacts, const Spring& spring) {
  for (const dContactGeom& contact : contacts) {
    const dBodyID one = dGeomGetBody(contact.g1);
    const dBodyID other = dGeomGetBody(contact.g2);
    dVector3 speed_one;
    dVector3 speed_other;
    dBodyGetPointVel(one, contact.pos[0], contact.pos[1], contact.pos[2], speed_one);
    dBodyGetPointVel(other, contact.pos[0], contact.pos[1], contact.pos[2], speed_other);
    const double parting = level(speed_one, contact.normal) - level(speed_other, contact.normal);
    const double whole = spring.stiffness_n_per_m * contact.depth - spring.damping_ns_per_m * parting;
    const double force = std::max(0.0, whole) / static_cast<double>(contacts.size());
    const double x = force * contact.normal[0];
    const double y = force * contact.normal[1];
    dBodyAddForceAtPos(one, x, y, 0.0, contact.pos[0], contact.pos[1], contact.pos[2]);
    dBodyAddForceAtPos(other, -x, -y, 0.0, contact.pos[0], contact.pos[1], contact.pos[2]);
  }
}

}  // namespace caravan::world
