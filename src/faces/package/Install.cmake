# cmake --install: headers, libraries, and the package that gives find_package(slipproof) the targets slipproof::slipproof
# (C++, static) and slipproof::c (slipproof.h, shared); slipproof.pc is the latter for pkg-config.
# Programs install themselves where they are built.
include(CMakePackageConfigHelpers)
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME development)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/slipproof)

install(TARGETS slipproof EXPORT slipproof)
# slipproof.hpp lists the public headers; they are installed with what they include. They include each other there as
# <slipproof/...>, so that they need no folder of their own on the search path.
file(CONFIGURE OUTPUT InstallHeaders.cmake @ONLY CONTENT [=[
file(REMOVE_RECURSE "@PROJECT_BINARY_DIR@/installed-headers")
set(headers slipproof.hpp)
set(written "")
while(headers)
  list(POP_FRONT headers header)
  list(APPEND written ${header})
  file(READ "@PROJECT_SOURCE_DIR@/src/${header}" text)
  string(REGEX MATCHALL "#include \"[^\"]+" included "${text}")
  list(TRANSFORM included REPLACE "#include \"" "")
  list(APPEND headers ${included})
  list(REMOVE_DUPLICATES headers)
  list(REMOVE_ITEM headers ${written})
  string(REGEX REPLACE "#include \"([^\"]+)\"" "#include <slipproof/\\1>" text "${text}")
  file(WRITE "@PROJECT_BINARY_DIR@/installed-headers/${header}" "${text}")
endwhile()
]=])
install(SCRIPT ${CMAKE_CURRENT_BINARY_DIR}/InstallHeaders.cmake)
install(DIRECTORY ${PROJECT_BINARY_DIR}/installed-headers/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/slipproof)
install(
  TARGETS slipproof_c EXPORT slipproof_c
  LIBRARY COMPONENT library NAMELINK_COMPONENT development)
install(FILES ${PROJECT_SOURCE_DIR}/src/faces/c_interface/slipproof.h ${PROJECT_SOURCE_DIR}/src/faces/c_interface/slipproof_record.h
        DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT slipproof_c NAMESPACE slipproof:: FILE slipproofCTargets.cmake DESTINATION ${package_dir})
cmake_path(RELATIVE_PATH CMAKE_INSTALL_FULL_INCLUDEDIR BASE_DIRECTORY ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig
           OUTPUT_VARIABLE include_dir_from_pc)
configure_file(${CMAKE_CURRENT_LIST_DIR}/slipproof.pc.in ${PROJECT_BINARY_DIR}/slipproof.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/slipproof.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
install(EXPORT slipproof NAMESPACE slipproof:: FILE slipproofTargets.cmake DESTINATION ${package_dir})

get_target_property(linked slipproof LINK_LIBRARIES)
set(optional_libraries "")
if(PkgConfig::hdf5 IN_LIST linked)
  string(APPEND optional_libraries " hdf5")
endif()
set(find_clp "")
if(Clp::Clp IN_LIST linked)
  set(find_clp "find_dependency(Clp)")
endif()
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/slipproofConfig.cmake.in
                              ${PROJECT_BINARY_DIR}/slipproofConfig.cmake INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/slipproofConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/slipproofConfig.cmake ${PROJECT_BINARY_DIR}/slipproofConfigVersion.cmake
              ${CMAKE_CURRENT_LIST_DIR}/FindFLINT.cmake ${CMAKE_CURRENT_LIST_DIR}/FindClp.cmake DESTINATION ${package_dir})
