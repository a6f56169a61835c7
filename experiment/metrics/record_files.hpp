// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "experiment/metrics/csv_file.hpp"
#include "experiment/metrics/event_book.hpp"
#include "experiment/metrics/observation.hpp"
#include "experiment/metrics/trip_book.hpp"

namespace caravan::experiment {

/// tracks.csv, trips.csv, events.csv, activities.csv and path_lengths.csv of a run, written during the run.
/// docs/outputs.md has the columns.
class RecordFiles {
 public:
  /// @throws runtime::StartError when a file cannot be written
  RecordFiles(const std::filesystem::path& folder, std::uint32_t robots);

  /// @pre stamps never decrease
  void observe(const Observation& observation);
  /// @throws runtime::WriteError
  void flush();
  /// Adds the unfinished trips; call it once, after the last observation and before the last flush().
  void finish();

 private:
  struct Robot {
    Mode mode = Mode::kExplore;
    std::optional<Activity> activity{};  // as last reported
  };
  [[nodiscard]] Robot* find(std::uint32_t robot);
  void record_report(Time stamp, const AgentReport& report);
  void record_tracks(const Observation& observation);
  void record_trip(const Trip& trip);

  CsvFile tracks_;
  CsvFile trips_;
  CsvFile events_;
  CsvFile activities_;
  CsvFile path_lengths_;
  std::vector<Robot> robots_;
  TripBook trip_book_;
  EventBook event_book_;
  Time next_track_{0};
};

}  // namespace caravan::experiment
