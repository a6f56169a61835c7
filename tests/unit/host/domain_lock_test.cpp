// SPDX-License-Identifier: Apache-2.0
#include "runtime/host/domain_lock.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "runtime/bus/local_names.hpp"
#include "runtime/bus/shared_memory_port.hpp"
#include "runtime/config/start_error.hpp"
#include "runtime/host/domain_users.hpp"

namespace caravan::runtime {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

/// What the refusal of the domain says; empty: it was given.
std::string refusal_of(std::uint32_t domain) {
  try {
    const DomainLock lock{domain};
    return "";
  } catch (const runtime::StartError& error) {
    return error.what();
  }
}

/// The exit code of a child process that does this.
int in_a_child(const std::function<int()>& work) {
  const pid_t child = fork();
  if (child == 0) _exit(work());
  int status = 0;
  EXPECT_EQ(waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFEXITED(status)) << "signal " << WTERMSIG(status);
  return WEXITSTATUS(status);
}

TEST(DomainLock, OfADomainThatIsHeldIsRefusedNamingWhoHoldsItAndSinceWhen) {
  const DomainLock held{std::nullopt};
  EXPECT_THAT(refusal_of(held.domain()),
              AllOf(HasSubstr("DDS domain " + std::to_string(held.domain())),
                    HasSubstr("pid " + std::to_string(getpid())), HasSubstr("user " + user_text(geteuid())),
                    HasSubstr("since 20")));
}

TEST(DomainLock, IsFreeAgainWhenItsHolderHasGone) {
  std::uint32_t domain = 0;
  {
    const DomainLock held{std::nullopt};
    domain = held.domain();
  }
  EXPECT_EQ(holder_of(domain), std::nullopt);
  EXPECT_EQ(refusal_of(domain), "");
}

TEST(DomainLock, MayBeTakenByAChildOfItsHolderAndByNobodyFurtherAway) {
  const DomainLock held{std::nullopt};
  const auto is_refused = [&] { return refusal_of(held.domain()).empty() ? 0 : 1; };
  EXPECT_EQ(in_a_child(is_refused), 0);
  EXPECT_EQ(in_a_child([&] { return in_a_child(is_refused); }), 1);
}

TEST(DomainLock, CountsWhateverTheFolderOfTemporaryFilesIs) {
  const DomainLock held{std::nullopt};
  std::string pattern = std::filesystem::temp_directory_path() / "caravan_lock_XXXXXX";
  const std::string elsewhere = mkdtemp(pattern.data());
  for (const std::string& folder : {elsewhere, std::string{"/nowhere"}}) {
    EXPECT_EQ(in_a_child([&] {
                setenv("TMPDIR", folder.c_str(), 1);
                return in_a_child([&] { return refusal_of(held.domain()).empty() ? 0 : 1; });
              }),
              1);
    EXPECT_EQ(in_a_child([&] {
                setenv("TMPDIR", folder.c_str(), 1);
                return DomainLock{std::nullopt}.domain() == held.domain() ? 0 : 1;
              }),
              1);
  }
  std::filesystem::remove(elsewhere);
}

TEST(DomainLock, CountsForAnotherUserToo) {
  if (geteuid() != 0) GTEST_SKIP() << "only root can be somebody else";
  const DomainLock held{std::nullopt};
  const uid_t root = geteuid();
  EXPECT_EQ(in_a_child([&] {
              if (setuid(65534) != 0) return 9;
              if (DomainLock{std::nullopt}.domain() == held.domain()) return 2;
              if (other_user_in(held.domain()) != root) return 3;
              return in_a_child(
                  [&] { return refusal_of(held.domain()).find("user root") == std::string::npos ? 4 : 0; });
            }),
            0);
}

TEST(DomainLock, OfADomainInWhichAnotherUsersProcessesAreIsRefused) {
  if (geteuid() != 0) GTEST_SKIP() << "only root can be somebody else";
  std::uint32_t domain = 0;
  {
    const DomainLock free{std::nullopt};
    domain = free.domain();
  }
  // As a process looks that has joined the domain by hand: its place and the port behind it.
  const std::uint32_t port = 1'000'000 * (domain + 1) + 7;
  const int place =
      runtime::hold_local_name("caravan/" + std::to_string(domain) + "/" + std::to_string(port));
  const std::filesystem::path file = runtime::port_file(port);
  close(open(file.c_str(), O_CREAT | O_WRONLY, 0644));
  ASSERT_EQ(chown(file.c_str(), 65534, 65534), 0);
  EXPECT_THAT(refusal_of(domain), HasSubstr("another user"));
  EXPECT_NE(DomainLock{std::nullopt}.domain(), domain);
  close(place);
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace caravan::runtime
