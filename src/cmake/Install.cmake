# cmake --install: headers, library, and the package that gives find_package(slipproof) the target slipproof::slipproof.
# Programs install themselves where they are built.
include(CMakePackageConfigHelpers)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/slipproof)

install(TARGETS slipproof EXPORT slipproof)
install(
  DIRECTORY ${PROJECT_SOURCE_DIR}/src/
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/slipproof
  FILES_MATCHING
  PATTERN "*.hpp"
  PATTERN "cli" EXCLUDE
  PATTERN "check" EXCLUDE)
install(EXPORT slipproof NAMESPACE slipproof:: FILE slipproofTargets.cmake DESTINATION ${package_dir})

configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/slipproofConfig.cmake.in
                              ${PROJECT_BINARY_DIR}/slipproofConfig.cmake INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/slipproofConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/slipproofConfig.cmake ${PROJECT_BINARY_DIR}/slipproofConfigVersion.cmake
              ${CMAKE_CURRENT_LIST_DIR}/FindFLINT.cmake DESTINATION ${package_dir})
