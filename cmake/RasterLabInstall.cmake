# The library for other projects: find_package(RasterLab), then link RasterLab::common.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(package "${CMAKE_INSTALL_LIBDIR}/cmake/RasterLab")
target_include_directories(common PUBLIC "$<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/rasterlab>")
set(libraries rasterlab_options rasterlab_openmesh rasterlab_highway rasterlab_backward opencv_core
    opencv_imgproc)
install(TARGETS common ${libraries} EXPORT RasterLabTargets ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}/rasterlab")
install(EXPORT RasterLabTargets NAMESPACE RasterLab:: DESTINATION "${package}")
install(
  DIRECTORY "${PROJECT_SOURCE_DIR}/common" "${PROJECT_BINARY_DIR}/generated/common"
  DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/rasterlab"
  FILES_MATCHING
  PATTERN "*.h"
  PATTERN "*.inl")
configure_package_config_file("${PROJECT_SOURCE_DIR}/cmake/RasterLabConfig.cmake.in"
                              "${PROJECT_BINARY_DIR}/RasterLabConfig.cmake" INSTALL_DESTINATION "${package}")
write_basic_package_version_file("${PROJECT_BINARY_DIR}/RasterLabConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/RasterLabConfig.cmake" "${PROJECT_BINARY_DIR}/RasterLabConfigVersion.cmake"
              "${PROJECT_SOURCE_DIR}/cmake/RasterLabSimd.cmake" DESTINATION "${package}")
