// SPDX-License-Identifier: Apache-2.0
#include "deploy/control/run_ctl.hpp"

#include <condition_variable>
#include <cstdio>
#include <mutex>
#include <optional>
#include <utility>

#include "deploy/control/requester.hpp"
#include "deploy/control/words.hpp"
#include "idl/stamp.hpp"
#include "idl/world_types.hpp"
#include "runtime/config/start_error.hpp"
#include "runtime/host/domain_users.hpp"
#include "runtime/process/run_process.hpp"

namespace caravan::deploy {
namespace {

using namespace std::chrono_literals;
namespace msg = caravan_interfaces::msg;

constexpr auto kStatusPatience = 10s;
constexpr auto kAnswerPatience = 10s;
// Longer than this process runs. Fast DDS 2.9 aborts when it checks a lease at the moment at which its
// participant leaves, and a mere request must not put the world at risk.
constexpr double kLease_s = 60.0;

/// Keeps the latest status of the world.
class WorldWatch {
 public:
  void join(runtime::Bus& bus) {
    bus.reader<msg::WorldStatusPubSubType>(idl::kWorldStatus, 0,
                                           [this](const msg::WorldStatus& one, const auto&) {
                                             const std::lock_guard lock{mutex_};
                                             newest_ = one;
                                             changed_.notify_all();
                                           });
  }
  [[nodiscard]] std::optional<msg::WorldStatus> wait() {
    std::unique_lock lock{mutex_};
    changed_.wait_for(lock, kStatusPatience, [this] { return newest_.has_value(); });
    return newest_;
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::optional<msg::WorldStatus> newest_;
};

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text.empty() ? "-" : text;
}

void print(const msg::WorldStatus& status) {
  const char* state = status.state() == msg::WorldStatus_Constants::WAITING    ? "waiting"
                      : status.state() == msg::WorldStatus_Constants::FINISHED ? "finished"
                      : status.paused()                                        ? "paused"
                                                                               : "running";
  std::printf(
      "%s  steps %llu  simulated %.3f s  members %u  items %u%s\nmissing %s\nhung %s\ngone %s\nremoved %s\n",
      state, static_cast<unsigned long long>(status.steps()),
      std::chrono::duration<double>(idl::to_time(status.stamp())).count(), status.members(),
      status.items_delivered(), status.disturbed() ? "  disturbed" : "", listed(status.missing()).c_str(),
      listed(status.hung()).c_str(), listed(status.gone()).c_str(), listed(status.removed()).c_str());
}

int print(const ControlAnswer& answer) {
  const auto step = static_cast<unsigned long long>(answer.step);
  if (answer.kind == ControlAnswer::Kind::kDone) std::printf("done at step %llu\n", step);
  if (answer.kind == ControlAnswer::Kind::kScheduled) std::printf("scheduled for step %llu\n", step);
  if (answer.is_good()) return runtime::kDone;
  const char* how = answer.kind == ControlAnswer::Kind::kRefused ? "refused: " : "";
  std::fprintf(stderr, "%s%s\n", how, answer.reason.c_str());
  return runtime::kFailed;
}

std::optional<msg::ControlRequest> read(const std::vector<std::string>& words) {
  try {
    return read_control(Words{words});
  } catch (const WordsError& error) {
    throw runtime::StartError{std::string{"caravan ctl: "} + error.what()};
  }
}

}  // namespace

std::string ctl_help() {
  std::string text =
      "Requests:\n  status  state of the world\nRequests that take effect at once, or in the step of a final "
      "`at STEP`:\n";
  for (const ControlForm& form : control_forms())
    text += "  " + std::string{form.form} + "  " + std::string{form.meaning} + "\n";
  return text;
}

int run_ctl(std::uint32_t domain, runtime::Transport transport, const std::vector<std::string>& words) {
  const bool only_status = words[0] == "status";
  if (only_status && words.size() > 1)
    throw runtime::StartError{"caravan ctl: status takes no further words, such as \"" + words[1] + "\""};
  const auto request = read(words);
  if (!request && !only_status)
    throw runtime::StartError{"caravan ctl: \"" + words[0] + "\" is not a request, see caravan ctl --help"};
  // Does not join: it would only disturb processes that cannot use its shared memory.
  if (const auto other = runtime::other_user_in(domain);
      other && transport == runtime::Transport::kSharedMemory) {
    const std::string user = runtime::user_text(*other);
    std::fprintf(stderr, "the run in DDS domain %u is another user's (%s): ask as %s\n", domain, user.c_str(),
                 user.c_str());
    return runtime::kFailed;
  }
  WorldWatch world;
  Requester requester;
  runtime::Bus bus{{.role = "ctl", .domain = domain, .lease_s = kLease_s, .transport = std::move(transport)}};
  world.join(bus);
  requester.join(bus);
  const auto status = world.wait();
  if (!status) {
    const auto holder = runtime::holder_of(domain);
    const std::string who =
        holder ? ", although a run holds it (" + to_text(*holder) + "); does --transport match that run's?"
               : "";
    std::fprintf(stderr, "no world in DDS domain %u%s\n", domain, who.c_str());
    bus.close();
    return runtime::kFailed;
  }
  int code = runtime::kDone;
  if (only_status) {
    print(*status);
  } else {
    msg::ControlRequest asked = *request;
    asked.session(status->session());
    code = print(requester.ask(asked, kAnswerPatience));
  }
  bus.close();
  return code;
}

}  // namespace caravan::deploy
