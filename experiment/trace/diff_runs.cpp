// SPDX-License-Identifier: Apache-2.0
#include "experiment/trace/diff_runs.hpp"

#include <optional>
#include <sstream>
#include <stdexcept>

#include "experiment/metrics/csv_file.hpp"
#include "experiment/metrics/text_file.hpp"
#include "experiment/run_request.hpp"
#include "experiment/trace/compare.hpp"
#include "experiment/trace/trace_reader.hpp"
#include "runtime/config/start_error.hpp"
#include "runtime/pure/digest.hpp"
#include "runtime/pure/hash_chain.hpp"
#include "runtime/trace/trace_file.hpp"

namespace caravan::experiment {
namespace {

namespace fs = std::filesystem;
using Bytes = std::vector<std::uint8_t>;

/// Both traces of one run, read in parallel.
class RunTrace {
 public:
  explicit RunTrace(const fs::path& folder)
      : name_{folder.string()},
        world_{world_trace_in(folder / "trace"), runtime::kWorldTrace},
        radio_{radio_trace_in(folder / "trace"), runtime::kRadioTrace} {}

  /// @return false: no further step is whole in both traces
  bool next() {
    const bool world = world_.next(world_bytes_);
    const bool radio = radio_.next(radio_bytes_);
    cut_off_ = world_.cut_off() || radio_.cut_off() || world != radio;
    if (!world || !radio) return false;
    world_chain_.link(world_bytes_);
    radio_chain_.link(radio_bytes_);
    ++steps_;
    return true;
  }
  [[nodiscard]] TracedStep step() const {
    try {
      return {read_world_step(world_bytes_, world_.number()), read_radio_step(radio_bytes_)};
    } catch (const std::runtime_error& error) {
      throw runtime::StartError{name_ + "/trace: is damaged in step " + std::to_string(steps_) + ": " +
                                error.what()};
    }
  }
  [[nodiscard]] bool equals(const RunTrace& other) const {
    return world_bytes_ == other.world_bytes_ && radio_bytes_ == other.radio_bytes_;
  }
  [[nodiscard]] std::string digest() const {
    return pure::digest(world_chain_.value(), radio_chain_.value());
  }
  [[nodiscard]] std::uint32_t robots() const { return world_.number(); }
  [[nodiscard]] std::uint64_t steps() const { return steps_; }
  [[nodiscard]] bool cut_off() const { return cut_off_; }
  [[nodiscard]] const std::string& name() const { return name_; }

 private:
  std::string name_;
  TraceReader world_;
  TraceReader radio_;
  Bytes world_bytes_;
  Bytes radio_bytes_;
  pure::HashChain world_chain_;
  pure::HashChain radio_chain_;
  std::uint64_t steps_ = 0;
  bool cut_off_ = false;
};

/// Prints the first line in which the runs' scenarios differ, if any.
void compare_scenarios(const fs::path& one, const fs::path& other, std::FILE* out) {
  std::istringstream ones{text_in(one / "scenario.toml").value_or("")};
  std::istringstream others{text_in(other / "scenario.toml").value_or("")};
  std::string here;
  std::string there;
  for (int line = 1;; ++line) {
    const bool more = static_cast<bool>(std::getline(ones, here));
    const bool others_more = static_cast<bool>(std::getline(others, there));
    if (!more && !others_more) return;
    if (more && others_more && here == there) continue;
    std::fprintf(out, "the scenarios differ: scenario.toml line %d: %s | %s\n", line,
                 more ? here.c_str() : "end", others_more ? there.c_str() : "end");
    return;
  }
}

void tell(const Difference& difference, std::FILE* out) {
  const std::string whose = difference.robot == 0 ? "" : "robot " + std::to_string(difference.robot) + " ";
  std::fprintf(out, "%s%s: %s | %s\n", whose.c_str(), difference.quantity.c_str(), difference.one.c_str(),
               difference.other.c_str());
}

void tell_of_step(const RunTrace& one, const RunTrace& other, std::FILE* out) {
  const TracedStep step = one.step();
  const auto found = differences(step, other.step());
  if (found.empty())
    throw runtime::StartError{one.name() + "/trace: is damaged in step " + std::to_string(one.steps())};
  std::fprintf(out, "step %llu (%s s): ", static_cast<unsigned long long>(one.steps()),
               fixed(static_cast<double>(step.radio.stamp_ns) * 1e-9, 3).c_str());
  tell(found.front(), out);
  if (found.size() > 1) std::fprintf(out, "%zu more values differ in this step\n", found.size() - 1);
}

void tell_of_cut(const RunTrace& run, std::FILE* out) {
  if (!run.cut_off()) return;
  std::fprintf(out, "%s: its trace is incomplete after step %llu\n", run.name().c_str(),
               static_cast<unsigned long long>(run.steps()));
}

}  // namespace

int diff_runs(const fs::path& one, const fs::path& other, std::FILE* out) {
  RunTrace ones{one};
  RunTrace others{other};
  compare_scenarios(one, other, out);
  if (ones.robots() != others.robots()) {
    std::fprintf(out, "the runs differ in robots: %u | %u\n", ones.robots(), others.robots());
    return 1;
  }
  for (;;) {
    const bool more = ones.next();
    const bool others_more = others.next();
    if (more && others_more) {
      if (ones.equals(others)) continue;
      tell_of_step(ones, others, out);
      return 1;
    }
    tell_of_cut(ones, out);
    tell_of_cut(others, out);
    if (!more && !others_more) break;
    const std::uint64_t common = more ? others.steps() : ones.steps();
    std::fprintf(out, "equal up to step %llu, where %s ends\n", static_cast<unsigned long long>(common),
                 (more ? others : ones).name().c_str());
    return 1;
  }
  std::fprintf(out, "equal: %llu steps, digest %s\n", static_cast<unsigned long long>(ones.steps()),
               ones.digest().c_str());
  return 0;
}

}  // namespace caravan::experiment
