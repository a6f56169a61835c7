// Tests of the swarm as it is deployed: world, radio and each robot are processes of their own.
#include <caravan/deployment_test.hpp>

using namespace std::chrono_literals;

class MySwarm : public caravan::deploy::DeploymentTest {};

TEST_F(MySwarm, RobotsMeet) {
  deploy({.scenario = SCENARIO, .controller = CONTROLLER});
  ASSERT_TRUE(does("start all"));
  EXPECT_TRUE(happens("robots hear each other", "events met > 0", 60s));
  EXPECT_TRUE(happens("the run ends", "state is finished and disturbed is no", 60s));
}

TEST_F(MySwarm, GoesOnWithoutARobotAndTakesItBack) {
  deploy({.scenario = SCENARIO, .changes = "experiment.max_time_s = 100000.0", .controller = CONTROLLER});
  ASSERT_TRUE(does("start all"));
  ASSERT_TRUE(happens("all robots join", "step > 100", 60s));
  ASSERT_TRUE(does("kill robot 2"));
  ASSERT_TRUE(happens("its loss is noticed", "gone has \"robot 2\" and members is 3", 60s));
  ASSERT_TRUE(does("start robot 2"));
  EXPECT_TRUE(happens("it rejoins", "members is 4", 60s));
}
