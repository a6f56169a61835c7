// SPDX-License-Identifier: Apache-2.0
// The findings of the doctor for made-up hosts.
#include "deploy/doctor/findings.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace caravan::deploy {
namespace {

using Severity = Finding::Severity;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/// A host without any defect, for a run over shared memory and the network.
HostFacts healthy() {
  HostFacts facts;
  facts.robots = 15;
  facts.domain = 7;
  facts.reach.shared_memory = true;
  facts.reach.network = true;
  facts.dds_built = facts.dds_loaded = "2.9.1";
  facts.shared_memory_free_bytes = 1ULL << 30;
  facts.udp_ports_in_use = {53, 5353};
  facts.ephemeral_first = 32768;
  facts.ephemeral_last = 60999;
  facts.addresses = {"127.0.0.1", "192.0.2.1"};
  facts.clock_s = 1'790'000'000;
  facts.open_files = 20'000;
  facts.threads = 90'000;
  facts.socket_receive_bytes = facts.socket_send_bytes = 4 << 20;
  return facts;
}

Finding about(const std::string& subject, const HostFacts& facts) {
  for (const Finding& finding : examine(facts)) {
    if (finding.subject == subject) return finding;
  }
  ADD_FAILURE() << "nothing about " << subject;
  return {};
}

/// Expects the finding on `subject` to have this severity and advice, and all others to be good.
Finding only_complaint(const HostFacts& facts, const std::string& subject, Severity severity) {
  Finding found;
  for (const Finding& finding : examine(facts)) {
    if (finding.subject == subject) found = finding;
    EXPECT_EQ(finding.severity, finding.subject == subject ? severity : Severity::kGood)
        << finding.subject << ": " << finding.seen;
  }
  EXPECT_THAT(found.advice, Not(IsEmpty())) << subject;
  return found;
}

TEST(Doctor, HasNothingAgainstAHealthyHost) {
  for (const Finding& finding : examine(healthy())) {
    EXPECT_EQ(finding.severity, Severity::kGood) << finding.subject << ": " << finding.seen;
    EXPECT_THAT(finding.advice, IsEmpty()) << finding.subject;
    EXPECT_THAT(finding.seen, Not(IsEmpty())) << finding.subject;
  }
}

TEST(Doctor, NamesMissingPrograms) {
  HostFacts facts = healthy();
  facts.missing_programs = {"radio_emulator", "robot_agent"};
  EXPECT_THAT(only_complaint(facts, "programs", Severity::kProblem).seen,
              HasSubstr("radio_emulator, robot_agent"));
}

TEST(Doctor, ComparesTheLibraryWithTheOneThatWasBuiltWith) {
  HostFacts facts = healthy();
  facts.dds_loaded = "2.10.0";
  EXPECT_THAT(only_complaint(facts, "Fast DDS", Severity::kProblem).seen, HasSubstr("2.10.0"));
  facts.dds_loaded = "2.9.2";
  EXPECT_THAT(only_complaint(facts, "Fast DDS", Severity::kWarning).seen, HasSubstr("2.9.2"));
  facts.dds_loaded = "";
  EXPECT_THAT(only_complaint(facts, "Fast DDS", Severity::kWarning).seen, HasSubstr("unknown"));
}

TEST(Doctor, WantsSharedMemoryThatCanBeWrittenAndHasRoomForTheRobots) {
  HostFacts facts = healthy();
  facts.shared_memory_writable = false;
  EXPECT_THAT(only_complaint(facts, "shared memory", Severity::kProblem).advice, HasSubstr("--ipc=host"));
  facts = healthy();
  facts.shared_memory_free_bytes = 64ULL << 20;  // the default of a container
  EXPECT_EQ(about("shared memory", facts).severity, Severity::kGood) << "15 robots";
  facts.robots = 100;
  EXPECT_THAT(only_complaint(facts, "shared memory", Severity::kProblem).seen, HasSubstr("100 robots"));
}

TEST(Doctor, AsksNothingOfSharedMemoryThatIsNotUsed) {
  HostFacts facts = healthy();
  facts.reach.shared_memory = false;
  facts.shared_memory_writable = false;
  facts.shared_memory_free_bytes = 0;
  EXPECT_EQ(about("shared memory", facts).severity, Severity::kGood);
}

TEST(Doctor, TellsWhatTheDeadHaveLeft) {
  HostFacts facts = healthy();
  facts.left_files = 876;
  facts.left_bytes = 220ULL << 20;
  const Finding finding = only_complaint(facts, "left over", Severity::kWarning);
  EXPECT_THAT(finding.seen, HasSubstr("876 files, 220 MB"));
  EXPECT_THAT(finding.advice, HasSubstr("--clean"));
}

TEST(Doctor, SeesThatTheDomainIsInUse) {
  HostFacts facts = healthy();
  facts.domain_in_use = true;
  (void)only_complaint(facts, "domain 7", Severity::kWarning);
  facts.domain_in_use = false;
  facts.udp_ports_in_use = {7400 + 250 * 7 + 249};
  (void)only_complaint(facts, "domain 7", Severity::kWarning);
  facts.udp_ports_in_use = {7400 + 250 * 7 - 1, 7400 + 250 * 8};  // ports of neighbouring domains
  EXPECT_EQ(about("domain 7", facts).severity, Severity::kGood);
}

TEST(Doctor, WarnsOfDomainsWhosePortsTheKernelGivesToOthers) {
  HostFacts facts = healthy();
  facts.domain = 120;
  EXPECT_THAT(only_complaint(facts, "domain 120", Severity::kWarning).advice, HasSubstr("below 101"));
  facts.reach.network = false;  // these ports matter only to UDP
  EXPECT_EQ(about("domain 120", facts).severity, Severity::kGood);
  facts.reach.network = true;
  facts.domain = 100;
  EXPECT_EQ(about("domain 100", facts).severity, Severity::kGood) << "32400 to 32649";
}

TEST(Doctor, WantsTheAddressesOfTheProfileOnThisHost) {
  HostFacts facts = healthy();
  facts.reach.interfaces = {"192.0.2.1"};
  EXPECT_EQ(about("interfaces", facts).severity, Severity::kGood);
  facts.reach.interfaces = {"192.0.2.1", "192.0.2.9"};
  const Finding finding = only_complaint(facts, "interfaces", Severity::kProblem);
  EXPECT_THAT(finding.seen, testing::EndsWith(": 192.0.2.9"));
  EXPECT_THAT(finding.advice, HasSubstr("127.0.0.1, 192.0.2.1"));
}

TEST(Doctor, MissesADiscoveryServerThatShouldRunHere) {
  HostFacts facts = healthy();
  facts.reach.servers = {{"192.0.2.1", 11811}};
  facts.server_profile = "/here/server.xml";
  EXPECT_EQ(only_complaint(facts, "discovery", Severity::kProblem).advice,
            "fast-discovery-server -i 0 -l 192.0.2.1 -p 11811 -x /here/server.xml");
  facts.udp_ports_in_use = {53, 11811};
  EXPECT_EQ(about("discovery", facts).severity, Severity::kGood);
  facts.udp_ports_in_use = {};
  facts.reach.servers = {{"192.0.2.77", 11811}};
  EXPECT_EQ(about("discovery", facts).severity, Severity::kGood)
      << "another host's: cannot be seen from here";
}

TEST(Doctor, LooksAtTheClock) {
  HostFacts facts = healthy();
  facts.clock_synchronised = false;
  (void)only_complaint(facts, "clock", Severity::kWarning);
  facts.clock_s = 1000;
  (void)only_complaint(facts, "clock", Severity::kProblem);
}

TEST(Doctor, WantsRoomForFilesAndThreads) {
  HostFacts facts = healthy();
  facts.open_files = 1023;
  (void)only_complaint(facts, "open files", Severity::kWarning);
  facts.open_files = 255;
  EXPECT_THAT(only_complaint(facts, "open files", Severity::kProblem).advice, HasSubstr("ulimit -n 1024"));
  facts = healthy();
  facts.threads = 200;
  EXPECT_THAT(only_complaint(facts, "threads", Severity::kProblem).seen, HasSubstr("200, 15 robots need"));
}

TEST(Doctor, WantsSocketBuffersForTheNetworkOnly) {
  HostFacts facts = healthy();
  facts.socket_receive_bytes = 212'992;
  EXPECT_THAT(only_complaint(facts, "socket buffers", Severity::kWarning).advice,
              HasSubstr("net.core.rmem_max="));
  facts.reach.network = false;
  EXPECT_EQ(about("socket buffers", facts).severity, Severity::kGood);
}

}  // namespace
}  // namespace caravan::deploy
