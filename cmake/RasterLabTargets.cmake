# What a stage, a test and a program are, said once.

# Everything of ours: the warnings, the repository root as include path.
function(rasterlab_defaults target)
  target_link_libraries(${target} PRIVATE rasterlab_options)
  target_include_directories(${target} PUBLIC "$<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>")
endfunction()

# Adds a folder that may have been left out of a hand-out.
function(rasterlab_add_part folder)
  if(EXISTS "${PROJECT_SOURCE_DIR}/${folder}/CMakeLists.txt")
    add_subdirectory("${PROJECT_SOURCE_DIR}/${folder}" "${PROJECT_BINARY_DIR}/${folder}")
  endif()
endfunction()

# rasterlab_add_program(<name> <sources>... [LIBRARIES <targets>...]): an executable on common.
function(rasterlab_add_program name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "LIBRARIES")
  add_executable(${name} ${arg_UNPARSED_ARGUMENTS})
  rasterlab_defaults(${name})
  target_link_libraries(${name} PRIVATE common ${arg_LIBRARIES})
  target_link_options(${name} PRIVATE -rdynamic) # function names in backtrace_log.txt
endfunction()

# rasterlab_add_stage(<NN_topic>): the executable of a stage, with its exercises.json built in; what is called
# *.simd.cpp is compiled once per instruction set. Does nothing where the folder is absent.
function(rasterlab_add_stage stage)
  set(folder "${PROJECT_SOURCE_DIR}/${stage}")
  if(NOT EXISTS "${folder}/main.cpp")
    return()
  endif()
  file(GLOB sources CONFIGURE_DEPENDS "${folder}/*.cpp")
  file(GLOB simd_sources CONFIGURE_DEPENDS "${folder}/*.simd.cpp")
  if(simd_sources)
    list(REMOVE_ITEM sources ${simd_sources})
  endif()
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${folder}/exercises.json")
  file(READ "${folder}/exercises.json" RASTERLAB_MANIFEST)
  set(manifest "${PROJECT_BINARY_DIR}/manifests/${stage}.cpp")
  configure_file("${PROJECT_SOURCE_DIR}/cmake/manifest.cpp.in" "${manifest}" @ONLY)
  rasterlab_add_program(${stage} ${sources} "${manifest}")
  target_compile_options(${stage} PRIVATE "$<$<CONFIG:RelWithDebInfo>:-O0>") # the sanitizers' builds: quicker to make
  if(simd_sources)
    rasterlab_add_simd_sources(${stage} ${simd_sources})
  endif()
endfunction()

# rasterlab_test_runs(<tests> <programs>...): building these tests builds the programs they run. Not under sanitizers, where
# the tests that run no program are built alone (.ci/run).
function(rasterlab_test_runs tests)
  if(NOT RASTERLAB_SANITIZERS)
    add_dependencies(${tests} ${ARGN})
  endif()
endfunction()

# A test is compiled for longer than it runs; what it calls in common is optimized in full.
set(RASTERLAB_TEST_OPTIONS "$<$<CONFIG:Release>:-O1>" "$<$<CONFIG:RelWithDebInfo>:-O0>")

# rasterlab_add_tests(<name> LABELS <labels>... SOURCES <files>... [LIBRARIES <targets>...]
#                     [PROPERTIES <ctest properties>...])
# One GoogleTest executable. TEST(stage02_fill_triangle, shared_edge) is the CTest
# "stage02.fill_triangle.shared_edge": the first underscore after the stage becomes a dot. With the label stageNN a
# test is left out where that stage is absent.
function(rasterlab_add_tests name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "LABELS;SOURCES;LIBRARIES;PROPERTIES")
  foreach(label IN LISTS arg_LABELS)
    if(label MATCHES "^stage([0-9][0-9])$")
      file(GLOB stage_folder "${PROJECT_SOURCE_DIR}/${CMAKE_MATCH_1}_*")
      if(NOT stage_folder)
        return()
      endif()
    endif()
  endforeach()
  # The C++ library stands before common's archive: what gmock needs of it, also defined in common/stage, would else
  # bring in the stage framework, which only a stage's executable can link.
  rasterlab_add_program(${name} ${arg_SOURCES} LIBRARIES GTest::gmock stdc++ rasterlab_test_support ${arg_LIBRARIES})
  target_compile_options(${name} PRIVATE ${RASTERLAB_TEST_OPTIONS})
  target_precompile_headers(${name} REUSE_FROM rasterlab_test_support)
  set_property(GLOBAL APPEND PROPERTY RASTERLAB_TEST_PROGRAMS ${name})
  set(list_file "${CMAKE_CURRENT_BINARY_DIR}/${name}_tests.cmake")
  add_custom_command(
    TARGET ${name} POST_BUILD
    COMMAND
      "${CMAKE_COMMAND}" -D "PROGRAM=$<TARGET_FILE:${name}>" -D "OUTPUT=${list_file}" -D "LABELS=${arg_LABELS}" -D
      "PROPERTIES=${arg_PROPERTIES}" -D "FOLDER=${PROJECT_SOURCE_DIR}" -P
      "${PROJECT_SOURCE_DIR}/cmake/list_tests.cmake"
    BYPRODUCTS "${list_file}"
    VERBATIM)
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES "${list_file}")
  if(NOT EXISTS "${list_file}")
    file(WRITE "${list_file}" "add_test(${name}.not_built ${name}.not_built)\n")
  endif()
endfunction()
