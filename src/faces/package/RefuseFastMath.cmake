# Stops the configuration when value-changing floating-point options are in force, wherever they come from.
# A consumer of the installed headers is stopped by base/number/rational.hpp.
get_directory_property(directory_options COMPILE_OPTIONS)
set(flags "$ENV{CXXFLAGS};${directory_options};${CMAKE_CXX_FLAGS}")
foreach(config DEBUG RELEASE RELWITHDEBINFO MINSIZEREL)
  string(APPEND flags ";${CMAKE_CXX_FLAGS_${config}}")
endforeach()
if(flags MATCHES "-Ofast|-f(fast-math|unsafe-math-optimizations|associative-math|reciprocal-math|finite-math-only)")
  message(FATAL_ERROR "slipproof's error bounds do not hold under ${CMAKE_MATCH_0}: remove it from the compiler flags")
endif()
