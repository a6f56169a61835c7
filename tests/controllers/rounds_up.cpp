// SPDX-License-Identifier: Apache-2.0
// A controller that rounds upwards from where the scenario says on, and as soon as it is loaded.
#include <caravan/controller.hpp>
#include <cfenv>

namespace {

[[maybe_unused]] const int when_loaded = std::fesetround(FE_UPWARD);

class RoundsUp final : public caravan::Controller {
 public:
  RoundsUp(const caravan::Robot& /*robot*/, caravan::Parameters& parameters)
      : in_steps_{parameters.flag("in_steps", true)} {
    if (parameters.flag("in_constructor", true)) std::fesetround(FE_UPWARD);
  }

  caravan::Outputs step(const caravan::Inputs& /*inputs*/) override {
    if (in_steps_) std::fesetround(FE_UPWARD);
    caravan::Outputs outputs;
    outputs.left_mps = 0.125;
    outputs.right_mps = 0.25;
    return outputs;
  }

 private:
  bool in_steps_;
};

}  // namespace

CARAVAN_CONTROLLER(RoundsUp, "rounds_up")
