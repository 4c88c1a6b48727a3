# Two thirds of a build's time go into the same few headers. Without a compiler cache they are precompiled, and the files of
# a folder are compiled as one; with one, its keys work better on the files themselves. What a file needs it includes all
# the same: the builds with a cache see to that.
if(SLIPPROOF_CCACHE)
  set(read_once OFF)
else()
  set(read_once ON)
endif()
option(SLIPPROOF_PRECOMPILE "Precompile the headers that most files include" ${read_once})
option(SLIPPROOF_UNITY "Compile the files of a folder as one" ${read_once})

function(slipproof_precompile target)  # slipproof_precompile(TARGET [HEADER...]): those and the common ones
  if(SLIPPROOF_PRECOMPILE)
    target_precompile_headers(
      ${target} PRIVATE <boost/multiprecision/gmp.hpp> <algorithm> <array> <filesystem> <fstream> <functional> <map>
      <memory> <optional> <random> <set> <sstream> <string> <string_view> <utility> <vector> ${ARGN})
  endif()
endfunction()

function(slipproof_unity target)  # after the target has all its sources
  if(SLIPPROOF_UNITY)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
    get_target_property(sources ${target} SOURCES)
    foreach(source IN LISTS sources)
      cmake_path(ABSOLUTE_PATH source NORMALIZE OUTPUT_VARIABLE path)
      cmake_path(GET path PARENT_PATH folder)
      cmake_path(GET folder FILENAME group)
      set_source_files_properties(${source} TARGET_DIRECTORY ${target} PROPERTIES UNITY_GROUP ${group})
    endforeach()
  endif()
endfunction()
