// SPDX-License-Identifier: Apache-2.0
#include "runtime/process/loop.hpp"

#include <poll.h>
#include <sys/eventfd.h>
#include <sys/signalfd.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <string>
#include <vector>

#include "runtime/config/start_error.hpp"
#include "runtime/process/service_manager.hpp"

namespace caravan::runtime {
namespace {

int made(int descriptor, const char* what) {
  if (descriptor < 0) throw StartError{std::string{what} + ": " + std::strerror(errno)};
  return descriptor;
}

void raise_event(int descriptor) {
  const std::uint64_t one = 1;
  while (write(descriptor, &one, sizeof one) < 0 && errno == EINTR) {
  }
}

/// False: whoever started this process wants the signal ignored, as nohup does.
bool is_heeded(int number) {
  struct sigaction action {};
  sigaction(number, nullptr, &action);
  return action.sa_handler != SIG_IGN;
}

}  // namespace

Loop::Loop() {
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, SIGINT);
  sigaddset(&set, SIGTERM);
  sigaddset(&set, SIGCONT);
  if (is_heeded(SIGHUP)) sigaddset(&set, SIGHUP);
  pthread_sigmask(SIG_BLOCK, &set, nullptr);
  signals_ = made(signalfd(-1, &set, SFD_CLOEXEC | SFD_NONBLOCK), "signalfd");
  wakeups_ = made(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK), "eventfd");
  stops_ = made(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK), "eventfd");
  if (const auto period = watchdog_period()) watchdog_ = *period / 2;
}

Loop::~Loop() {
  for (const int descriptor : {signals_, wakeups_, stops_}) {
    if (descriptor >= 0) close(descriptor);
  }
}

Loop::Woken Loop::wait(std::optional<WallTime> deadline, std::span<Polled> others) {
  if (!was_ready_) tell_service_manager("READY=1");
  was_ready_ = true;
  const WallTime began = std::chrono::steady_clock::now();
  if (watchdog_ && began >= alive_due_) {
    tell_service_manager("WATCHDOG=1");
    alive_due_ = began + *watchdog_;
  }
  const bool must_come_back = watchdog_ && (!deadline || alive_due_ < *deadline);
  continued_ = false;
  const Woken woken = wait_until(must_come_back ? alive_due_ : deadline, others);
  passed_ = std::chrono::steady_clock::now() - began;
  if (woken == Woken::kStop) tell_service_manager("STOPPING=1");
  return woken == Woken::kDeadline && must_come_back ? Woken::kNotified : woken;
}

Loop::Woken Loop::wait_until(std::optional<WallTime> deadline, std::span<Polled> others) {
  if (interrupted_) return Woken::kStop;
  std::vector<pollfd> watched{{signals_, POLLIN, 0}, {stops_, POLLIN, 0}, {wakeups_, POLLIN, 0}};
  for (const Polled& other : others) {
    watched.push_back(
        {other.descriptor, static_cast<short>(other.for_writing ? POLLIN | POLLOUT : POLLIN), 0});
  }
  for (;;) {
    timespec left{};
    if (deadline) {
      const auto remaining = std::max(std::chrono::nanoseconds{0},
                                      std::chrono::nanoseconds{*deadline - std::chrono::steady_clock::now()});
      left.tv_sec = static_cast<time_t>(remaining.count() / 1'000'000'000);
      left.tv_nsec = static_cast<long>(remaining.count() % 1'000'000'000);
    }
    const int ready = ppoll(watched.data(), watched.size(), deadline ? &left : nullptr, nullptr);
    if (ready < 0 && errno == EINTR) continue;
    bool any_ready = false;
    for (std::size_t i = 0; i < others.size(); ++i) {
      others[i].ready = watched[3 + i].revents != 0;
      any_ready = any_ready || others[i].ready;
    }
    if (watched[0].revents != 0) {
      signalfd_siginfo signal{};
      if (read(signals_, &signal, sizeof signal) == sizeof signal && signal.ssi_signo == SIGCONT) {
        continued_ = true;
        return Woken::kNotified;
      }
      interrupted_ = true;
      return Woken::kStop;
    }
    if (watched[1].revents != 0) return Woken::kStop;
    if (watched[2].revents != 0) {
      std::uint64_t count = 0;
      (void)!read(wakeups_, &count, sizeof count);
      return Woken::kNotified;
    }
    return any_ready ? Woken::kReady : Woken::kDeadline;
  }
}

void Loop::notify() { raise_event(wakeups_); }

void Loop::stop() { raise_event(stops_); }

}  // namespace caravan::runtime
