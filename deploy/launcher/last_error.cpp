// SPDX-License-Identifier: Apache-2.0
#include "deploy/launcher/last_error.hpp"

#include <algorithm>
#include <fstream>

#include "runtime/pure/one_line.hpp"

namespace caravan::deploy {
namespace {

constexpr std::streamoff kEnd_bytes = 65536;  // a controller may have printed much

/// `<time> error <program>: <message>`, as run_process logs, or what a crash handler writes without a time.
std::string_view message_of(std::string_view line) {
  if (line.starts_with("controller ") && line.find(", robot ") != std::string_view::npos) return line;
  if (line.empty() || line.front() < '0' || line.front() > '9') return {};  // the time comes first
  const std::size_t severity = line.find(' ');
  if (severity == std::string_view::npos) return {};
  const std::string_view rest = line.substr(severity + 1);
  if (!rest.starts_with("error ") && !rest.starts_with("critical ")) return {};
  const std::size_t colon = rest.find(": ");
  return colon == std::string_view::npos ? std::string_view{} : rest.substr(colon + 2);
}

}  // namespace

std::string last_error_in(std::string_view log) {
  std::string_view last;
  while (!log.empty()) {
    const std::size_t end = std::min(log.find('\n'), log.size());
    if (const auto message = message_of(log.substr(0, end)); !message.empty()) last = message;
    log.remove_prefix(std::min(end + 1, log.size()));
  }
  return pure::one_line(std::string{last});
}

std::string last_error_of(const std::filesystem::path& file) {
  std::ifstream in{file, std::ios::binary | std::ios::ate};
  const std::streamoff size = in.tellg();
  if (!in || size <= 0) return "";
  in.seekg(std::max(std::streamoff{0}, size - kEnd_bytes));
  std::string text(static_cast<std::size_t>(std::min(size, kEnd_bytes)), '\0');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  return last_error_in(std::string_view{text}.substr(0, static_cast<std::size_t>(in.gcount())));
}

}  // namespace caravan::deploy
