# What the exercises need.
add_library(raytree_exercises STATIC exercise_main.cpp facts.cpp program.cpp)
target_link_libraries(raytree_exercises PUBLIC raytree_cli PRIVATE raytree_warnings fmt::fmt)

foreach(lesson @LESSONS@)
  string(SUBSTRING ${lesson} 0 2 number)
  add_executable(exercise${number} ${lesson}/exercise.cpp)
  target_link_libraries(exercise${number} PRIVATE raytree_exercises)
endforeach()

if(EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/00_geometry)
  add_library(raytree_geometry STATIC
    00_geometry/figures.cpp 00_geometry/figures_arguments.cpp 00_geometry/figures_line2.cpp
    00_geometry/figures_line3.cpp 00_geometry/program.cpp 00_geometry/svg.cpp 00_geometry/tutorial.cpp)
  target_link_libraries(raytree_geometry PUBLIC raytree_cli PRIVATE raytree_warnings fmt::fmt)
  add_executable(exercise00 00_geometry/exercise.cpp)
  target_link_libraries(exercise00 PRIVATE raytree_geometry)
endif()
