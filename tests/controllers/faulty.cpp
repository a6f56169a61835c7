// SPDX-License-Identifier: Apache-2.0
// A controller that breaks the rule that the scenario names, on robot 2 only.
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
    (void)parameters.text("fault", "none");
    if (fault_ == "default") (void)parameters.number("gain", 3.0, {0.0, 2.0});
    if (fault_ == "constructor") throw std::runtime_error{"no map"};
    if (fault_ == "constructor_hangs") hang();
    if (fault_ == "constructor_aborts") std::abort();
    if (fault_ == "constructor_exits") std::exit(0);
  }

  caravan::Outputs step(const caravan::Inputs& /*inputs*/) override {
    caravan::Outputs outputs;
    outputs.left_mps = outputs.right_mps = 0.1;
    if (++step_ != at_step_) return outputs;
    if (fault_ == "throws") throw std::out_of_range{"no such cell"};
    if (fault_ == "throws_a_number") throw 42;
    if (fault_ == "event") outputs.report.emplace().events.push_back({"Hello\nworld", ""});
    if (fault_ == "detail") outputs.report.emplace().events.push_back({"said", "a\nb"});
    if (fault_ == "long_frame")
      outputs.frames = {{0, std::vector<std::uint8_t>(5000)}, {0, std::vector<std::uint8_t>(5001)}};
    if (fault_ == "bad_channel") outputs.frames = {{0xffffffff, {1}}};
    if (fault_ == "bad_tuned") outputs.tuned_channel = 0xffffffff;
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
