# Files compiled once per instruction set, in a namespace each (common/engine/simd.h).

# What such files need to compile.
add_library(rasterlab_simd_usage INTERFACE)
if(TARGET RasterLab::common) # installed
  target_link_libraries(rasterlab_simd_usage INTERFACE RasterLab::common RasterLab::rasterlab_highway)
else()
  target_link_libraries(rasterlab_simd_usage INTERFACE Eigen3::Eigen nlohmann_json::nlohmann_json rasterlab_highway)
endif()
# A type's layout must not depend on the instruction set its file is compiled for.
target_compile_definitions(rasterlab_simd_usage INTERFACE EIGEN_MAX_ALIGN_BYTES=16)

# The compiler flags are what makes Highway choose a target.
set(RASTERLAB_SIMD_FLAGS_scalar "-DHWY_COMPILE_ONLY_SCALAR")
set(every_target scalar)
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  list(APPEND every_target ssse3 sse4 avx2 avx512)
  set(RASTERLAB_SIMD_FLAGS_ssse3 -mssse3)
  set(RASTERLAB_SIMD_FLAGS_sse4 ${RASTERLAB_SIMD_FLAGS_ssse3} -msse4.2 -mpclmul -maes)
  set(RASTERLAB_SIMD_FLAGS_avx2 ${RASTERLAB_SIMD_FLAGS_sse4} -mavx2 -mbmi -mbmi2 -mfma -mf16c -mlzcnt)
  set(RASTERLAB_SIMD_FLAGS_avx512 ${RASTERLAB_SIMD_FLAGS_avx2} -mavx512f -mavx512vl -mavx512dq -mavx512bw)
endif()
set(RASTERLAB_SIMD_TARGETS "${every_target}" CACHE STRING "Instruction sets to compile for, narrowest first; scalar must be one")

# The same list for C++. An installed package brings the header it was built with; a hand-out may leave the engine out.
if(EXISTS "${CMAKE_CURRENT_LIST_DIR}/../common/engine/compiled_simd_targets.h.in")
  list(TRANSFORM RASTERLAB_SIMD_TARGETS REPLACE "(.+)" "DO(\\1)" OUTPUT_VARIABLE each_target)
  list(JOIN each_target " " RASTERLAB_EACH_SIMD_TARGET)
  configure_file(common/engine/compiled_simd_targets.h.in generated/common/engine/compiled_simd_targets.h @ONLY)
endif()

# GNU ld, also where CMake found another linker beside clang: lld cannot take groups apart.
find_program(RASTERLAB_LD NAMES ld.bfd ld REQUIRED)

# rasterlab_add_simd_sources(<target> <files>...)
# Compiles each file once per instruction set, with RASTERLAB_SIMD naming the namespace its code goes to, and adds the
# objects to the target. In each object every symbol is made local that doesn't carry that namespace's name: a function
# of the standard library or of Eigen that happened to be compiled for AVX-512 must not be the copy the linker keeps for
# everybody.
function(rasterlab_add_simd_sources target)
  set(sources)
  foreach(source IN LISTS ARGN)
    cmake_path(ABSOLUTE_PATH source BASE_DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}")
    list(APPEND sources "${source}")
  endforeach()
  if(NOT sources)
    return() # A hand-out may leave the engine out.
  endif()
  foreach(simd IN LISTS RASTERLAB_SIMD_TARGETS)
    set(objects ${target}_simd_${simd})
    add_library(${objects} OBJECT ${sources})
    target_link_libraries(${objects} PRIVATE rasterlab_simd_usage)
    if(TARGET rasterlab_options)
      target_link_libraries(${objects} PRIVATE rasterlab_options)
      target_include_directories(${objects} PRIVATE "${PROJECT_SOURCE_DIR}" "${PROJECT_BINARY_DIR}/generated")
    endif()
    target_compile_definitions(${objects} PRIVATE RASTERLAB_SIMD=simd_${simd})
    if(NOT simd STREQUAL scalar)
      target_compile_definitions(${objects} PRIVATE HWY_COMPILE_ONLY_STATIC)
    endif()
    target_compile_options(${objects} PRIVATE ${RASTERLAB_SIMD_FLAGS_${simd}} -ffp-contract=off
                           # Symbols that are unique in a process can't be made local.
                           $<$<CXX_COMPILER_ID:GNU>:-fno-gnu-unique>)
    set(merged "${CMAKE_CURRENT_BINARY_DIR}/${objects}.o")
    add_custom_command(
      OUTPUT "${merged}"
      COMMAND "${RASTERLAB_LD}" -r --force-group-allocation -o "${merged}.all" "$<TARGET_OBJECTS:${objects}>"
      COMMAND "${CMAKE_OBJCOPY}" --wildcard "--keep-global-symbol=*simd_${simd}*" "${merged}.all" "${merged}"
      DEPENDS ${objects} "$<TARGET_OBJECTS:${objects}>"
      COMMAND_EXPAND_LISTS VERBATIM)
    set_source_files_properties("${merged}" PROPERTIES EXTERNAL_OBJECT TRUE GENERATED TRUE)
    target_sources(${target} PRIVATE "${merged}")
  endforeach()
endfunction()
