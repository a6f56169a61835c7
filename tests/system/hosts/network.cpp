// SPDX-License-Identifier: Apache-2.0
#include "tests/system/hosts/network.hpp"

#include <gtest/gtest.h>

#include "build_paths.hpp"

namespace caravan::test {

using namespace std::chrono_literals;

namespace {

/// The command with a PATH that includes the folders of root's commands.
std::vector<std::string> command(std::vector<std::string> words) {
  words.insert(words.begin(), {"/usr/bin/env", "PATH=/usr/sbin:/usr/bin:/sbin:/bin"});
  return words;
}

void append(std::vector<std::string>& words, const std::vector<std::string>& more) {
  words.insert(words.end(), more.begin(), more.end());
}

}  // namespace

Network::Network(std::size_t hosts, std::filesystem::path logs) : logs_{std::move(logs)} {
  const std::string bridge = "ip link set lo up && ip link add bridge type bridge && ip link set bridge up";
  middle_ = hold({"unshare", "--net"}, bridge, "bridge");
  if (!middle_) {
    as_user_ = true;
    middle_ = hold({"unshare", "--user", "--map-root-user", "--net"}, bridge, "bridge");
  }
  if (!middle_) return;
  refusal_.clear();
  make_hosts(hosts);
}

void Network::make_hosts(std::size_t hosts) {
  for (std::size_t host = 1; host <= hosts && refusal_.empty(); ++host) {
    const std::string number = std::to_string(host);
    Words before = inside(*middle_, {"--net"});
    append(before, {"unshare", "--net", "--mount", "--uts"});
    hosts_.push_back(hold(before,
                          "hostname host" + number + " && mount -t tmpfs tmpfs /dev/shm && ip link set lo up",
                          "host" + number));
    if (!hosts_.back()) return;
    const std::string bridge_end = "to_" + number;
    Words wire = inside(*middle_, {"--net"});
    append(wire,
           {"sh", "-ec",
            "ip link add " + bridge_end + " type veth peer name eth0 netns " +
                std::to_string(hosts_.back()->pid()) + "; ip link set " + bridge_end + " master bridge up"});
    Words address_it = inside(*hosts_.back(), {"--net"});
    append(address_it,
           {"sh", "-ec", "ip address add " + address(host) + "/24 dev eth0; ip link set eth0 up"});
    if (!run(wire) || !run(address_it) || !waits_for_link(host)) return;
  }
}

bool Network::waits_for_link(std::size_t host) {
  // The kernel reports a link as running a while after both ends are up. DDS uses only the interfaces that
  // are running when a process starts: one that starts before is never found from another host.
  Words look = inside(*hosts_[host - 1], {"--net"});
  append(look, {"sh", "-c", "ip -o link show eth0 | grep -q 'state UP'"});
  if (eventually([&] { return run(look); }, kPatience)) {
    refusal_.clear();
    return true;
  }
  refusal_ = "the link of host " + std::to_string(host) + " does not come up";
  return false;
}

std::unique_ptr<PatientProcess> Network::hold(const Words& before, const std::string& set_up,
                                              const std::string& log) {
  Words words = command(before);
  append(words, {"sh", "-c", "(" + set_up + ") && echo ready && exec sleep infinity"});
  auto holder = std::make_unique<PatientProcess>(words, logs_ / (log + ".log"));
  (void)eventually([&] { return holder->wait(0ms) || holder->prints("ready\n", 0ms); }, kPatience);
  if (holder->prints("ready\n", 0ms)) return holder;
  refusal_ = holder->output();
  if (refusal_.empty()) refusal_ = before.front() + " did not say why";
  return nullptr;
}

Network::Words Network::inside(const PatientProcess& holder, const Words& namespaces) const {
  Words words{"nsenter", "--target", std::to_string(holder.pid())};
  if (as_user_) append(words, {"--user", "--preserve-credentials"});
  append(words, namespaces);
  words.emplace_back("--");
  return words;
}

bool Network::run(Words words) {
  PatientProcess process{command(std::move(words)), logs_ / "network.log"};
  if (process.wait(kPatience) == 0) return true;
  refusal_ = process.output();
  return false;
}

std::unique_ptr<PatientProcess> Network::start(std::size_t host, std::vector<std::string> arguments,
                                               const std::string& log) {
  if (arguments[0].find('/') == std::string::npos) {
    arguments[0] = std::string{CARAVAN_BIN_DIR} + "/" + arguments[0];
  }
  Words words = inside(*hosts_[host - 1], {"--net", "--mount", "--uts"});
  append(words, arguments);
  return std::make_unique<PatientProcess>(command(std::move(words)), logs_ / (log + ".log"));
}

void Network::cut(std::size_t host) {
  Words words = inside(*middle_, {"--net"});
  append(words, {"ip", "link", "set", "to_" + std::to_string(host), "down"});
  EXPECT_TRUE(run(words)) << refusal_;
}

void Network::heal(std::size_t host) {
  Words words = inside(*middle_, {"--net"});
  append(words, {"ip", "link", "set", "to_" + std::to_string(host), "up"});
  EXPECT_TRUE(run(words)) << refusal_;
}

}  // namespace caravan::test
