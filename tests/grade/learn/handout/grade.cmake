# The engine of `./raytree learn`.
file(GLOB_RECURSE sources CONFIGURE_DEPENDS *.cpp)
list(FILTER sources EXCLUDE REGEX "(_main|\\.student)\\.cpp$")
add_library(raytree_grade STATIC ${sources})
target_link_libraries(raytree_grade PUBLIC raytree_cases raytree_exercises PRIVATE raytree_warnings fmt::fmt nlohmann_json::nlohmann_json tomlplusplus::tomlplusplus)
target_compile_definitions(raytree_grade PRIVATE RAYTREE_SOURCE_DIR="${PROJECT_SOURCE_DIR}" RAYTREE_BINARY_DIR="${PROJECT_BINARY_DIR}"
  GRADE_LAUNCH="")
add_executable(learn learn/learn_main.cpp)
target_link_libraries(learn PRIVATE raytree_grade raytree_warnings fmt::fmt)
