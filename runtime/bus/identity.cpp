// SPDX-License-Identifier: Apache-2.0
#include "runtime/bus/identity.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <sstream>
#include <vector>

namespace caravan::runtime {
namespace {

constexpr std::string_view kMark = "caravan";

template <typename Number>
bool parse(const std::string& text, Number& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc{} && end == text.data() + text.size();
}

}  // namespace

Identity own_identity(const std::string& role) {
  std::array<char, 256> host{};
  gethostname(host.data(), host.size() - 1);
  const auto since_epoch = std::chrono::system_clock::now().time_since_epoch();
  return {
      role, host.data(), static_cast<std::uint32_t>(getpid()),
      static_cast<std::uint64_t>(std::chrono::duration_cast<std::chrono::milliseconds>(since_epoch).count())};
}

std::string to_name(const Identity& identity) {
  return std::string{kMark} + "|" + identity.role + "|" + identity.host + "|" + std::to_string(identity.pid) +
         "|" + std::to_string(identity.started_ms);
}

Identity to_identity(const std::string& name) {
  std::vector<std::string> parts;
  std::istringstream stream{name};
  for (std::string part; std::getline(stream, part, '|');) parts.push_back(part);
  Identity identity;
  if (parts.size() == 5 && parts[0] == kMark && parse(parts[3], identity.pid) &&
      parse(parts[4], identity.started_ms)) {
    identity.role = printable(parts[1]);
    identity.host = printable(parts[2]);
    return identity;
  }
  return {printable(name), "", 0, 0};
}

std::string printable(const std::string& text) {
  constexpr std::size_t kLongest = 80;
  std::string fit = text.substr(0, kLongest);
  std::replace_if(
      fit.begin(), fit.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return fit;
}

}  // namespace caravan::runtime
