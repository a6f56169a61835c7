// SPDX-License-Identifier: Apache-2.0
#include "runtime/provenance/differences.hpp"

namespace caravan::runtime {
namespace {

class Lines {
 public:
  void compare(const std::string& what, const std::string& then, const std::string& now) {
    if (then != now) lines_.push_back(what + ": " + now + "; the run had " + then);
  }
  /// Entries that only one side has count as different.
  template <typename Value, typename ToText>
  void compare(const std::string& what, const std::map<std::string, Value>& then,
               const std::map<std::string, Value>& now, ToText to_text) {
    std::map<std::string, Value> all = then;
    all.insert(now.begin(), now.end());
    const auto text_in = [&](const std::map<std::string, Value>& map, const std::string& key) {
      const auto found = map.find(key);
      return found == map.end() ? std::string{"none"} : to_text(found->second);
    };
    for (const auto& [key, value] : all) compare(what + " " + key, text_in(then, key), text_in(now, key));
  }
  [[nodiscard]] const std::vector<std::string>& lines() const { return lines_; }

 private:
  std::vector<std::string> lines_;
};

std::string to_text(const Commit& commit) {
  return commit.id + (commit.dirty.value_or(false) ? " with changes" : "");
}

std::string to_text(const std::optional<HashedFile>& file) {
  return file ? "SHA-256 " + file->sha256 : "none";
}

}  // namespace

std::vector<std::string> differences(const Provenance& then, const Provenance& now) {
  Lines lines;
  lines.compare("version", then.build.version, now.build.version);
  lines.compare("commit", to_text(then.build.commit), to_text(now.build.commit));
  lines.compare("compiler", then.build.compiler, now.build.compiler);
  lines.compare("build type", then.build.type, now.build.type);
  lines.compare("compiler flags", then.build.flags, now.build.flags);
  lines.compare("library", then.build.libraries, now.build.libraries,
                [](const std::string& version) { return version; });
  lines.compare("processor", then.host.processor, now.host.processor);
  lines.compare("architecture", then.host.architecture, now.host.architecture);
  lines.compare("cores", std::to_string(then.host.cores), std::to_string(now.host.cores));
  lines.compare("kernel", then.host.kernel, now.host.kernel);
  lines.compare("release", then.host.release, now.host.release);
  lines.compare("seed", then.seeds, now.seeds, [](std::uint64_t seed) { return std::to_string(seed); });
  lines.compare("scenario", "SHA-256 " + then.scenario_sha256, "SHA-256 " + now.scenario_sha256);
  lines.compare("controller", to_text(then.controller), to_text(now.controller));
  lines.compare("agent", to_text(then.agent), to_text(now.agent));
  return lines.lines();
}

}  // namespace caravan::runtime
