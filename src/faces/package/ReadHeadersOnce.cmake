# Two thirds of a build's time go into the same few headers. Who builds everything from nothing, as CI does, precompiles
# them and compiles the files of a folder as one. Who changes a file is better off without, above all with a compiler cache;
# and those builds see to it that each file includes what it needs.
option(SLIPPROOF_READ_HEADERS_ONCE "Precompile common headers and compile the files of a folder as one" OFF)

function(slipproof_precompile target)  # slipproof_precompile(TARGET [HEADER...]): those and the common ones
  if(SLIPPROOF_READ_HEADERS_ONCE)
    target_precompile_headers(
      ${target} PRIVATE <flint/fmpq.h> <algorithm> <array> <filesystem> <fstream> <functional> <map>
      <memory> <optional> <random> <set> <sstream> <string> <string_view> <utility> <vector> ${ARGN})
  endif()
endfunction()

function(slipproof_unity target)  # after the target has all its sources
  if(SLIPPROOF_READ_HEADERS_ONCE)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
    get_target_property(sources ${target} SOURCES)
    foreach(source IN LISTS sources)
      cmake_path(ABSOLUTE_PATH source NORMALIZE OUTPUT_VARIABLE path)
      cmake_path(GET path PARENT_PATH folder)
      cmake_path(RELATIVE_PATH folder BASE_DIRECTORY ${PROJECT_SOURCE_DIR} OUTPUT_VARIABLE group)
      string(MAKE_C_IDENTIFIER "${group}" group)
      set_source_files_properties(${source} TARGET_DIRECTORY ${target} PROPERTIES UNITY_GROUP ${group})
    endforeach()
  endif()
endfunction()
