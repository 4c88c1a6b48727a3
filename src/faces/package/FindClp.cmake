# Clp as the imported target Clp::Clp; its package file for pkg-config asks for more than one needs.
find_library(CLP_LIBRARY Clp)
find_library(COINUTILS_LIBRARY CoinUtils)
find_path(CLP_INCLUDE_DIR coin/ClpSimplex.hpp)
mark_as_advanced(CLP_LIBRARY COINUTILS_LIBRARY CLP_INCLUDE_DIR)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Clp REQUIRED_VARS CLP_LIBRARY COINUTILS_LIBRARY CLP_INCLUDE_DIR)

if(CLP_FOUND AND NOT TARGET Clp::Clp)
  add_library(Clp::Clp UNKNOWN IMPORTED)
  set_target_properties(
    Clp::Clp PROPERTIES IMPORTED_LOCATION "${CLP_LIBRARY}" INTERFACE_LINK_LIBRARIES "${COINUTILS_LIBRARY}"
                        INTERFACE_INCLUDE_DIRECTORIES "${CLP_INCLUDE_DIR}")
endif()
