// SPDX-License-Identifier: Apache-2.0
#include "deploy/doctor/run_doctor.hpp"

#include <algorithm>
#include <cstdio>

#include "deploy/doctor/collect.hpp"
#include "deploy/doctor/findings.hpp"
#include "runtime/host/shared_memory.hpp"
#include "runtime/process/run_process.hpp"

namespace caravan::deploy {
namespace {

const char* word_for(Finding::Severity severity) {
  switch (severity) {
    case Finding::Severity::kGood:
      return "ok";
    case Finding::Severity::kWarning:
      return "warning";
    case Finding::Severity::kProblem:
      return "PROBLEM";
  }
  return "";
}

}  // namespace

int run_doctor(const DoctorRequest& request) {
  if (request.clean) {
    const auto removed = runtime::remove_left_by_the_dead();
    std::printf("removed %zu files from /dev/shm\n", removed);
  }
  const auto findings = examine(look_at_host(request.robots, request.domain, request.transport));
  for (const Finding& finding : findings) {
    std::printf("%-8s %-15s %s\n", word_for(finding.severity), finding.subject.c_str(), finding.seen.c_str());
    if (!finding.advice.empty()) std::printf("%-8s %-15s -> %s\n", "", "", finding.advice.c_str());
  }
  const bool bad = std::any_of(findings.begin(), findings.end(), [](const Finding& finding) {
    return finding.severity == Finding::Severity::kProblem;
  });
  return bad ? runtime::kFailed : runtime::kDone;
}

}  // namespace caravan::deploy
