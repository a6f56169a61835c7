// SPDX-License-Identifier: Apache-2.0
#include "robot_agent/core/radio/frames/codec.hpp"

#include <algorithm>
#include <cstdlib>
#include <optional>

#include "robot_agent/core/radio/frames/layout.hpp"
#include "runtime/pure/assert.hpp"
#include "runtime/pure/overload.hpp"

namespace caravan::agent {
namespace {

enum class Type : std::uint8_t {
  kWait = 1,
  kAccept = 2,
  kAcceptAck = 3,
  kReject = 4,
  kPath = 5,
  kEnd = 6,
  kWaitAt = 7
};

constexpr std::uint8_t kMagic = 0xC1;  // "Caravan, version 1"
constexpr std::size_t kWhereaboutsBytes = 14;
constexpr int kMostYaw_mrad = 3142;
constexpr std::size_t kPathHeaderBytes = 16;
constexpr std::size_t kPointBytes = 8;

/// Sender, receiver and session: the common header of all frames except WAIT.
struct Address {
  RobotId from;
  RobotId to;
  std::uint16_t session = 0;
};

/// @param session_required false: session 0 is valid
std::optional<Address> read_address(ByteReader& in, bool session_required) {
  const Address address{RobotId{in.u16()}, RobotId{in.u16()}, in.u16()};
  const bool good = address.from.value != 0 && address.to.value != 0 && address.from != address.to &&
                    (address.session != 0 || !session_required);
  return good ? std::optional{address} : std::nullopt;
}

Whereabouts read_whereabouts(ByteReader& in) {
  Whereabouts whereabouts;
  whereabouts.at.x_mm = in.i32();
  whereabouts.at.y_mm = in.i32();
  whereabouts.yaw_mrad = in.i16();
  whereabouts.speed_mmps = in.i16();
  whereabouts.turn_mradps = in.i16();
  return whereabouts;
}

Decoded read_wait(ByteReader in, bool tells_place) {
  if (in.left() != (tells_place ? 6 + kWhereaboutsBytes : 6)) return DecodeError::kWrongLength;
  const RobotId from{in.u16()};
  const std::uint8_t mode = in.u8();
  const std::uint8_t engagement = in.u8();
  const RobotId partner{in.u16()};
  if (from.value == 0 || mode > 1 || engagement > 3 || partner == from) return DecodeError::kBadValue;
  const bool engaged = engagement == static_cast<std::uint8_t>(Engagement::kNegotiating) ||
                       engagement == static_cast<std::uint8_t>(Engagement::kInSession);
  if (engaged != (partner.value != 0)) return DecodeError::kBadValue;
  Wait wait{from, static_cast<Mode>(mode), static_cast<Engagement>(engagement), partner};
  if (tells_place) {
    wait.whereabouts = read_whereabouts(in);
    if (std::abs(wait.whereabouts->yaw_mrad) > kMostYaw_mrad) return DecodeError::kBadValue;
  }
  return wait;
}

Decoded read_accept(ByteReader in) {
  if (in.left() != 7) return DecodeError::kWrongLength;
  const auto address = read_address(in, true);
  const std::uint8_t mode = in.u8();
  if (!address || mode > 1) return DecodeError::kBadValue;
  return Accept{address->from, address->to, address->session, static_cast<Mode>(mode)};
}

Decoded read_accept_ack(ByteReader in) {
  if (in.left() != 6) return DecodeError::kWrongLength;
  const auto address = read_address(in, true);
  if (!address) return DecodeError::kBadValue;
  return AcceptAck{address->from, address->to, address->session};
}

Decoded read_reject(ByteReader in) {
  if (in.left() != 7) return DecodeError::kWrongLength;
  const auto address = read_address(in, false);
  const std::uint8_t refusal = in.u8();
  if (!address || refusal > 1) return DecodeError::kBadValue;
  return Reject{address->from, address->to, address->session, static_cast<Refusal>(refusal)};
}

Decoded read_path(ByteReader in) {
  if (in.left() < kPathHeaderBytes - 2) return DecodeError::kWrongLength;
  const auto address = read_address(in, true);
  const std::uint16_t total = in.u16();
  const std::uint16_t first = in.u16();
  const std::uint8_t has_heard = in.u8();
  const std::uint8_t count = in.u8();
  const std::uint16_t holds = in.u16();
  if (in.left() != count * kPointBytes) return DecodeError::kWrongLength;
  if (!address || total == 1 || first + count > total || has_heard > 1) return DecodeError::kBadValue;
  if (has_heard == 0 && holds != 0) return DecodeError::kBadValue;
  PathFragment path{address->from, address->to, address->session, total, first, has_heard == 1, holds, {}};
  path.points.reserve(count);
  for (std::size_t index = 0; index < count; ++index) {
    const std::int32_t x_mm = in.i32();
    path.points.push_back({x_mm, in.i32()});
  }
  return path;
}

Decoded read_end(ByteReader in) {
  if (in.left() != 6) return DecodeError::kWrongLength;
  const auto address = read_address(in, true);
  if (!address) return DecodeError::kBadValue;
  return End{address->from, address->to, address->session};
}

ByteWriter begin(Type type, std::size_t bytes) {
  ByteWriter out{bytes};
  out.u8(kMagic);
  out.u8(static_cast<std::uint8_t>(type));
  return out;
}

template <typename Addressed>
ByteWriter begin(Type type, std::size_t bytes, const Addressed& message) {
  ByteWriter out = begin(type, bytes);
  out.u16(message.from.value);
  out.u16(message.to.value);
  out.u16(message.session);
  return out;
}

std::vector<std::uint8_t> write_wait(const Wait& wait) {
  ByteWriter out = wait.whereabouts ? begin(Type::kWaitAt, 8 + kWhereaboutsBytes) : begin(Type::kWait, 8);
  out.u16(wait.from.value);
  out.u8(static_cast<std::uint8_t>(wait.mode));
  out.u8(static_cast<std::uint8_t>(wait.engagement));
  out.u16(wait.partner.value);
  if (wait.whereabouts) {
    out.i32(wait.whereabouts->at.x_mm);
    out.i32(wait.whereabouts->at.y_mm);
    out.i16(wait.whereabouts->yaw_mrad);
    out.i16(wait.whereabouts->speed_mmps);
    out.i16(wait.whereabouts->turn_mradps);
  }
  return std::move(out).bytes();
}

std::vector<std::uint8_t> write_path(const PathFragment& path) {
  CARAVAN_ASSERT(path.points.size() <= 255);
  ByteWriter out = begin(Type::kPath, kPathHeaderBytes + path.points.size() * kPointBytes, path);
  out.u16(path.total);
  out.u16(path.first);
  out.u8(path.has_heard ? 1 : 0);
  out.u8(static_cast<std::uint8_t>(path.points.size()));
  out.u16(path.holds);
  for (const GridPoint& point : path.points) {
    out.i32(point.x_mm);
    out.i32(point.y_mm);
  }
  return std::move(out).bytes();
}

template <typename Addressed>
std::vector<std::uint8_t> write_with_byte(Type type, const Addressed& message, std::uint8_t last) {
  ByteWriter out = begin(type, 9, message);
  out.u8(last);
  return std::move(out).bytes();
}

}  // namespace

Decoded decode(std::span<const std::uint8_t> bytes) {
  if (bytes.empty() || bytes[0] != kMagic) return DecodeError::kForeign;
  if (bytes.size() < 2) return DecodeError::kWrongLength;
  const ByteReader body{bytes.subspan(2)};
  switch (static_cast<Type>(bytes[1])) {
    case Type::kWait:
      return read_wait(body, false);
    case Type::kWaitAt:
      return read_wait(body, true);
    case Type::kAccept:
      return read_accept(body);
    case Type::kAcceptAck:
      return read_accept_ack(body);
    case Type::kReject:
      return read_reject(body);
    case Type::kPath:
      return read_path(body);
    case Type::kEnd:
      return read_end(body);
  }
  return DecodeError::kUnknownType;
}

std::vector<std::uint8_t> encode(const Message& message) {
  return std::visit(
      pure::Overload{
          [](const Wait& wait) { return write_wait(wait); },
          [](const Accept& accept) {
            return write_with_byte(Type::kAccept, accept, static_cast<std::uint8_t>(accept.mode));
          },
          [](const AcceptAck& ack) { return begin(Type::kAcceptAck, 8, ack).bytes(); },
          [](const Reject& reject) {
            return write_with_byte(Type::kReject, reject, static_cast<std::uint8_t>(reject.refusal));
          },
          [](const PathFragment& path) { return write_path(path); },
          [](const End& end) { return begin(Type::kEnd, 8, end).bytes(); },
      },
      message);
}

std::uint32_t points_that_fit(std::uint32_t mtu_bytes) {
  if (mtu_bytes < kPathHeaderBytes) return 0;
  return std::min(
      (mtu_bytes - static_cast<std::uint32_t>(kPathHeaderBytes)) / static_cast<std::uint32_t>(kPointBytes),
      255U);
}

}  // namespace caravan::agent
