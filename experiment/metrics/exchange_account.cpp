// SPDX-License-Identifier: Apache-2.0
#include "experiment/metrics/exchange_account.hpp"

#include <algorithm>

namespace caravan::experiment {
namespace {

constexpr Time kSameSession = std::chrono::seconds{60};

}  // namespace

void ExchangeAccount::add(std::uint32_t robot, const Exchange& exchange) {
  ++reports_;
  stood_ns_ += static_cast<double>((exchange.ended - exchange.began).count());
  if (exchange.session == 0) {
    ++(exchange.completed ? completed_ : failed_);
    return;
  }
  const auto [low, high] = std::minmax(robot, exchange.partner);
  const auto [known, is_new] =
      sessions_.try_emplace({low, high, exchange.session}, Session{exchange.began, exchange.completed});
  Session& session = known->second;
  if (is_new || std::chrono::abs(exchange.began - session.began) > kSameSession) {
    session = {exchange.began, exchange.completed};
    ++(exchange.completed ? completed_ : failed_);
  } else if (exchange.completed && !session.completed) {
    session.completed = true;
    --failed_;
    ++completed_;
  }
}

double ExchangeAccount::mean_duration_s() const {
  return reports_ == 0 ? 0.0 : stood_ns_ / 1e9 / static_cast<double>(reports_);
}

}  // namespace caravan::experiment
