# cpack -G DEB: slipproof, libslipproof0, libslipproof-dev and, where the Python module is built, python3-slipproof.
# Libraries go to lib, or with -D CMAKE_INSTALL_PREFIX=/usr, as Debian has it, to its folder for this architecture.
set(SLIPPROOF_MAINTAINER "the slipproof authors <authors@slipproof.example>"
    CACHE STRING "Who answers for Debian packages made here: NAME <ADDRESS>")
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME slipproof)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")  # each package has its own
set(CPACK_PACKAGE_CONTACT "${SLIPPROOF_MAINTAINER}")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ
                                                WORLD_EXECUTE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS_POLICY ">=")
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

get_cmake_property(components COMPONENTS)
set(CPACK_COMPONENTS_ALL program library development)
set(what "exact, provable answers about dry friction")
set(more "With dry friction a pushed bicycle, block or mechanism may have one motion,
several, or none. slipproof solves every case in exact arithmetic, checks what
papers and solvers say, and proves thresholds with certificates.
.
")

# slipproof_package(COMPONENT PACKAGE SECTION KIND TEXT): KIND is behind the synopsis, TEXT the last paragraph.
macro(slipproof_package component package section kind text)
  string(TOUPPER ${component} key)
  set(CPACK_DEBIAN_${key}_PACKAGE_NAME ${package})
  set(CPACK_DEBIAN_${key}_PACKAGE_SECTION ${section})
  set(CPACK_DEBIAN_${key}_DESCRIPTION "${what}${kind}\n${more}${text}")
  install(FILES ${PROJECT_BINARY_DIR}/package/copyright ${PROJECT_BINARY_DIR}/package/changelog.gz
          DESTINATION share/doc/${package} COMPONENT ${component} EXCLUDE_FROM_ALL)
endmacro()
slipproof_package(program slipproof science "" "This package has the programs, papers with their proofs, and mechanisms.")
slipproof_package(library libslipproof${PROJECT_VERSION_MAJOR} libs " (library)" "This package has the shared library of the C interface.")
file(CONFIGURE OUTPUT package/triggers CONTENT "activate-noawait ldconfig\n")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_CONTROL_EXTRA ${PROJECT_BINARY_DIR}/package/triggers)
slipproof_package(development libslipproof-dev libdevel " (development)"
                  "This package has slipproof.h, slipproof_record.h for engines to record\ntheir steps with, and the C++ library with its headers.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libslipproof${PROJECT_VERSION_MAJOR} (= ${PROJECT_VERSION})")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_RECOMMENDS
    "libgmp-dev, libmpfr-dev, libflint-dev, libfmt-dev, libtbb-dev, libpugixml-dev, libmd-dev, libudunits2-dev, libhdf5-dev, coinor-libclp-dev")
if(python IN_LIST components)
  list(APPEND CPACK_COMPONENTS_ALL python)
  slipproof_package(python python3-slipproof python " (Python)" "This package has the module for Python.")
  find_package(Python3 REQUIRED COMPONENTS Interpreter)  # a module is of one minor version
  math(EXPR next_minor "${Python3_VERSION_MINOR} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
      "python3 (>= 3.${Python3_VERSION_MINOR}~), python3 (<< 3.${next_minor}), python3-numpy")
  # What Python compiles beside a package belongs to no package: it is made at once, and cleaned away before removal.
  file(CONFIGURE OUTPUT package/postinst CONTENT "#!/bin/sh\nset -e\npy3compile -p python3-slipproof\n")
  file(CONFIGURE OUTPUT package/prerm CONTENT "#!/bin/sh\nset -e\npy3clean -p python3-slipproof\n")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA
      ${PROJECT_BINARY_DIR}/package/postinst ${PROJECT_BINARY_DIR}/package/prerm)
endif()

# A native package's changelog, in Debian's form; SOURCE_DATE_EPOCH makes it the same again.
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
set(changelog "slipproof (${PROJECT_VERSION}) unstable; urgency=medium\n\n  * As CHANGELOG.md of the sources tells.\n\n -- ${SLIPPROOF_MAINTAINER}  ${date}\n")
file(CONFIGURE OUTPUT package/changelog CONTENT "${changelog}" @ONLY)
execute_process(COMMAND gzip -9nfk ${PROJECT_BINARY_DIR}/package/changelog COMMAND_ERROR_IS_FATAL ANY)
configure_file(${PROJECT_SOURCE_DIR}/LICENSE package/copyright COPYONLY)
include(CPack)
