// SPDX-License-Identifier: Apache-2.0
// The table of topics in docs/protocol.md equals that in idl/topics.hpp.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "build_paths.hpp"
#include "idl/topics.hpp"

namespace caravan {
namespace {

using testing::HasSubstr;

std::string to_text(idl::Delivery delivery) {
  switch (delivery) {
    case idl::Delivery::kStep:
      return "step";
    case idl::Delivery::kObserved:
      return "observed";
    case idl::Delivery::kHealth:
      return "health";
    case idl::Delivery::kRequest:
      return "request";
    case idl::Delivery::kLatest:
      return "latest";
  }
  return "";
}

std::string to_text(idl::Party party) {
  switch (party) {
    case idl::Party::kWorld:
      return "world";
    case idl::Party::kRadio:
      return "radio";
    case idl::Party::kAgent:
      return "agent";
    case idl::Party::kObserver:
      return "observer";
    case idl::Party::kBridge:
      return "bridge";
    case idl::Party::kEmulatedRobot:
      return "emulated robot";
  }
  return "";
}

/// The last part of the name of a type, without the trailing underscore that it has on the wire.
std::string short_name(std::string_view type) {
  const std::size_t colon = type.rfind(':');
  return std::string{type.substr(colon + 1, type.size() - colon - 2)};
}

/// The cells of the row of each topic: type, delivery, writer, reader.
std::map<std::string, std::vector<std::string>> documented() {
  std::ifstream page{CARAVAN_SOURCE_DIR "/docs/protocol.md"};
  std::map<std::string, std::vector<std::string>> rows;
  for (std::string line; std::getline(page, line);) {
    if (!line.starts_with("| `rt/")) continue;
    std::vector<std::string> cells;
    for (std::size_t at = 1; at < line.size();) {
      const std::size_t end = line.find('|', at);
      cells.push_back(line.substr(at + 1, end - at - 2));
      at = end + 1;
    }
    const std::string name = cells.front().substr(1, cells.front().size() - 2);
    rows[name] = {cells.begin() + 1, cells.end()};
  }
  return rows;
}

TEST(Topics, AreDocumentedAsTheyAre) {
  const auto rows = documented();

  EXPECT_EQ(rows.size(), idl::kTopics.size());
  for (const idl::Topic& topic : idl::kTopics) {
    SCOPED_TRACE(std::string{topic.name});
    const auto row = rows.find(std::string{topic.name});
    ASSERT_NE(row, rows.end());
    ASSERT_EQ(row->second.size(), 4U);
    EXPECT_THAT(row->second[0], HasSubstr(short_name(topic.type)));
    EXPECT_EQ(row->second[1], to_text(topic.delivery));
    for (const idl::Party writer : topic.writers) EXPECT_THAT(row->second[2], HasSubstr(to_text(writer)));
    for (const idl::Party reader : topic.readers) EXPECT_THAT(row->second[3], HasSubstr(to_text(reader)));
  }
}

TEST(Topics, HaveNamesOfTheirOwn) {
  std::set<std::string> names;
  for (const idl::Topic& topic : idl::kTopics) names.insert(idl::name_for(topic, 7));

  EXPECT_EQ(names.size(), idl::kTopics.size());
  EXPECT_TRUE(names.contains("rt/robot_7/radio/tx"));
}

}  // namespace
}  // namespace caravan
