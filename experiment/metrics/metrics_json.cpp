// SPDX-License-Identifier: Apache-2.0
#include "experiment/metrics/metrics_json.hpp"

#include <nlohmann/json.hpp>

namespace caravan::experiment {
namespace {

using Json = nlohmann::ordered_json;

Json or_null(const std::optional<Time>& time) { return time ? Json(in_seconds(*time)) : Json(nullptr); }

Json robot_json(const RobotResult& robot) {
  return {{"id", robot.id},
          {"found_s", or_null(robot.found)},
          {"received_s", or_null(robot.received)},
          {"items", robot.items},
          {"path_length_m", robot.path_length_m ? Json(*robot.path_length_m) : Json(nullptr)},
          {"driving_s", in_seconds(robot.times.driving)},
          {"exchanging_s", in_seconds(robot.times.exchanging)},
          {"avoiding_s", in_seconds(robot.times.avoiding)},
          {"stuck_s", in_seconds(robot.times.stuck)},
          {"idle_s", in_seconds(robot.times.idle)},
          {"longest_stuck_s", in_seconds(robot.times.longest_stuck)}};
}

}  // namespace

std::string metrics_json(const RunFacts& facts, const Result& result, const RunEnd& end, bool ended) {
  const Outcome outcome = outcome_of(facts, end, result.items_delivered, result.sim_time);
  const double sim_time_s = in_seconds(result.sim_time);
  Json json = {
      {"scenario", facts.scenario},
      {"engine", facts.engine},
      {"mode", facts.mode},
      {"seed", facts.seed},
      {"robots", facts.robots},
      {"ended", ended},
      {"completed", outcome == Outcome::kCompleted},
      {"disturbed", end.disturbed},
      {"interrupted", end.interrupted},
      {"failure", end.failure},
      {"items_delivered", result.items_delivered},
      {"sim_time_s", sim_time_s},
      {"wall_time_s", end.wall_time_s},
      {"real_time_factor", end.wall_time_s > 0.0 ? sim_time_s / end.wall_time_s : 0.0},
      {"digest", end.digest},
      {"round_trip_mean_s", result.round_trip_mean_s},
      {"routes", result.routes},
      {"exchanges",
       {{"completed", result.exchanges_completed},
        {"failed", result.exchanges_failed},
        {"mean_duration_s", result.exchange_mean_s}}},
      {"contacts",
       {{"robot_robot", result.robot_robot_contacts}, {"robot_static", result.robot_static_contacts}}},
      {"commands", {{"refused", end.refusals.commands_refused}, {"clamped", end.refusals.commands_clamped}}},
      {"frames",
       {{"over_mtu", end.refusals.frames_over_mtu},
        {"bad_channel", end.refusals.frames_on_bad_channel},
        {"lost", end.refusals.frames_lost},
        {"queue_full", end.refusals.frames_queue_full},
        {"malformed", result.malformed_frames}}},
      {"strangers", end.strangers},
      {"per_robot", Json::array()},
      {"time_split",
       {{"physics", end.time_split.physics_s},
        {"sensors", end.time_split.sensors_s},
        {"radio", end.time_split.radio_s},
        {"agents", end.time_split.agents_s},
        {"transport", end.time_split.transport_s}}}};
  for (const RobotResult& robot : result.robots) json["per_robot"].push_back(robot_json(robot));
  // What is not UTF-8 in what others have said is replaced.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace caravan::experiment
