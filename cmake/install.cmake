# SPDX-License-Identifier: Apache-2.0
# The installed tree. It can be moved: programs find each other and their files by the path of the program.
#   bin/                   the programs
#   include/caravan/       public headers: controllers and the test kit
#   lib/                   the test kit; caravan/controllers: the examples; caravan/python: the Python packages; cmake/caravan: find_package(caravan)
#   share/caravan/         scenarios, scripts, DDS profiles, units, IDL, the templates of `caravan new`, examples for scripts, the drawing program
#   share/doc/caravan/     the documentation, with symbolic links for what its pages link to
# This file has what belongs to no single folder of the tree. A folder that makes something else has its own install() beside its target.
include(CMakePackageConfigHelpers)

# caravan_data(NAME FOLDER PATTERN...): files of a folder of the tree as share/caravan/NAME. The build tree has a link to the folder, so that
# programs find the files there in the same way.
function(caravan_data name folder)
  set(patterns)
  foreach(pattern IN LISTS ARGN)
    list(APPEND patterns PATTERN ${pattern})
  endforeach()
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${folder}/ DESTINATION share/caravan/${name} FILES_MATCHING ${patterns}
    PATTERN __pycache__ EXCLUDE)
  cmake_path(GET name PARENT_PATH above)
  file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/share/caravan/${above})
  file(CREATE_LINK ${PROJECT_SOURCE_DIR}/${folder} ${PROJECT_BINARY_DIR}/share/caravan/${name} SYMBOLIC)
endfunction()

caravan_data(scenarios deploy/scenarios *.toml)
caravan_data(scripts deploy/scripts *.toml)
caravan_data(fastdds deploy/fastdds *.xml)
caravan_data(systemd deploy/systemd *.service *.env *.sysusers)
caravan_data(controllers deploy/controllers *.cpp *.py)
caravan_data(idl idl *.idl)
caravan_data(report experiment/report *.py)
caravan_data(templates/my_swarm deploy/templates/my_swarm *)

# The pages keep their places in the tree, so that links between them hold. caravan_page_link(PATH TARGET): pages link to PATH of the tree, which
# is installed at TARGET, relative to the folder of PATH.
function(caravan_page_link path target)
  set(link ${PROJECT_BINARY_DIR}/page_links/${path})
  cmake_path(GET link PARENT_PATH folder)
  file(MAKE_DIRECTORY ${folder})
  file(CREATE_LINK ${target} ${link} SYMBOLIC)
endfunction()
caravan_page_link(deploy ../../caravan)
caravan_page_link(experiment/python/examples ../../../../caravan/examples)
caravan_page_link(idl ../../caravan/idl)
caravan_page_link(runtime/controller/include ../../../../../include)
caravan_page_link(runtime/controller/python ../../../../../lib/caravan/python)
install(DIRECTORY ${PROJECT_BINARY_DIR}/page_links/ DESTINATION share/doc/caravan)
install(DIRECTORY docs DESTINATION share/doc/caravan FILES_MATCHING PATTERN *.md PATTERN *.svg)
install(FILES README.md CHANGELOG.md LICENSE DESTINATION share/doc/caravan)
install(FILES robot_agent/core/README.md DESTINATION share/doc/caravan/robot_agent/core)
file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/share/doc/caravan)
file(CREATE_LINK ${PROJECT_SOURCE_DIR}/docs ${PROJECT_BINARY_DIR}/share/doc/caravan/docs SYMBOLIC)

# Called when all targets exist.
function(caravan_install_targets)
  install(TARGETS caravan world_server radio_emulator robot_agent pioneer_bridge arcos_robot radio_modem_bridge RUNTIME DESTINATION bin)
  install(TARGETS caravan_controller_interface caravan_kit_shared EXPORT caravan_targets LIBRARY DESTINATION lib)
  install(DIRECTORY runtime/controller/include/caravan deploy/kit/include/caravan DESTINATION include)
  install(EXPORT caravan_targets NAMESPACE caravan:: FILE caravanTargets.cmake DESTINATION lib/cmake/caravan)
  write_basic_package_version_file(${PROJECT_BINARY_DIR}/caravanConfigVersion.cmake COMPATIBILITY SameMinorVersion)
  install(FILES cmake/caravanConfig.cmake ${PROJECT_BINARY_DIR}/caravanConfigVersion.cmake DESTINATION lib/cmake/caravan)
endfunction()
