// SPDX-License-Identifier: Apache-2.0
#include "hardware_bridge/shell/line.hpp"

#include <fcntl.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <termios.h>

#include <array>
#include <cerrno>
#include <cstring>

namespace caravan::bridge {
namespace {

constexpr std::size_t kMostWaiting = 65536;
constexpr std::chrono::seconds kConnectPatience{1};

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
  // Exclusive: no other program may open it, except root's (see Claim).
  if (ioctl(port.number(), TIOCEXCL) != 0) return {};
  tcflush(port.number(), TCIOFLUSH);
  return port;
}

/// Why a port that could not be opened will not work later either; empty: it may. A missing file may appear
/// later, with an adapter that is plugged in.
std::string why_in_vain(const std::string& path, int error) {
  if (error == EBUSY) return "in use by another program; end that one first";
  struct stat found {};
  const bool is_something_else = stat(path.c_str(), &found) == 0 && !S_ISCHR(found.st_mode);
  if (error != ENOTTY && !is_something_else) return "";
  return "not a serial line; give a device such as /dev/ttyUSB0";
}

Descriptor begin_connecting(const sockaddr_in& place) {
  Descriptor socket{::socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0)};
  const auto* const address = reinterpret_cast<const sockaddr*>(&place);
  const bool begun =
      socket.is_open() && (connect(socket.number(), address, sizeof place) == 0 || errno == EINPROGRESS);
  return begun ? std::move(socket) : Descriptor{};
}

/// TIOCEXCL would stay set while another program still has the terminal open.
void leave_to_others(int descriptor) {
  ioctl(descriptor, TIOCNXCL);  // fails on a socket, harmlessly
}

/// Like write(), but without SIGPIPE on a closed connection.
ssize_t write_some(int descriptor, const Bytes& bytes) {
  const ssize_t sent = send(descriptor, bytes.data(), bytes.size(), MSG_NOSIGNAL);
  if (sent >= 0 || errno != ENOTSOCK) return sent;
  return ::write(descriptor, bytes.data(), bytes.size());
}

void send_at_once(int socket) {
  const int on = 1;
  setsockopt(socket, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);  // fails on a serial port, harmlessly
}

}  // namespace

std::string Line::open(const Endpoint& endpoint, unsigned baud) {
  close();
  closed_ = false;
  unfit_.clear();
  connecting_ = endpoint.place.has_value();
  if (connecting_) {
    descriptor_ = begin_connecting(*endpoint.place);
    give_up_ = std::chrono::steady_clock::now() + kConnectPatience;
  } else {
    descriptor_ = open_serial(endpoint.address.path, baud);
  }
  if (descriptor_.is_open()) return "";
  const int error = errno;
  if (!connecting_) unfit_ = why_in_vain(endpoint.address.path, error);
  fail(unfit_.empty() ? std::strerror(error) : unfit_);
  return failure_;
}

void Line::expire(runtime::WallTime now) {
  if (connecting_ && now >= give_up_) fail("no answer to the connection within 1 s: is the address right?");
}

std::optional<runtime::WallTime> Line::next_deadline() const {
  return connecting_ ? std::optional{give_up_} : std::nullopt;
}

void Line::adopt(Descriptor descriptor) {
  close();
  descriptor_ = std::move(descriptor);
  send_at_once(descriptor_.number());
}

void Line::close() {
  if (is_open()) leave_to_others(descriptor_.number());
  descriptor_.reset();
  connecting_ = false;
  waiting_.clear();
  failure_.clear();
}

void Line::fail(const std::string& why) {
  close();
  failure_ = why;
}

runtime::Polled Line::watched() const {
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
      closed_ = count == 0 || errno == ECONNRESET;
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
