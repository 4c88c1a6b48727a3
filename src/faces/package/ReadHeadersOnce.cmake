# Two thirds of a build's time go into the same few headers. Who builds everything from nothing, as CI does, precompiles
# them and compiles the files of a wing as one. Who changes a file is better off without, above all with a compiler cache;
# and those builds see to it that each file includes what it needs.
option(SLIPPROOF_READ_HEADERS_ONCE "Precompile common headers and compile the files of a wing as one" OFF)

function(slipproof_precompile target)  # slipproof_precompile(TARGET [HEADER...]): those and the common ones
  if(SLIPPROOF_READ_HEADERS_ONCE)
    target_precompile_headers(
      ${target} PRIVATE <flint/fmpq.h> <algorithm> <array> <filesystem> <fstream> <functional> <map>
      <memory> <optional> <random> <set> <sstream> <string> <string_view> <utility> <vector> ${ARGN})
  endif()
endfunction()

# After the target has all its sources: those without a group of their own are compiled as one.
function(slipproof_unity target)
  if(SLIPPROOF_READ_HEADERS_ONCE)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
    get_target_property(sources ${target} SOURCES)
    foreach(source IN LISTS sources)
      get_source_file_property(group ${source} TARGET_DIRECTORY ${target} UNITY_GROUP)
      if(NOT group)
        set_source_files_properties(${source} TARGET_DIRECTORY ${target} PROPERTIES UNITY_GROUP ${target})
      endif()
    endforeach()
  endif()
endfunction()
