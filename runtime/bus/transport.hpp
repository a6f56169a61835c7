// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace caravan::runtime {

/// The DDS transport of a run; all of its processes must use the same.
struct Transport {
  enum Kind : std::uint8_t {
    kSharedMemory,  ///< nothing leaves the machine
    kUdp,           ///< over 127.0.0.1, unicast; for machines without shared memory, and to compare
    kProfile        ///< as defined by a Fast DDS XML file: between machines; docs/hosts.md
  };
  Transport(Kind of_kind = kSharedMemory)
      : kind{of_kind} {}  // NOLINT(google-explicit-constructor): a name for it

  bool operator==(const Transport&) const = default;

  Kind kind;
  std::filesystem::path profile = {};  ///< with kProfile: the file, absolute
};

/// As given on a command line.
[[nodiscard]] inline std::string to_text(const Transport& transport) {
  if (transport.kind == Transport::kProfile) return transport.profile;
  return transport.kind == Transport::kUdp ? "udp" : "shm";
}
/// Why this is not a transport; empty: it is. A file's content is checked only when it is used.
[[nodiscard]] inline std::string complaint_about_transport(const std::string& text) {
  if (text == "shm" || text == "udp") return "";
  std::error_code error;
  if (!text.ends_with(".xml")) return "neither shm, udp nor a DDS profile file (.xml): " + text;
  return std::filesystem::is_regular_file(text, error) ? "" : "no such file: " + text;
}
/// @pre complaint_about_transport(text) is empty
[[nodiscard]] inline Transport transport_named(const std::string& text) {
  if (text == "udp") return Transport::kUdp;
  if (text == "shm") return Transport::kSharedMemory;
  Transport transport = Transport::kProfile;
  transport.profile = std::filesystem::absolute(text);
  return transport;
}

}  // namespace caravan::runtime
