# Fast-math is refused however it is asked for: by the configuration, and for a consumer of the headers by the compiler.
function(refused_by_configuration name option)
  file(REMOVE_RECURSE "${SCRATCH}/build")
  execute_process(
    COMMAND ${ARGN} ${CMAKE_COMMAND} -S ${PROJECT} -B ${SCRATCH}/build -D CMAKE_CXX_COMPILER=${COMPILER} ${name}
    RESULT_VARIABLE result OUTPUT_QUIET ERROR_VARIABLE errors)
  if(result EQUAL 0 OR NOT errors MATCHES "do not hold under ${option}: remove it")
    message(FATAL_ERROR "${ARGN} cmake ${name} was not refused because of ${option}: ${result}\n${errors}")
  endif()
endfunction()
refused_by_configuration("-DCMAKE_CXX_FLAGS=-march=native -ffast-math" -ffast-math)
refused_by_configuration("-DCMAKE_CXX_FLAGS_RELEASE=-Ofast" -Ofast)
refused_by_configuration("-DCMAKE_BUILD_TYPE=Release" -freciprocal-math env CXXFLAGS=-freciprocal-math)

function(compiles expected)
  execute_process(
    COMMAND ${COMPILER} -std=c++20 -fsyntax-only ${ARGN} -I ${PROJECT}/src -x c++ ${PROJECT}/src/base/number/rational.hpp
    RESULT_VARIABLE result ERROR_VARIABLE errors)
  if(expected AND NOT result EQUAL 0)
    message(FATAL_ERROR "number/rational.hpp does not compile with ${ARGN}:\n${errors}")
  elseif(NOT expected AND (result EQUAL 0 OR NOT errors MATCHES "compile without fast-math"))
    message(FATAL_ERROR "number/rational.hpp was not refused with ${ARGN}: ${result}\n${errors}")
  endif()
endfunction()
compiles(TRUE -O2)
compiles(FALSE -O2 -ffast-math)
compiles(FALSE -O2 -ffinite-math-only)
