// SPDX-License-Identifier: Apache-2.0
#include "runtime/bus/lost_segments.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <unistd.h>

#include <boost/interprocess/indexes/iset_index.hpp>
#include <boost/interprocess/managed_shared_memory.hpp>
#include <cerrno>
#include <cstdint>
#include <string>

#include "runtime/bus/fastdds_version.hpp"

namespace caravan::runtime {
namespace {

namespace ipc = boost::interprocess;

/// As Fast DDS opens a segment: addresses of 32 bits.
using Segment = ipc::basic_managed_shared_memory<
    char, ipc::rbtree_best_fit<ipc::mutex_family, ipc::offset_ptr<void, std::uint32_t, std::uint64_t>>,
    ipc::iset_index>;

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

TEST(LostSegments, AreSegmentsToTheLibraryThatReadsThem) {
  if (!reads_past_lost_segments()) GTEST_SKIP() << "this version of DDS reads on";
  const Segment segment{ipc::open_only, marked("0123456789abcdef").c_str()};
  ASSERT_NE(segment.get_segment_manager(), nullptr);
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
