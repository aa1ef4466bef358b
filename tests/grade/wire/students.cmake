# Students' programs for the tests: the exercises as they are, solved, and one that misbehaves. The box compiles real ones.
add_library(grade_runner OBJECT wire/runner.student.cpp)
target_precompile_headers(grade_runner PRIVATE wire/student.h)
target_compile_options(grade_runner PRIVATE -O1)
target_compile_definitions(grade_runner PRIVATE RAYTREE_HEADERS_ONLY) # no oneTBB to link statically
target_link_libraries(grade_runner PRIVATE raytree_core)

# What stands in the folder `students` of the build.
function(grade_student name)
  add_executable(grade_student_${name} ${ARGN} $<TARGET_OBJECTS:grade_runner>)
  set_target_properties(grade_student_${name} PROPERTIES OUTPUT_NAME ${name}
    RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/students)
  target_precompile_headers(grade_student_${name} REUSE_FROM grade_runner)
  target_compile_options(grade_student_${name} PRIVATE -O1)
  target_compile_definitions(grade_student_${name} PRIVATE RAYTREE_HEADERS_ONLY)
  target_link_libraries(grade_student_${name} PRIVATE raytree_core)
  if(NOT CMAKE_CXX_FLAGS MATCHES "fsanitize") # sanitizers need their library
    target_link_options(grade_student_${name} PRIVATE -static)
  endif()
  add_dependencies(grade_tests grade_student_${name})
endfunction()

file(GLOB exercises CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/lessons/*/exercise.h)
foreach(exercise ${exercises})
  get_filename_component(lesson ${exercise} DIRECTORY)
  string(REGEX REPLACE "^.*/(..)_[^/]*$" "\\1" digits ${lesson})
  string(REGEX REPLACE "^0(.)$" "\\1" number ${digits})
  grade_student(exercise${digits} wire/exercise.student.cpp)
  target_include_directories(grade_student_exercise${digits} PRIVATE ${lesson})
  target_compile_definitions(grade_student_exercise${digits} PRIVATE
    RAYTREE_LESSON=${number} RAYTREE_EXERCISE=exercise${digits})

  set(folder ${CMAKE_CURRENT_BINARY_DIR}/solved${digits})
  file(CONFIGURE OUTPUT ${folder}/exercise.h CONTENT "#include \"solved${digits}.h\"\n")
  grade_student(solved${digits} wire/exercise.student.cpp)
  target_include_directories(grade_student_solved${digits} PRIVATE ${folder} ${solved})
  target_compile_definitions(grade_student_solved${digits} PRIVATE
    RAYTREE_LESSON=${number} RAYTREE_EXERCISE=solved${digits})
  add_dependencies(grade_student_solved${digits} solved_exercises)
endforeach()
grade_student(misbehaving wire/misbehaving.student.cpp)
grade_student(blockerless wire/blockerless.student.cpp)
target_include_directories(grade_student_blockerless PRIVATE ${solved})
add_dependencies(grade_student_blockerless solved_exercises)

target_compile_definitions(grade_tests PRIVATE RAYTREE_STUDENTS="${PROJECT_BINARY_DIR}/students/")
