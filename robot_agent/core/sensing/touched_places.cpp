// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/core/sensing/touched_places.hpp"

#include <algorithm>

namespace caravan::agent {
namespace {

bool within(const Point& a, const Point& b, double distance_m) {
  return (a - b).squaredNorm() < distance_m * distance_m;
}

}  // namespace

bool TouchedPlaces::add(const Point& at_W, const Point& towards_W) {
  const Place place{at_W, at_W + memory_.margin_m * towards_W};
  const auto known = std::ranges::find_if(
      places_, [&](const Place& one) { return within(one.at, at_W, memory_.same_place_m); });
  if (known != places_.end()) {
    std::rotate(known, known + 1, places_.end());
    places_.back() = place;
    return false;
  }
  if (places_.size() >= memory_.places) places_.erase(places_.begin());
  places_.push_back(place);
  return true;
}

void TouchedPlaces::stand_on(const Pose& pose, const Body& body) {
  std::erase_if(places_, [&](const Place& place) {
    return signed_distance_m(pose, place.at, body) < -memory_.overlap_m;
  });
}

void TouchedPlaces::forget_around(const Point& p_W, double radius_m) {
  std::erase_if(places_, [&](const Place& place) { return within(place.at, p_W, radius_m); });
}

std::vector<Point> TouchedPlaces::at(const Point& p_W, double radius_m) const {
  std::vector<Point> result;
  for (const Place& place : places_) {
    if (within(place.at, p_W, radius_m)) result.push_back(place.at);
  }
  return result;
}

std::vector<Point> TouchedPlaces::middles(const Point& p_W, double radius_m) const {
  std::vector<Point> result;
  for (const Place& place : places_) {
    if (within(place.middle, p_W, radius_m)) result.push_back(place.middle);
  }
  return result;
}

}  // namespace caravan::agent
