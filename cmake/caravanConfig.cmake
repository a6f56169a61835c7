# SPDX-License-Identifier: Apache-2.0
# find_package(caravan) gives
#   caravan::controller  the headers of controllers: <caravan/controller.hpp>
#   caravan::kit         tests of deployments: <caravan/deployment.hpp>, and with GoogleTest <caravan/deployment_test.hpp>
# Neither needs another package.
include(${CMAKE_CURRENT_LIST_DIR}/caravanTargets.cmake)
