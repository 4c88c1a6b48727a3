# What the Python module of a wheel (SLIPPROOF_WHEEL) takes along, included after the libraries are found. Libraries whose
# archives are position independent become part of the module; src/faces/python/wheel/repair.py copies the others beside
# it. udunits is opened at run time if it is installed, and there is no HDF5.
# -Wno-psabi: vectors stay inside the module, so that their calling convention does not matter. -Wno-maybe-uninitialized: at
# -O2 GCC 12 gives false alarms in std::optional.
string(REPLACE "-O3" "-O2" CMAKE_CXX_FLAGS_RELEASE "${CMAKE_CXX_FLAGS_RELEASE}")
add_compile_options(-ffunction-sections -fdata-sections -Wno-psabi -Wno-maybe-uninitialized -ffile-prefix-map=${PROJECT_SOURCE_DIR}=.)
# -Bsymbolic: the archives of Debian are compiled for programs, so that their names must not be found elsewhere.
add_link_options(-Wl,--gc-sections -Wl,--exclude-libs,ALL -Wl,-Bsymbolic -Wl,--as-needed -Wl,-O1 -s)
if(SLIPPROOF_ARCHIVES)  # a folder with archives for modules; at the end of the line, in this order, each finds what it needs
  foreach(target IN ITEMS PkgConfig::gmp PkgConfig::mpfr)
    set_property(TARGET ${target} PROPERTY INTERFACE_LINK_LIBRARIES "")
  endforeach()
  foreach(library flint mpfr gmp)
    string(APPEND CMAKE_CXX_STANDARD_LIBRARIES " \"${SLIPPROOF_ARCHIVES}/lib${library}.a\"")
  endforeach()
endif()
set(SLIPPROOF_FMT fmt::fmt-header-only)
if(TARGET pugixml::static)
  set(SLIPPROOF_PUGIXML pugixml::static)
endif()
