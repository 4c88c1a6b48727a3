# Half of a build's time goes into the same few headers. Without a compiler cache they are read once; with one, its keys
# work better on the files themselves. What a file needs it includes all the same: the builds with a cache see to that.
if(SLIPPROOF_CCACHE)
  set(precompile_default OFF)
else()
  set(precompile_default ON)
endif()
option(SLIPPROOF_PRECOMPILE "Precompile the headers that most files include" ${precompile_default})

function(slipproof_precompile target)  # slipproof_precompile(TARGET [HEADER...]): those and the common ones
  if(SLIPPROOF_PRECOMPILE)
    target_precompile_headers(
      ${target} PRIVATE <boost/multiprecision/gmp.hpp> <algorithm> <array> <filesystem> <fstream> <functional> <map>
      <memory> <optional> <random> <set> <sstream> <string> <string_view> <utility> <vector> ${ARGN})
  endif()
endfunction()
