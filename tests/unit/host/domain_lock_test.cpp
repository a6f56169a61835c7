// SPDX-License-Identifier: Apache-2.0
#include "runtime/host/domain_lock.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdint>
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

/// The message of the refusal of the domain; empty if it was granted.
std::string refusal_of(std::uint32_t domain) {
  try {
    const DomainLock lock{domain};
    return "";
  } catch (const runtime::StartError& error) {
    return error.what();
  }
}

/// The exit code of a child process that runs `work`.
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

/// A child process that holds a free domain until destruction. It has no descendants.
class Holder {
 public:
  Holder() {
    EXPECT_EQ(pipe2(domain_.data(), O_CLOEXEC), 0);
    EXPECT_EQ(pipe2(end_.data(), O_CLOEXEC), 0);
    child_ = fork();
    if (child_ == 0) hold();
    close(end_[0]);
    close(domain_[1]);
    EXPECT_EQ(read(domain_[0], &held_, sizeof held_), static_cast<ssize_t>(sizeof held_));
  }
  ~Holder() {
    close(end_[1]);
    close(domain_[0]);
    EXPECT_EQ(waitpid(child_, nullptr, 0), child_);
  }
  Holder(const Holder&) = delete;
  Holder& operator=(const Holder&) = delete;

  [[nodiscard]] std::uint32_t domain() const { return held_; }

 private:
  [[noreturn]] void hold() {
    close(end_[1]);
    const DomainLock lock{std::nullopt};
    const std::uint32_t domain = lock.domain();
    char none = 0;
    const bool told = write(domain_[1], &domain, sizeof domain) == static_cast<ssize_t>(sizeof domain);
    _exit(told && read(end_[0], &none, 1) == 0 ? 0 : 1);  // 0 bytes: the parent has closed the pipe
  }

  std::array<int, 2> domain_{};
  std::array<int, 2> end_{};
  pid_t child_ = -1;
  std::uint32_t held_ = 0;
};

TEST(DomainLock, MayBeTakenByADescendantOfItsHolder) {
  const DomainLock held{std::nullopt};
  const auto is_refused = [&] { return refusal_of(held.domain()).empty() ? 0 : 1; };
  EXPECT_EQ(in_a_child(is_refused), 0);
  EXPECT_EQ(in_a_child([&] { return in_a_child(is_refused); }), 0);
}

TEST(DomainLock, IsRefusedToTheParentAndTheSiblingsOfItsHolder) {
  const Holder holder;
  const auto is_refused = [&] { return refusal_of(holder.domain()).empty() ? 0 : 1; };
  EXPECT_EQ(is_refused(), 1);
  EXPECT_EQ(in_a_child(is_refused), 1);
}

TEST(DomainLock, CountsWhateverTheFolderOfTemporaryFilesIs) {
  const Holder holder;
  std::string pattern = std::filesystem::temp_directory_path() / "caravan_lock_XXXXXX";
  const std::string elsewhere = mkdtemp(pattern.data());
  for (const std::string& folder : {elsewhere, std::string{"/nowhere"}}) {
    EXPECT_EQ(in_a_child([&] {
                setenv("TMPDIR", folder.c_str(), 1);
                return refusal_of(holder.domain()).empty() ? 0 : 1;
              }),
              1);
    EXPECT_EQ(in_a_child([&] {
                setenv("TMPDIR", folder.c_str(), 1);
                return DomainLock{std::nullopt}.domain() == holder.domain() ? 0 : 1;
              }),
              1);
  }
  std::filesystem::remove(elsewhere);
}

TEST(DomainLock, CountsForAnotherUserToo) {
  if (geteuid() != 0) GTEST_SKIP() << "only root can be somebody else";
  const Holder holder;
  const uid_t root = geteuid();
  EXPECT_EQ(in_a_child([&] {
              if (setuid(65534) != 0) return 9;
              if (DomainLock{std::nullopt}.domain() == holder.domain()) return 2;
              if (other_user_in(holder.domain()) != root) return 3;
              return refusal_of(holder.domain()).find("user root") == std::string::npos ? 4 : 0;
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
  // The traces of a process that has joined the domain by hand: its place and the port of that place.
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
