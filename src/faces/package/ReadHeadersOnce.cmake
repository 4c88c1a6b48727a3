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

function(slipproof_unity target)  # all its files are compiled as one
  if(SLIPPROOF_READ_HEADERS_ONCE)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 0)
  endif()
endfunction()
