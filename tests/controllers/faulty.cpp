// SPDX-License-Identifier: Apache-2.0
// A controller that breaks the rule that the scenario names, on robot 2 only; "constructors_are_slow" is one
// of all robots.
#include <unistd.h>

#include <caravan/controller.hpp>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <limits>
#include <stdexcept>
#include <thread>

namespace {

class Faulty final : public caravan::Controller {
 public:
  Faulty(const caravan::Robot& robot, caravan::Parameters& parameters)
      : fault_{robot.id == 2 ? parameters.text("fault", "none") : "none"},
        at_step_{parameters.integer("at_step", 3, {1, 1e9})} {
    if (fault_ == "default") (void)parameters.number("gain", 3.0, {0.0, 2.0});
    if (parameters.text("fault", "none") == "constructors_are_slow")
      std::this_thread::sleep_for(std::chrono::seconds{3});
    if (fault_ == "constructor") throw std::runtime_error{"no map"};
    if (fault_ == "constructor_throws_no_text") throw NoText{};
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
    if (fault_ == "event") outputs.report.emplace().events.push_back({"Hello\nworld", ""});
    if (fault_ == "detail") outputs.report.emplace().events.push_back({"said", "a\nb"});
    if (fault_ == "long_frame")
      outputs.frames = {{0, std::vector<std::uint8_t>(5000)}, {0, std::vector<std::uint8_t>(5001)}};
    if (fault_ == "bad_channel") outputs.frames = {{0xffffffff, {1}}};
    if (fault_ == "bad_tuned") outputs.tuned_channel = 0xffffffff;
    if (fault_ == "throws_no_text") throw NoText{};
    if (fault_ == "nan") outputs.left_mps = std::numeric_limits<double>::quiet_NaN();
    if (fault_ == "exits") std::exit(0);
    if (fault_ == "hangs") hang();
    if (fault_ == "crashes") *const_cast<volatile int*>(nowhere_) = 1;
    if (fault_ == "overflows") outputs.left_mps = endless(1.0);
    if (fault_ == "frames") outputs.frames.resize(1001);
    if (fault_ == "frame_bytes") outputs.frames.push_back({0, std::vector<std::uint8_t>(2U << 20U)});
    if (fault_.starts_with("report_")) outputs.report = report(fault_.substr(7));
    return outputs;
  }

 private:
  struct NoText : std::exception {
    [[nodiscard]] const char* what() const noexcept override { return nullptr; }
  };

  static caravan::Report report(const std::string& fault) {
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    caravan::Report report;
    if (fault == "mode") report.mode = static_cast<caravan::Mode>(99);
    if (fault == "activity") report.activity = static_cast<caravan::Activity>(99);
    if (fault == "origin") report.origin = static_cast<caravan::Origin>(99);
    if (fault == "nan") report.path = {{1.0, 2.0}, {1.0, kNan}};
    if (fault == "far") report.path = {{1.0, 2.0}, {1e12, 1.0}};
    if (fault == "long_path") report.path.emplace(65536);
    if (fault == "exchanges") report.exchanges.resize(101);
    if (fault == "exchange_early") report.exchanges.push_back({.partner = 1, .began = caravan::Time{-5}});
    if (fault == "exchange_late") report.exchanges.push_back({.partner = 1, .ended = caravan::Time::max()});
    if (fault == "events") report.events.resize(101, {"turned", ""});
    if (fault == "long_event") report.events.push_back({"turned", std::string(5000, 'x')});
    if (fault == "long_escaped_event") report.events.push_back({"turned", std::string(3000, '\n')});
    if (fault == "event_bytes") report.events.push_back({"turned", "by=\xff"});
    if (fault == "event_nul") report.events.push_back({"turned", std::string(1, '\0')});
    if (fault == "most") {
      report.path.emplace(65535, caravan::Position{1e6, -1e6});
      report.exchanges.resize(100);
      report.events.resize(100, {"turned", "\u20ac" + std::string(4087, 'x')});
    }
    return report;
  }
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
