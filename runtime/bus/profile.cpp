// SPDX-License-Identifier: Apache-2.0
#include "runtime/bus/profile.hpp"

#include <algorithm>
#include <mutex>
#include <optional>

#include "runtime/config/start_error.hpp"

namespace caravan::runtime {
namespace {

/// Lets DDS read the file, once per process.
void load_once(const std::filesystem::path& file) {
  static std::mutex mutex;
  static std::optional<std::filesystem::path> loaded;
  const std::lock_guard lock{mutex};
  if (loaded == file) return;
  if (loaded) throw StartError{file.string() + ": this process already uses the profile " + loaded->string()};
  if (!is_ok(dds::DomainParticipantFactory::get_instance()->load_XML_profiles_file(file))) {
    throw StartError{file.string() + ": not a Fast DDS profile file, or something in it is wrong"};
  }
  loaded = file;
}

}  // namespace

bool is_shared_memory(const std::shared_ptr<rtps::TransportDescriptorInterface>& transport) {
  return dynamic_cast<const rtps::SharedMemTransportDescriptor*>(transport.get()) != nullptr;
}

dds::DomainParticipantQos read_profile(const std::filesystem::path& file) {
  load_once(file);
  dds::DomainParticipantQos qos = dds::PARTICIPANT_QOS_DEFAULT;
  auto* const factory = dds::DomainParticipantFactory::get_instance();
  if (!is_ok(factory->get_participant_qos_from_profile(kProfileName, qos))) {
    throw StartError{file.string() + ": no participant profile named \"" + kProfileName + "\""};
  }
  return qos;
}

bool uses_shared_memory(const dds::DomainParticipantQos& qos) {
  const auto& transports = qos.transport();
  return transports.use_builtin_transports ||
         std::any_of(transports.user_transports.begin(), transports.user_transports.end(), is_shared_memory);
}

bool uses_shared_memory_alone(const dds::DomainParticipantQos& qos) {
  const auto& transports = qos.transport();
  return !transports.use_builtin_transports && !transports.user_transports.empty() &&
         std::all_of(transports.user_transports.begin(), transports.user_transports.end(), is_shared_memory);
}

}  // namespace caravan::runtime
