# `learn`, and what known mistakes answer, for it and for hand-outs.
add_executable(grade_mistakes learn/mistakes_main.cpp)
target_link_libraries(grade_mistakes PRIVATE raytree_grade raytree_warnings fmt::fmt)
set(mistakes ${PROJECT_BINARY_DIR}/mistakes)
add_custom_command(OUTPUT ${mistakes}/stamp
  COMMAND grade_mistakes ${mistakes}
  COMMAND ${CMAKE_COMMAND} -E touch ${mistakes}/stamp
  DEPENDS grade_mistakes ${PROJECT_SOURCE_DIR}/lessons/exercises.toml)
add_custom_target(mistakes DEPENDS ${mistakes}/stamp)

add_executable(learn learn/learn_main.cpp)
target_link_libraries(learn PRIVATE raytree_grade raytree_warnings fmt::fmt)
add_dependencies(learn mistakes grade_kit)
