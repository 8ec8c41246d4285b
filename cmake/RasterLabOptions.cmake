# How everything of ours is compiled. Third-party headers come in as SYSTEM and are not warned about.

if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
endif()
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/bin")

find_program(RASTERLAB_CCACHE ccache)
if(RASTERLAB_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  # Precompiled headers need these two freedoms; without them ccache never hits. Paths count from the root of the tree,
  # so that what one copy of it compiled serves every other.
  set(CMAKE_CXX_COMPILER_LAUNCHER
      "${CMAKE_COMMAND};-E;env;CCACHE_SLOPPINESS=pch_defines,time_macros;CCACHE_BASEDIR=${PROJECT_SOURCE_DIR};${RASTERLAB_CCACHE}")
endif()

add_library(rasterlab_options INTERFACE)
target_compile_options(
  rasterlab_options
  INTERFACE -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror
            # One input gives one image, whatever the compiler.
            -ffp-contract=off
            $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>)
# A program loads only the libraries it calls: most never open a window.
target_link_options(rasterlab_options INTERFACE -Wl,--as-needed)

if(RASTERLAB_SANITIZERS)
  string(REPLACE "," ";" sanitizers "${RASTERLAB_SANITIZERS}")
  foreach(sanitizer IN LISTS sanitizers)
    add_compile_options(-fsanitize=${sanitizer})
    add_link_options(-fsanitize=${sanitizer})
  endforeach()
  add_compile_options(-fno-omit-frame-pointer -fno-sanitize-recover=all)
endif()
# Fuzzers are built where both their compiler and the sanitizers are.
if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang" AND RASTERLAB_SANITIZERS MATCHES "address")
  set(RASTERLAB_FUZZING ON)
endif()
