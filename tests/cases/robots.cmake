# Robots and exports of ../shared/cases, where that folder is at hand.
heft_test(robot_cases SOURCES ${CMAKE_CURRENT_LIST_DIR}/robot_cases.cpp ${PROJECT_SOURCE_DIR}/tests/cli/process.cpp
          DEPS heft::exporters heft::base fmt::fmt nlohmann_json::nlohmann_json)
target_compile_definitions(test_robot_cases PRIVATE HEFT_BINARY="$<TARGET_FILE:heft>")
add_dependencies(test_robot_cases heft)
