// SPDX-License-Identifier: Apache-2.0
#include "hardware_bridge/shell/modem_shell.hpp"

#include <spdlog/spdlog.h>
#include <unistd.h>

#include <array>
#include <limits>
#include <utility>

#include "runtime/config/start_error.hpp"
#include "runtime/process/run_process.hpp"
#include "runtime/pure/random.hpp"

namespace caravan::bridge {
namespace msg = caravan_interfaces::msg;
using runtime::Discovery;
using runtime::Polled;
using runtime::Sender;
using runtime::Tenure;
using namespace std::chrono_literals;

namespace {

/// Differs between processes, so that a modem recognises its own echo.
std::uint32_t own_number(std::uint32_t robot) {
  return static_cast<std::uint32_t>(pure::mix_all(robot, static_cast<std::uint64_t>(getpid())));
}

}  // namespace

ModemShell::ModemShell(const modem::RadioLimits& limits, std::uint32_t robot, const ModemAddress& address,
                       const runtime::BusConfig& bus, runtime::Loop& loop)
    : address_{address},
      loop_{loop},
      began_{std::chrono::steady_clock::now()},
      number_{robot},
      own_{own_number(robot)},
      radio_{limits},
      bus_{bus, [this](const Discovery& news) { mailbox_.post(news); }},
      sole_{bus_, bus.lease_s, idl::kRadioReceive, robot} {
  if (address.serial) claim_.emplace(canonical(*address.serial), "--modem");
  if (!address.serial) air_.emplace(address.udp_port);
  receives_ = bus_.writer<msg::RadioReceivePubSubType>(idl::kRadioReceive, robot);
  bus_.reader<msg::RadioTransmitPubSubType>(idl::kRadioTransmit, robot,
                                            [this](const msg::RadioTransmit& sample, const Sender& sender) {
                                              mailbox_.post(Transmission{sender, sample});
                                            });
  spdlog::info("robot={} modem ready: mtu={} channels={}", robot, limits.mtu_bytes, limits.channel_count);
}

ModemShell::~ModemShell() { bus_.close(); }

void ModemShell::read_mailbox() {
  for (const Mail& mail : mailbox_.take()) {
    std::visit([this](const auto& one) { read(one); }, mail);
  }
}

void ModemShell::read(const Discovery& news) {
  sole_.see(news, false);  // the agent sends to every modem
  const bool has_left =
      news.kind == Discovery::Kind::kGone || (news.kind == Discovery::Kind::kWriterGone &&
                                              news.topic == idl::name_for(idl::kRadioTransmit, number_));
  if (!has_left || !agent_.release(news.participant)) return;
  session_ = 0;  // the next agent's session may have any number
  for (const Tenure::Later& take_kept : agent_.hand_over()) take_kept();
  if (const auto holder = agent_.holder()) bus_.forgive(*holder);
}

void ModemShell::read(const Transmission& transmission) {
  if (sole_.must_be_silent()) return;
  const msg::RadioTransmit& sample = transmission.sample;
  if (agent_.claim(transmission.from) == Tenure::Standing::kRefused) {
    bus_.refuse(transmission.from, idl::kRadioTransmit, number_);
    agent_.keep(transmission.from, [this, sample] { take(sample); });
  } else if (sample.session() >= session_) {
    take(sample);
  }
}

void ModemShell::take(const msg::RadioTransmit& sample) {
  session_ = sample.session();
  stamp_ = sample.stamp();
  for (const msg::RadioFrame& frame : sample.frames()) radio_.send({frame.channel(), frame.bytes()}, now());
  radio_.tune(sample.tuned_channel(), now());
  tell_drops();
}

void ModemShell::tell_drops() {
  const std::uint64_t drops = radio_.over_mtu() + radio_.bad_channel() + radio_.queue_full();
  if (drops == 0 || drops < 2 * told_drops_) return;
  told_drops_ = drops;
  spdlog::warn("frames refused: {} over the MTU, {} on invalid channels, {} without room in the queue",
               radio_.over_mtu(), radio_.bad_channel(), radio_.queue_full());
}

void ModemShell::keep_line_open() {
  if (!address_.serial || line_.is_open() || now() < retry_.due()) return;
  retry_.tries(now());
  const std::string wrong = line_.open(*address_.serial, address_.baud);
  if (wrong.empty()) was_open_ = true;
  if (!line_.unfit().empty() && !was_open_)
    throw runtime::StartError{"modem " + to_text(address_.serial->address) + ": " + line_.unfit()};
  if (!wrong.empty()) tell_gone(wrong);
}

void ModemShell::tell_gone(const std::string& why) {
  const std::string text = "modem " + to_text(address_.serial->address) + ": " + why + ", trying again";
  if (limit_.pass({Notice::Weight::kWarning, text}, now())) spdlog::warn("{}", text);
  for (const Notice& notice : limit_.take_due(now())) spdlog::warn("{}", notice.text);
}

int ModemShell::run() {
  for (;;) {
    keep_line_open();
    transmit();
    std::array<Polled, 2> watched{air_ ? air_->watched() : Polled{}, line_.watched()};
    if (loop_.wait(next_deadline(), watched) == runtime::Loop::Woken::kStop) return runtime::kDone;
    read_mailbox();
    if (const std::string lost = sole_.lost(); !lost.empty()) throw runtime::StartError{lost};
    while (air_ && watched[0].ready) {
      const auto datagram = air_->receive();
      if (!datagram) break;
      hear(*datagram);
    }
    if (address_.serial) attend_serial(watched[1].ready);
  }
}

std::optional<runtime::WallTime> ModemShell::next_deadline() const {
  std::optional<runtime::WallTime> next = sole_.next_deadline();
  const auto consider = [&next](std::optional<runtime::WallTime> due) {
    if (due && (!next || *due < *next)) next = due;
  };
  if (const auto due = radio_.next_deadline()) consider(began_ + *due);
  if (address_.serial && !line_.is_open()) consider(began_ + retry_.due());
  consider(line_.next_deadline());
  return next;
}

void ModemShell::transmit() {
  while (auto frame = radio_.next(now())) {
    const Bytes packet = modem::encode({own_, frame->channel, std::move(frame->bytes)});
    if (air_) air_->send(packet);
    if (line_.is_up()) line_.write(modem::to_slip(packet));
  }
}

void ModemShell::attend_serial(bool ready) {
  if (!line_.is_open()) return;
  if (ready) {
    for (const Bytes& packet : slip_.feed(line_.attend())) hear(packet);
  }
  line_.expire(std::chrono::steady_clock::now());
  if (line_.is_up()) retry_.up(now());
  if (line_.is_open()) return;
  retry_.down(now(), line_.is_closed_by_other_end());
  tell_gone(line_.failure());
}

void ModemShell::hear(const Bytes& bytes) {
  auto packet = modem::decode(bytes);
  if (!packet || packet->from == own_ || session_ == 0 || sole_.must_be_silent() ||
      !radio_.hears(packet->channel, now()))
    return;
  msg::RadioReceive sample;
  sample.stamp(stamp_);
  sample.session(session_);
  msg::ReceivedFrame frame;
  frame.channel(packet->channel);
  frame.bytes(std::move(packet->payload));
  frame.signal_strength_dbm(std::numeric_limits<double>::quiet_NaN());
  sample.frames().push_back(std::move(frame));
  if (!receives_.write(sample)) spdlog::error("DDS refused a sample: the agent misses a frame");
}

}  // namespace caravan::bridge
