// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <chrono>
#include <condition_variable>
#include <filesystem>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace caravan::runtime {

/// How a child ended.
struct Ended {
  std::string name;
  pid_t pid = 0;
  int exit_code = 0;  ///< 128 + n when signal n killed it
};

/// Text such as "ended with exit code 7, its log says why". After SIGKILL no log gives a reason.
[[nodiscard]] std::string how(const Ended& ended);

/// The run's processes: started as direct children, each with a log file, and stopped together.
///
/// A thread waits for their ends, so that nothing polls. Children receive SIGTERM when this process dies.
class Children {
 public:
  /// @param log_folder  exists; each child's standard error and output go to <name>.log in it
  /// @param on_end      called on the waiting thread after each end
  /// @param shared      descriptors that the children inherit, such as locks that must last as long as they
  ///                    do; they get no others
  Children(std::filesystem::path log_folder, std::function<void()> on_end, std::vector<int> shared = {});
  /// Stops those that still run.
  ~Children();
  Children(const Children&) = delete;
  Children& operator=(const Children&) = delete;

  /// @throws StartError when it cannot be started
  void start(const std::string& name, const std::vector<std::string>& command_line);
  /// Starts waiting for ends, of children started before and after.
  void watch();
  /// Ends since the last call, in order.
  [[nodiscard]] std::vector<Ended> ended();
  [[nodiscard]] std::vector<pid_t> running() const;
  /// SIGTERM to all, SIGKILL to those that need longer than `patience`. @return names of those killed
  std::vector<std::string> stop(std::chrono::milliseconds patience);

 private:
  void wait_for_ends();
  void signal_all(int signal) const;
  bool wait_until_none(std::chrono::milliseconds patience);

  std::filesystem::path log_folder_;
  std::function<void()> on_end_;
  std::vector<int> shared_;
  mutable std::mutex mutex_;
  std::condition_variable started_;
  std::condition_variable none_left_;
  std::map<pid_t, std::string> running_;
  std::vector<Ended> ended_;
  bool closing_ = false;
  std::thread waiter_;
};

}  // namespace caravan::runtime
