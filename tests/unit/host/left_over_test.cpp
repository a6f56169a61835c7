// SPDX-License-Identifier: Apache-2.0
// Which files in shared memory are left over.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/mman.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <thread>
#include <utility>
#include <vector>

#include "runtime/bus/shared_memory_port.hpp"
#include "runtime/host/shared_memory.hpp"

namespace caravan::runtime {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::IsEmpty;

constexpr std::uint32_t kDomain = 77;

std::string of_dds(const std::string& rest) { return runtime::shared_memory_mark() + rest; }

/// A folder in place of /dev/shm.
class LeftOver : public testing::Test {
 protected:
  LeftOver() {
    std::string pattern = fs::temp_directory_path() / "caravan_left_XXXXXX";
    folder_ = mkdtemp(pattern.data());
  }
  ~LeftOver() override { fs::remove_all(folder_); }

  fs::path make(const std::string& name, std::chrono::seconds age) const {
    std::ofstream{folder_ / name} << "12345";
    fs::last_write_time(folder_ / name, fs::file_time_type::clock::now() - age);
    return folder_ / name;
  }
  [[nodiscard]] std::vector<std::string> left() const {
    std::vector<std::string> names;
    for (const LeftFile& file : left_by_the_dead(folder_)) names.push_back(file.name);
    return names;
  }
  fs::path folder_;
};

TEST_F(LeftOver, IsWhatIsOldAndOfDds) {
  make(of_dds("0123"), 1h);
  make(of_dds("0123_el"), 1h);
  make(of_dds("port7410"), 1h);
  make("sem." + of_dds("port7410_mutex"), 1h);
  make(of_dds("4567"), 0s);    // of a process that is just starting
  make("somebody_elses", 1h);  // not of DDS
  make("sem.other_mutex", 1h);
  EXPECT_THAT(left(), ElementsAre(of_dds("0123"), of_dds("0123_el"), of_dds("port7410"),
                                  "sem." + of_dds("port7410_mutex")));
  EXPECT_EQ(left_by_the_dead(folder_).front().bytes, 5U);
  EXPECT_EQ(remove_left_by_the_dead(folder_), 4U);
  EXPECT_THAT(left(), IsEmpty());
  EXPECT_TRUE(fs::exists(folder_ / "somebody_elses"));
  EXPECT_TRUE(fs::exists(folder_ / of_dds("4567")));
}

TEST_F(LeftOver, IsNotWhatSomebodyHasMapped) {
  const fs::path file = make(of_dds("0123"), 1h);
  make(of_dds("0123_el"), 1h);
  const int descriptor = open(file.c_str(), O_RDONLY | O_CLOEXEC);
  void* mapped = mmap(nullptr, 5, PROT_READ, MAP_SHARED, descriptor, 0);
  close(descriptor);
  ASSERT_NE(mapped, MAP_FAILED);
  EXPECT_THAT(left(), IsEmpty());
  munmap(mapped, 5);
  EXPECT_THAT(left(), ElementsAre(of_dds("0123"), of_dds("0123_el")));
}

/// A port file that a process has opened and not mapped yet, which lasts longer on a busy machine.
TEST_F(LeftOver, IsNotWhatSomebodyIsAboutToMap) {
  const fs::path opened = make(of_dds("port" + std::to_string(7400 + 250 * kDomain)), 0s);
  const fs::path dead = make(of_dds("port" + std::to_string(7401 + 250 * kDomain)), 0s);
  const fs::path of_another_domain = make(of_dds("port" + std::to_string(7400 + 250 * (kDomain + 1))), 0s);
  const int descriptor = open(opened.c_str(), O_RDONLY | O_CLOEXEC);
  remove_dead_ports(kDomain, folder_);
  EXPECT_TRUE(fs::exists(opened));
  EXPECT_FALSE(fs::exists(dead));
  EXPECT_TRUE(fs::exists(of_another_domain));
  close(descriptor);
  remove_dead_ports(kDomain, folder_);
  EXPECT_FALSE(fs::exists(opened));
}

/// Processes start while a world removes what the dead left.
TEST_F(LeftOver, IsNotWhatAppearsMeanwhile) {
  std::atomic<bool> done{false};
  std::thread remover{[&] {
    while (!done) remove_dead_ports(kDomain, folder_);
  }};
  std::vector<std::pair<fs::path, void*>> ports;
  for (std::uint32_t i = 0; i < 250; ++i) {
    const fs::path port = folder_ / of_dds("port" + std::to_string(7400 + 250 * kDomain + i));
    const int descriptor = open(port.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
    EXPECT_EQ(ftruncate(descriptor, 5), 0);
    ports.emplace_back(port, mmap(nullptr, 5, PROT_READ, MAP_SHARED, descriptor, 0));
    close(descriptor);
  }
  done = true;
  remover.join();
  for (const auto& [port, mapped] : ports) {
    EXPECT_TRUE(fs::exists(port));
    munmap(mapped, 5);
  }
}

TEST_F(LeftOver, IsNotWhatSomebodyUnseenHasLocked) {
  make(of_dds("port7410"), 1h);
  make("sem." + of_dds("port7410_mutex"), 1h);
  const fs::path lock = make(of_dds("port7410_sl"), 1h);
  const int descriptor = open(lock.c_str(), O_RDONLY | O_CLOEXEC);
  ASSERT_EQ(flock(descriptor, LOCK_SH), 0);
  EXPECT_THAT(left(), IsEmpty());
  close(descriptor);
  EXPECT_EQ(left().size(), 3U);
}

}  // namespace
}  // namespace caravan::runtime
