# One program for each exercise: one that does not compile must not stop the others.
find_package(GTest REQUIRED)
file(GLOB cases CONFIGURE_DEPENDS lessons/cases_*.cpp lessons/lesson00_cases.cpp)
add_library(raytree_cases STATIC ${cases})
target_compile_options(raytree_cases PUBLIC -O1)
target_compile_definitions(raytree_cases PUBLIC RAYTREE_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
target_link_libraries(raytree_cases PUBLIC raytree_exercises fmt::fmt)

foreach(number @LESSONS@)
  add_executable(exercise${number}_tests lessons/exercise${number}_test.cpp)
  target_link_libraries(exercise${number}_tests PRIVATE raytree_cases GTest::gtest_main)
  add_test(NAME exercise${number} COMMAND exercise${number}_tests --gtest_brief=1 WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})
endforeach()
add_subdirectory(grade)
