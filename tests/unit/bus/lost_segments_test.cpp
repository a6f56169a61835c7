// SPDX-License-Identifier: Apache-2.0
#include "runtime/bus/lost_segments.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <string>

#include "runtime/bus/fastdds_version.hpp"

namespace caravan::runtime {
namespace {

std::string marked(const std::string& rest) { return "/" + std::string{kSharedMemoryMark} + rest; }

TEST(LostSegments, OpenAsEmptyOnesWhereDdsReadsNoFurtherWithoutThem) {
  if (!reads_past_lost_segments()) GTEST_SKIP() << "this version of DDS reads on";
  const int memory = shm_open(marked("0123456789abcdef").c_str(), O_RDWR, 0600);
  ASSERT_GE(memory, 0);
  char byte = 1;
  EXPECT_EQ(pread(memory, &byte, 1, 0xffff'ffff), 1);
  EXPECT_EQ(byte, 0);
  close(memory);
}

// Fast DDS opens segments with Boost, which uses the first 16 bytes itself and opens nothing whose remaining
// size needs more than 32 bits.
TEST(LostSegments, AreAsLongAsALibraryWithAddressesOf32BitsTakesThem) {
  if (!reads_past_lost_segments()) GTEST_SKIP() << "this version of DDS reads on";
  const int memory = shm_open(marked("0123456789abcdef").c_str(), O_RDWR, 0600);
  ASSERT_GE(memory, 0);
  struct stat file {};
  ASSERT_EQ(fstat(memory, &file), 0);
  EXPECT_LE(file.st_size - 16, off_t{0xffff'ffff});
  close(memory);
}

TEST(LostSegments, AreNothingElseThatIsNotThere) {
  for (const std::string& name : {marked("port7400"), marked("0123456789abcdef_el"),
                                  marked("0123456789abcdeg"), std::string{"/0123456789abcdef"}}) {
    errno = 0;
    EXPECT_EQ(shm_open(name.c_str(), O_RDWR, 0600), -1) << name;
    EXPECT_EQ(errno, ENOENT) << name;
  }
}

}  // namespace
}  // namespace caravan::runtime
