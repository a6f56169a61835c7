// SPDX-License-Identifier: Apache-2.0
#include "hardware_bridge/shell/line.hpp"

#include <fcntl.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <termios.h>

#include <array>
#include <cerrno>
#include <cstring>

#include "runtime/config/start_error.hpp"

namespace caravan::bridge {
namespace {

constexpr std::size_t kMostWaiting = 65536;

std::string reason() { return std::strerror(errno); }

speed_t speed_of(unsigned baud) {
  switch (baud) {
    case 4800:
      return B4800;
    case 19200:
      return B19200;
    case 38400:
      return B38400;
    case 57600:
      return B57600;
    case 115200:
      return B115200;
    default:
      return B9600;
  }
}

Descriptor open_serial(const std::string& path, unsigned baud) {
  Descriptor port{::open(path.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC)};
  if (!port.is_open()) return port;
  termios settings{};
  if (tcgetattr(port.number(), &settings) != 0) return {};
  cfmakeraw(&settings);
  settings.c_cflag |= CLOCAL | CREAD;
  settings.c_cflag &= ~static_cast<tcflag_t>(CSTOPB | CRTSCTS);
  cfsetispeed(&settings, speed_of(baud));
  cfsetospeed(&settings, speed_of(baud));
  if (tcsetattr(port.number(), TCSANOW, &settings) != 0) return {};
  tcflush(port.number(), TCIOFLUSH);
  return port;
}

std::optional<sockaddr_in> look_up(const PortAddress& address) {
  addrinfo hints{};
  hints.ai_family = AF_INET;
  hints.ai_socktype = SOCK_STREAM;
  addrinfo* found = nullptr;
  if (getaddrinfo(address.host.c_str(), address.port.c_str(), &hints, &found) != 0) {
    errno = EADDRNOTAVAIL;
    return std::nullopt;
  }
  sockaddr_in place{};
  std::memcpy(&place, found->ai_addr, sizeof place);
  freeaddrinfo(found);
  return place;
}

Descriptor begin_connecting(const sockaddr_in& place) {
  Descriptor socket{::socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0)};
  const auto* const address = reinterpret_cast<const sockaddr*>(&place);
  const bool begun =
      socket.is_open() && (connect(socket.number(), address, sizeof place) == 0 || errno == EINPROGRESS);
  return begun ? std::move(socket) : Descriptor{};
}

/// Like write(), but a connection that has been closed raises no signal.
ssize_t write_some(int descriptor, const Bytes& bytes) {
  const ssize_t sent = send(descriptor, bytes.data(), bytes.size(), MSG_NOSIGNAL);
  if (sent >= 0 || errno != ENOTSOCK) return sent;
  return ::write(descriptor, bytes.data(), bytes.size());
}

void send_at_once(int socket) {
  const int on = 1;
  setsockopt(socket, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);  // fails on a serial port, which needs it not
}

}  // namespace

PortAddress parse_port(const std::string& text, const std::string& option) {
  if (text.starts_with("/")) return {text, "", ""};
  const std::size_t colon = text.rfind(':');
  if (text.starts_with("tcp:") && colon > 4 && colon + 1 < text.size()) {
    return {"", text.substr(4, colon - 4), text.substr(colon + 1)};
  }
  throw runtime::StartError{option + ": " + text +
                            " is neither a device such as /dev/ttyUSB0 nor tcp:HOST:PORT"};
}

std::string to_text(const PortAddress& address) {
  return address.path.empty() ? "tcp:" + address.host + ":" + address.port : address.path;
}

std::string Line::open(const PortAddress& address, unsigned baud) {
  close();
  connecting_ = address.path.empty();
  if (!connecting_) {
    descriptor_ = open_serial(address.path, baud);
  } else {
    if (!found_ || looked_up_ != address) found_ = look_up(address);
    looked_up_ = address;
    if (found_) descriptor_ = begin_connecting(*found_);
  }
  if (!descriptor_.is_open()) fail(reason());
  return failure_;
}

void Line::adopt(Descriptor descriptor) {
  close();
  descriptor_ = std::move(descriptor);
  send_at_once(descriptor_.number());
}

void Line::close() {
  descriptor_.reset();
  connecting_ = false;
  waiting_.clear();
  failure_.clear();
}

void Line::fail(const std::string& why) {
  close();
  failure_ = why;
}

runtime::Watched Line::watched() const {
  return {descriptor_.number(), connecting_ || !waiting_.empty(), false};
}

void Line::finish_connecting() {
  int error = 0;
  socklen_t size = sizeof error;
  if (getsockopt(descriptor_.number(), SOL_SOCKET, SO_ERROR, &error, &size) != 0) error = errno;
  if (error != 0) return fail(std::strerror(error));
  connecting_ = false;
  send_at_once(descriptor_.number());
}

Bytes Line::attend() {
  if (!is_open()) return {};
  if (connecting_) {
    finish_connecting();
    return {};
  }
  flush();
  Bytes arrived;
  std::array<std::uint8_t, 4096> chunk{};
  while (is_open() && arrived.size() < kMostWaiting) {
    const ssize_t count = ::read(descriptor_.number(), chunk.data(), chunk.size());
    if (count > 0) {
      arrived.insert(arrived.end(), chunk.begin(), chunk.begin() + count);
    } else if (count < 0 && errno == EINTR) {
      continue;
    } else if (count < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) {
      break;
    } else {
      fail(count == 0 ? "closed at the other end" : reason());
    }
  }
  return arrived;
}

void Line::write(const Bytes& bytes) {
  if (!is_open() || bytes.empty()) return;
  waiting_.insert(waiting_.end(), bytes.begin(), bytes.end());
  if (waiting_.size() > kMostWaiting) return fail("takes no more bytes");
  if (!connecting_) flush();
}

void Line::flush() {
  while (is_open() && !waiting_.empty()) {
    const ssize_t count = write_some(descriptor_.number(), waiting_);
    if (count > 0) {
      waiting_.erase(waiting_.begin(), waiting_.begin() + count);
    } else if (count < 0 && errno == EINTR) {
      continue;
    } else if (count < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) {
      return;
    } else {
      fail(reason());
    }
  }
}

}  // namespace caravan::bridge
