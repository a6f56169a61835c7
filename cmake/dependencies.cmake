# SPDX-License-Identifier: Apache-2.0
# All libraries that the project links, from Debian 12 or 13; cmake/debian_packages.txt names the packages.
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(fastcdr REQUIRED)
# Debian 13 has Fast DDS 3.1, Debian 12 has 2.9 under its old name; runtime/bus/fastdds_version.hpp has the differences in the code.
find_package(fastdds 3.1 QUIET)
if(fastdds_FOUND)
  set(CARAVAN_FASTDDS fastdds)
else()
  find_package(fastrtps 2.9 REQUIRED)
  set(CARAVAN_FASTDDS fastrtps)
endif()
find_package(spdlog REQUIRED)
find_package(CLI11 REQUIRED)
find_package(tomlplusplus REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(Threads REQUIRED)
find_package(GTest REQUIRED)  # of the tests, and of agent_contract, which is installed
# Only the modules of Python use these; no program is linked with Python, which is loaded when a controller is written in it.
# Debian's own interpreter: it has Debian's packages, whatever python3 is first in the path.
set(Python3_EXECUTABLE /usr/bin/python3)
find_package(Python3 REQUIRED COMPONENTS Interpreter Development)
find_package(pybind11 REQUIRED)

find_path(ODE_INCLUDE_DIR ode/ode.h REQUIRED)
find_library(ODE_LIBRARY ode REQUIRED)
add_library(caravan_ode INTERFACE)
target_include_directories(caravan_ode SYSTEM INTERFACE ${ODE_INCLUDE_DIR})
target_link_libraries(caravan_ode INTERFACE ${ODE_LIBRARY})
target_compile_definitions(caravan_ode INTERFACE dIDEDOUBLE)
# ODE has no constant and no function for its version.
cmake_path(GET ODE_LIBRARY PARENT_PATH ode_folder)
set(CARAVAN_ODE_VERSION unknown)
if(EXISTS ${ode_folder}/pkgconfig/ode.pc)
  file(STRINGS ${ode_folder}/pkgconfig/ode.pc ode_version REGEX "^Version:")
  string(REGEX REPLACE "^Version: *" "" CARAVAN_ODE_VERSION "${ode_version}")
endif()
