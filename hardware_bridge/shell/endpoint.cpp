// SPDX-License-Identifier: Apache-2.0
#include "hardware_bridge/shell/endpoint.hpp"

#include <arpa/inet.h>
#include <netdb.h>
#include <spdlog/spdlog.h>
#include <sys/socket.h>

#include <array>
#include <charconv>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <future>
#include <memory>
#include <thread>

#include "runtime/config/start_error.hpp"

namespace caravan::bridge {
namespace {

constexpr std::chrono::seconds kNameServicePatience{5};

struct Answer {
  int error = EAI_FAIL;
  sockaddr_in place{};
};

Answer ask(const PortAddress& address, int flags) {
  addrinfo hints{};
  hints.ai_family = AF_INET;
  hints.ai_socktype = SOCK_STREAM;
  hints.ai_flags = flags;
  addrinfo* found = nullptr;
  Answer answer;
  answer.error = getaddrinfo(address.host.c_str(), address.port.c_str(), &hints, &found);
  if (answer.error != 0) return answer;
  std::memcpy(&answer.place, found->ai_addr, sizeof answer.place);
  freeaddrinfo(found);
  return answer;
}

/// Limits the wait for the resolver, which cannot be interrupted: it runs in a thread that is abandoned when
/// it takes too long.
Answer ask_name_service(const PortAddress& address, const std::string& option) {
  spdlog::info("{}: looking up host {}", option, address.host);
  const auto promise = std::make_shared<std::promise<Answer>>();
  auto answer = promise->get_future();
  std::thread{[promise, address] { promise->set_value(ask(address, 0)); }}.detach();
  if (answer.wait_for(kNameServicePatience) == std::future_status::ready) return answer.get();
  throw runtime::StartError{option + ": the name service did not answer within 5 s for host " + address.host +
                            "; give its numeric address"};
}

bool is_tcp_port(const std::string& text) {
  unsigned number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc{} && end == text.data() + text.size() && number >= 1 && number <= 65535;
}

}  // namespace

PortAddress parse_port(const std::string& text, const std::string& option) {
  if (text.starts_with("/")) return {text, "", ""};
  const std::size_t colon = text.rfind(':');
  if (!text.starts_with("tcp:") || colon <= 4) {
    throw runtime::StartError{option + ": " + text +
                              " is neither a device such as /dev/ttyUSB0 nor tcp:HOST:PORT"};
  }
  const std::string port = text.substr(colon + 1);
  if (!is_tcp_port(port)) {
    throw runtime::StartError{option + ": " + text + ": the port must be 1 to 65535, is \"" + port + "\""};
  }
  return {"", text.substr(4, colon - 4), port};
}

std::string to_text(const PortAddress& address) {
  return address.path.empty() ? "tcp:" + address.host + ":" + address.port : address.path;
}

Endpoint resolve(const PortAddress& address, const std::string& option) {
  if (!address.path.empty()) return {address, std::nullopt};
  Answer answer = ask(address, AI_NUMERICHOST);
  if (answer.error != 0) answer = ask_name_service(address, option);
  if (answer.error != 0) {
    throw runtime::StartError{option + ": " + to_text(address) + ": unknown host " + address.host + " (" +
                              gai_strerror(answer.error) + ")"};
  }
  return {address, answer.place};
}

std::string canonical(const Endpoint& endpoint) {
  if (!endpoint.place) {
    std::error_code ignored;
    const auto path = std::filesystem::weakly_canonical(endpoint.address.path, ignored);
    return ignored ? endpoint.address.path : path.string();
  }
  std::array<char, INET_ADDRSTRLEN> host{};
  inet_ntop(AF_INET, &endpoint.place->sin_addr, host.data(), host.size());
  return "tcp:" + std::string{host.data()} + ":" + std::to_string(ntohs(endpoint.place->sin_port));
}

}  // namespace caravan::bridge
