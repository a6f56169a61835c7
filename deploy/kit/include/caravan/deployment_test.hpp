// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>

#include <caravan/deployment.hpp>

namespace caravan::deploy {

/// GoogleTest fixture for tests of deployments; deployment_tests.md is its tutorial.
///
/// deploy() takes a DDS domain for this test only and a folder for the logs, which is kept if the test fails.
/// The actions and expectations are those of `caravan deploy`.
class DeploymentTest : public ::testing::Test {
 protected:
  DeploymentTest() {
    std::string pattern = std::filesystem::temp_directory_path() / "caravan_deployment_XXXXXX";
    if (mkdtemp(pattern.data()) != nullptr) folder_ = pattern;
  }
  ~DeploymentTest() override {
    deployment_.reset();
    if (HasFailure()) {
      std::cout << "logs kept in " << folder_ << "\n";
      return;
    }
    std::error_code error;
    std::filesystem::remove_all(folder_, error);
  }

  /// Call it before anything else. A second call ends the first deployment and creates another.
  Deployment& deploy(DeploymentOptions options) {
    deployment_.reset();
    if (options.folder.empty()) options.folder = folder_ / std::to_string(++deployments_);
    std::filesystem::create_directories(options.folder);
    deployment_ = std::make_unique<Deployment>(std::move(options));
    return *deployment_;
  }
  /// EXPECT_TRUE(does("kill robot 2"));
  [[nodiscard]] ::testing::AssertionResult does(const std::string& action) {
    return to_assertion(deployment_->act(action));
  }
  /// EXPECT_TRUE(happens("its loss is noticed", "gone has \"robot 2\"", 8s));
  [[nodiscard]] ::testing::AssertionResult happens(const std::string& name, const std::string& condition,
                                                   std::chrono::milliseconds within) {
    return to_assertion(deployment_->expect(name, Condition{condition}, within));
  }
  /// The same with a condition in C++.
  [[nodiscard]] ::testing::AssertionResult happens(const std::string& name,
                                                   std::function<bool(const Seen&)> condition,
                                                   std::chrono::milliseconds within) {
    return to_assertion(deployment_->expect(name, Condition{name, std::move(condition)}, within));
  }
  /// Stops all processes and cleans up, as the end of the test does.
  void end_deployment() { deployment_.reset(); }
  [[nodiscard]] Seen seen() { return deployment_->seen(); }
  [[nodiscard]] Deployment& deployment() { return *deployment_; }
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

 private:
  static ::testing::AssertionResult to_assertion(const ActionResult& result) {
    return result.good ? ::testing::AssertionSuccess() : ::testing::AssertionFailure() << result.text;
  }

  std::filesystem::path folder_;
  int deployments_ = 0;
  std::unique_ptr<Deployment> deployment_;
};

}  // namespace caravan::deploy
