# FLINT as the imported target FLINT::FLINT; the library ships no package file of its own before version 3.
find_library(FLINT_LIBRARY flint)
find_path(FLINT_INCLUDE_DIR flint/flint.h)
mark_as_advanced(FLINT_LIBRARY FLINT_INCLUDE_DIR)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(FLINT REQUIRED_VARS FLINT_LIBRARY FLINT_INCLUDE_DIR)

if(FLINT_FOUND AND NOT TARGET FLINT::FLINT)
  add_library(FLINT::FLINT UNKNOWN IMPORTED)
  set_target_properties(FLINT::FLINT PROPERTIES IMPORTED_LOCATION "${FLINT_LIBRARY}" INTERFACE_INCLUDE_DIRECTORIES
                                                                                      "${FLINT_INCLUDE_DIR}")
endif()
