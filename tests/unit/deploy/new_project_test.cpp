// SPDX-License-Identifier: Apache-2.0
#include "deploy/cli/new_project.hpp"

#include <gmock/gmock.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "runtime/config/start_error.hpp"

namespace caravan::deploy {
namespace {

using testing::HasSubstr;

TEST(NewProject, TakesNamesThatFilesTargetsAndClassesCanHave) {
  for (const char* name : {"a", "my_swarm", "gradient2", "x_", "run"})
    EXPECT_EQ(complaint_about_project(name), "") << name;
  for (const std::string& name : {std::string{}, std::string{"My_swarm"}, std::string{"2nd"},
                                  std::string{"_a"}, std::string{"my-swarm"}, std::string{"a/b"},
                                  std::string{"a b"}, std::string{"schwärme"}, std::string(41, 'a')})
    EXPECT_THAT(complaint_about_project(name), HasSubstr("lower-case letters")) << name;
  for (const char* name : {"test", "all", "paper"})
    EXPECT_THAT(complaint_about_project(name), HasSubstr("reserved")) << name;
}

TEST(NewProject, RenamesFilesAndClassesOfTheModel) {
  EXPECT_EQ(renamed("my_swarm_test.cpp", "flock"), "flock_test.cpp");
  EXPECT_EQ(renamed("class MySwarm; // my_swarm my_swarm", "my_swarm_2"),
            "class MySwarm2; // my_swarm_2 my_swarm_2");
  EXPECT_EQ(renamed("MySwarm", "x_"), "X");
}

TEST(NewProject, NamesTheMissingTemplates) {
  try {
    (void)write_project("flock", "/nowhere/templates");
    FAIL();
  } catch (const runtime::StartError& error) {
    EXPECT_STREQ(error.what(), "caravan new: /nowhere/templates is missing: install Caravan anew");
  }
}

TEST(NewProject, SaysWhatToDoInAFolderThatWasRemoved) {
  namespace fs = std::filesystem;
  const fs::path before = fs::current_path();
  const fs::path models = fs::temp_directory_path() / ("new_project_" + std::to_string(getpid()));
  const fs::path gone = models.string() + "_gone";
  fs::create_directory(models);
  fs::create_directory(gone);
  std::ofstream{models / "my_swarm.cpp"} << "class MySwarm;";
  fs::current_path(gone);
  fs::remove(gone);
  std::string said;
  try {
    (void)write_project("flock", models);
  } catch (const runtime::StartError& error) {
    said = error.what();
  }
  fs::current_path(before);
  fs::remove_all(models);
  EXPECT_EQ(said, "caravan new: the folder in which you are no longer exists: change to another one (cd ~)");
}

}  // namespace
}  // namespace caravan::deploy
