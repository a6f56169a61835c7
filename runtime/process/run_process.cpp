// SPDX-License-Identifier: Apache-2.0
#include "runtime/process/run_process.hpp"

#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <cstdio>
#include <cstring>

#include "runtime/config/start_error.hpp"
#include "runtime/config/write_error.hpp"
#include "runtime/process/streams.hpp"
#include "runtime/process/version.hpp"
#include "runtime/pure/one_line.hpp"

namespace caravan::runtime {
namespace {

void set_up_logging(const std::string& name, const std::string& level) {
  spdlog::set_default_logger(spdlog::stderr_color_mt(name));
  spdlog::set_pattern("%Y-%m-%dT%H:%M:%S.%e %^%l%$ %n: %v");
  spdlog::set_level(spdlog::level::from_str(level));
  spdlog::flush_on(spdlog::level::info);
}

}  // namespace

int with_output_written(int code) {
  const std::string why = failure_of_output();
  if (why.empty()) return code;
  std::fprintf(stderr, "%s\n", why.c_str());
  return code == kDone ? kFailed : code;
}

int run_process(const Program& program, int argc, char** argv,
                const std::function<int(const Start&, Loop&)>& body) {
  prepare_streams();
  Start start;
  std::string level = "info";
  std::string transport = to_text(start.transport);
  CLI::App app{program.purpose, program.name};
  app.set_version_flag("--version", std::string{kVersion});
  app.add_option("--scenario", start.scenario, "Scenario file (TOML)")->required();
  app.add_option("--domain", start.domain, "DDS domain, 0 to 232")->check(CLI::Range(0, 232));
  app.add_option("--lease", start.lease_s, "Seconds of silence after which this process counts as gone")
      ->check(CLI::Range(0.5, 60.0));
  app.add_option("--transport", transport, "DDS transport: shm, udp (on 127.0.0.1) or a profile (FILE.xml)")
      ->check(complaint_about_transport)
      ->capture_default_str();
  app.add_flag("--check-config", start.check_only, "Check the configuration and end");
  app.add_option("--log-level", level, "Lowest severity shown")
      ->check(CLI::IsMember({"trace", "debug", "info", "warn", "error"}));
  for (const NumberOption& option : program.numbers) {
    app.add_option(option.flag, *option.value, option.help)->required(option.required);
  }
  for (const TextOption& option : program.texts) app.add_option(option.flag, *option.values, option.help);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return with_output_written(app.exit(error) == 0 ? kDone : kCouldNotStart);
  }
  start.transport = transport_named(transport);
  try {
    Loop loop;
    set_up_logging(program.name, level);
    const int code = body(start, loop);
    if (start.check_only && code == kDone) std::printf("%s: good\n", start.scenario.c_str());
    return with_output_written(code);
  } catch (const BeginAnew& anew) {
    spdlog::warn("{}: restarting", anew.reason);
    execv("/proc/self/exe", argv);
    spdlog::error("cannot restart: {}", std::strerror(errno));
    return kFailed;
  } catch (const StartError& error) {
    spdlog::error("{}", pure::one_line(error.what()));
    return kCouldNotStart;
  } catch (const WriteError& error) {
    spdlog::error("{}", pure::one_line(error.what()));
    return kFailed;
  } catch (const std::exception& error) {
    spdlog::error("ended by an unexpected error: {}", pure::one_line(error.what()));
    return kFailed;
  }
}

}  // namespace caravan::runtime
