# An overlay port: `vcpkg install slipproof --overlay-ports=src/faces/package/vcpkg` builds the sources in which it stands.
# vcpkg has no udunits: it comes from the system (Debian: libudunits2-dev).
get_filename_component(SOURCE_PATH "${CMAKE_CURRENT_LIST_DIR}/../../../.." ABSOLUTE)

vcpkg_check_features(OUT_FEATURE_OPTIONS features FEATURES clp SLIPPROOF_CLP hdf5 SLIPPROOF_HDF5)
vcpkg_cmake_configure(
  SOURCE_PATH "${SOURCE_PATH}"
  OPTIONS -D SLIPPROOF_TESTS=OFF -D SLIPPROOF_BENCHMARKS=OFF -D SLIPPROOF_PYTHON=OFF -D SLIPPROOF_VERIFIED=OFF
          -D SLIPPROOF_WARNINGS_AS_ERRORS=OFF ${features})
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(CONFIG_PATH lib/cmake/slipproof)
vcpkg_fixup_pkgconfig()
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/bin" "${CURRENT_PACKAGES_DIR}/debug/include"
     "${CURRENT_PACKAGES_DIR}/debug/share")
set(VCPKG_POLICY_ALLOW_EXES_IN_BIN enabled)  # they find papers and cases beside bin
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")
