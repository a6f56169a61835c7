// SPDX-License-Identifier: Apache-2.0
#include "runtime/controller/crash_line.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <utility>

namespace caravan::runtime {
namespace {

constexpr std::array<std::pair<int, const char*>, 5> kFaults{
    {{SIGSEGV, "SIGSEGV"}, {SIGBUS, "SIGBUS"}, {SIGFPE, "SIGFPE"}, {SIGILL, "SIGILL"}, {SIGABRT, "SIGABRT"}}};
std::array<struct sigaction, kFaults.size()> previous{};

struct Inside {
  const char* who = nullptr;  // null: outside
  std::uint64_t step = 0;
  std::uint64_t now_ms = 0;
};
thread_local Inside inside;
int code_of_exit = 0;
bool is_watched = false;

/// A line in parts, without memory from the heap: a signal handler may not ask for any.
class Line {
 public:
  void add(const char* text) {
    const std::size_t size = std::min(std::strlen(text), text_.size() - size_);
    std::memcpy(text_.data() + size_, text, size);
    size_ += size;
  }
  void add(std::uint64_t number) {
    std::array<char, 24> digits{};
    std::size_t first = digits.size() - 1;  // the last one stays 0
    do {
      digits[--first] = static_cast<char>('0' + number % 10);
      number /= 10;
    } while (number > 0);
    add(digits.data() + first);
  }
  void write_to_stderr() const { (void)!write(STDERR_FILENO, text_.data(), size_); }

 private:
  std::array<char, 512> text_{};
  std::size_t size_ = 0;
};

void name_it(const char* what, const char* name) {
  Line line;
  line.add(inside.who);
  if (inside.step > 0) {
    line.add(", step ");
    line.add(inside.step);
    line.add(" (");
    line.add(inside.now_ms / 1000);
    line.add(inside.now_ms % 1000 < 10 ? ".00" : inside.now_ms % 1000 < 100 ? ".0" : ".");
    line.add(inside.now_ms % 1000);
    line.add(" s)");
  } else {
    line.add(", its constructor");
  }
  line.add(what);
  line.add(name);
  line.add("\n");
  line.write_to_stderr();
}

void on_fault(int number) {
  for (std::size_t i = 0; i < kFaults.size(); ++i) {
    if (kFaults[i].first != number) continue;
    if (inside.who != nullptr) name_it(": ends the process by ", kFaults[i].second);
    sigaction(number, &previous[i], nullptr);
  }
  raise(number);  // is delivered to whom it was for when this handler returns
}

void on_exit() {
  if (inside.who == nullptr) return;
  name_it(": has called ", "exit()");
  std::_Exit(code_of_exit);
}

/// Functions given to atexit() are called last first. DDS gives some when it starts, which wait for the
/// thread that is inside the controller; this one, given at the first step, comes before them.
void come_before_dds() {
  static const bool is_done = std::atexit(on_exit) == 0;
  (void)is_done;
}

/// Room for the handler when its thread's own stack is full. Each thread needs one of its own.
class HandlerStack {
 public:
  HandlerStack() {
    stack_t present{};
    if (sigaltstack(nullptr, &present) != 0 || (present.ss_flags & SS_DISABLE) == 0) return;  // has one
    room_ = std::make_unique<Room>();
    stack_t ours{};
    ours.ss_sp = room_->data();
    ours.ss_size = room_->size();
    sigaltstack(&ours, nullptr);
  }
  ~HandlerStack() {
    if (!room_) return;
    stack_t none{};
    none.ss_flags = SS_DISABLE;
    sigaltstack(&none, nullptr);
  }
  HandlerStack(const HandlerStack&) = delete;
  HandlerStack& operator=(const HandlerStack&) = delete;

 private:
  using Room = std::array<char, std::size_t{64} * 1024>;
  std::unique_ptr<Room> room_;
};

}  // namespace

void name_crashing_controllers(int exit_code) {
  code_of_exit = exit_code;
  static const bool is_done = [] {
    for (std::size_t i = 0; i < kFaults.size(); ++i) {
      struct sigaction action {};
      action.sa_handler = on_fault;
      action.sa_flags = SA_ONSTACK;
      sigaction(kFaults[i].first, &action, &previous[i]);
    }
    return std::atexit(on_exit) == 0;
  }();
  is_watched = is_done;
}

InsideController::InsideController(const char* who, std::uint64_t step, std::chrono::nanoseconds now) {
  static const thread_local HandlerStack stack;
  if (is_watched && step > 0) come_before_dds();
  inside = {who, step,
            static_cast<std::uint64_t>(std::chrono::round<std::chrono::milliseconds>(now).count())};
}

InsideController::~InsideController() { inside = {}; }

}  // namespace caravan::runtime
