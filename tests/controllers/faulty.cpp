// SPDX-License-Identifier: Apache-2.0
// A controller that breaks the rule that the scenario names, on robot 2 only; "constructors_are_slow" is one
// of all robots.
#include <unistd.h>

#include <caravan/controller.hpp>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <stdexcept>
#include <thread>

namespace {

class Faulty final : public caravan::Controller {
 public:
  Faulty(const caravan::Robot& robot, caravan::Parameters& parameters)
      : fault_{robot.id == 2 ? parameters.text("fault", "none") : "none"},
        at_step_{parameters.integer("at_step", 3, {1, 1e9})} {
    if (parameters.text("fault", "none") == "constructors_are_slow")
      std::this_thread::sleep_for(std::chrono::seconds{3});
    if (fault_ == "constructor") throw std::runtime_error{"no map"};
    if (fault_ == "constructor_hangs") hang();
    if (fault_ == "constructor_aborts") std::abort();
    if (fault_ == "constructor_exits") std::exit(0);
    if (fault_ == "constructor_forks") (void)fork();
  }
  ~Faulty() override {
    if (fault_ == "destructor_hangs") hang();
    if (fault_ == "destructor_aborts") std::abort();
  }
  Faulty(const Faulty&) = delete;
  Faulty& operator=(const Faulty&) = delete;

  caravan::Outputs step(const caravan::Inputs& /*inputs*/) override {
    caravan::Outputs outputs;
    outputs.left_mps = outputs.right_mps = 0.1;
    if (++step_ != at_step_) return outputs;
    if (fault_ == "throws") throw std::out_of_range{"no such cell"};
    if (fault_ == "throws_a_number") throw 42;
    if (fault_ == "nan") outputs.left_mps = std::numeric_limits<double>::quiet_NaN();
    if (fault_ == "exits") std::exit(0);
    if (fault_ == "hangs") hang();
    if (fault_ == "crashes") *const_cast<volatile int*>(nowhere_) = 1;
    if (fault_ == "overflows") outputs.left_mps = endless(1.0);
    return outputs;
  }

 private:
  static void hang() {
    std::fprintf(stderr, "faulty hangs\n");
    std::this_thread::sleep_for(std::chrono::hours{1});
  }
  /// Fills the stack.
  static double endless(double value) {
    volatile double some[512] = {value};  // NOLINT(*-avoid-c-arrays): volatile
    return value < 0.0 ? 0.0 : endless(value + some[0]) + some[1];
  }

  const int* nowhere_ = nullptr;
  std::string fault_;
  std::int64_t at_step_;
  std::int64_t step_ = 0;
};

}  // namespace

CARAVAN_CONTROLLER(Faulty, "faulty")
