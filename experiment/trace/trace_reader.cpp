// SPDX-License-Identifier: Apache-2.0
#include "experiment/trace/trace_reader.hpp"

#include <array>
#include <charconv>
#include <utility>

#include "runtime/config/start_error.hpp"
#include "runtime/trace/trace_file.hpp"

namespace caravan::experiment {
namespace {

/// A step of a thousand robots has some hundred kilobytes.
constexpr std::uint32_t kLongestStep = 1U << 28U;

}  // namespace

TraceReader::TraceReader(std::filesystem::path file, const std::string& part) : file_{std::move(file)} {
  std::error_code error;
  if (std::filesystem::exists(file_, error) && !std::filesystem::is_regular_file(file_, error))
    throw runtime::StartError{file_.string() + ": is no regular file; `caravan run --trace` records one"};
  in_.open(file_, std::ios::binary);
  if (!in_) throw runtime::StartError{file_.string() + ": cannot be read; `caravan run --trace` records one"};
  std::string heading;
  std::getline(in_, heading);
  const std::size_t before = heading.rfind(' ');
  if (before != std::string::npos) {
    std::from_chars(heading.data() + before + 1, heading.data() + heading.size(), number_);
  }
  if (heading + "\n" != runtime::trace_heading(part, number_)) {
    throw runtime::StartError{file_.string() + ": is not a " + part + " trace of this version"};
  }
}

bool TraceReader::next(std::vector<std::uint8_t>& step) {
  std::array<char, 4> length{};
  in_.read(length.data(), length.size());
  if (in_.gcount() != static_cast<std::streamsize>(length.size())) {
    cut_off_ = in_.gcount() > 0;
    return false;
  }
  std::uint32_t size = 0;
  for (std::size_t i = 0; i < 4; ++i) size |= std::uint32_t{static_cast<std::uint8_t>(length[i])} << (8 * i);
  if (size > kLongestStep)
    throw runtime::StartError{file_.string() + ": is damaged: a step of " + std::to_string(size) + " bytes"};
  step.resize(size);
  in_.read(reinterpret_cast<char*>(step.data()), size);
  cut_off_ = in_.gcount() != static_cast<std::streamsize>(size);
  return !cut_off_;
}

}  // namespace caravan::experiment
