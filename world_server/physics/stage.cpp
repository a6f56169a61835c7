// SPDX-License-Identifier: Apache-2.0
#include "world_server/physics/stage.hpp"

namespace caravan::world {
namespace {

constexpr double kGravity = 9.81;
// Fraction of a position error of the joints that one physics step corrects. A wheel that moves along its
// tangent leaves its circle a little in each step: the uncorrected part widens the track.
constexpr double kJointCorrection = 0.8;
// Keeps resting contacts closed, so that wheels neither bounce nor rattle.
constexpr double kSurfaceLayer = 0.0005;
// A body that penetrates another is pushed out no faster than this, so that nothing is thrown away.
constexpr double kMaxPushOut = 1.0;
constexpr int kFloorContacts = 4;

}  // namespace

Stage::Stage(const WorldConfig& config, const Statics& statics, std::size_t robots)
    : plan_{config.robots},
      statics_{statics},
      hull_radius_{body_radius_m(config.robots)},
      spring_{calm_spring(config.robots.mass_kg, config.step_s / config.substeps)},
      bumps_{plan_.mass_centre[2]} {
  ode_.prepare_thread();
  for (std::size_t i = 0; i < robots; ++i) robots_.push_back(build_robot(ode_.world(), plan_));
  dWorldSetERP(ode_.world(), kJointCorrection);
  dWorldSetGravity(ode_.world(), 0.0, 0.0, -kGravity);
  dWorldSetContactSurfaceLayer(ode_.world(), kSurfaceLayer);
  dWorldSetContactMaxCorrectingVel(ode_.world(), kMaxPushOut);
}

Stage::~Stage() {
  for (const RobotBody& robot : robots_) dGeomDestroy(robot.hull);
}

void Stage::stand(std::size_t place, const RobotState& state) {
  const RobotBody& robot = robots_[place];
  add_floor_contacts(ode_.world(), ode_.contacts(), robot, plan_);
  if (state.push_n != 0.0) dBodyAddRelForce(robot.chassis, state.push_n, 0.0, 0.0);
  if (!is_upright(state)) collide_with_floor(place);
}

bool Stage::bump(std::size_t place, Point base) {
  bumps_.clear();
  bool touched = false;
  statics_.near(base, hull_radius_,
                [&](dGeomID thing) { touched = bumps_.add(robots_[place].hull, thing) || touched; });
  world::hold_apart(ode_, bumps_.all());
  return touched;
}

/// A hull that an impact has tipped rests with its edge on the floor.
void Stage::collide_with_floor(std::size_t place) {
  dContactGeom geoms[kFloorContacts];
  const RobotBody& robot = robots_[place];
  const int count = dCollide(robot.hull, statics_.floor(), kFloorContacts, geoms, sizeof(dContactGeom));
  for (int i = 0; i < count; ++i) {
    dContact contact{};
    contact.geom = geoms[i];
    dJointAttach(dJointCreateContact(ode_.world(), ode_.contacts(), &contact), robot.chassis, nullptr);
  }
}

bool Stage::meet() {
  bumps_.clear();
  return bumps_.add(robots_[0].hull, robots_[1].hull);
}

void Stage::hold_apart(std::span<const dContactGeom> contacts) { world::hold_apart(ode_, contacts); }

void Stage::push_apart(std::span<const dContactGeom> contacts) { world::push_apart(contacts, spring_); }

}  // namespace caravan::world
