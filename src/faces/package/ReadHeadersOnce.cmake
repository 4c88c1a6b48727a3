# Two thirds of a build's time go into the same few headers. Who builds everything from nothing, as CI does, precompiles
# them and compiles the files of a wing as one. Who changes a file is better off without, above all with a compiler cache;
# and those builds see to it that each file includes what it needs.
option(SLIPPROOF_READ_HEADERS_ONCE "Precompile common headers and compile the files of a wing as one" OFF)

# GCC spends a sixth of its time looking for memory to use again; below a gigabyte it need not.
if(SLIPPROOF_READ_HEADERS_ONCE AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  add_compile_options(--param=ggc-min-heapsize=1048576)
endif()

# gold, which Debian's binutils have, links programs in less than half the time of the usual linker. Of shared libraries
# it keeps the names of what is local.
find_program(SLIPPROOF_GOLD ld.gold)
if(SLIPPROOF_READ_HEADERS_ONCE AND SLIPPROOF_GOLD AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  string(APPEND CMAKE_EXE_LINKER_FLAGS " -fuse-ld=gold")
endif()

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

# Leaves in a list what has no options of its own. CMake's own way to join files leaves out every file that has some.
function(slipproof_without_options list)
  set(left "")
  foreach(source IN LISTS ${list})
    set(own "")
    foreach(property IN ITEMS COMPILE_OPTIONS COMPILE_DEFINITIONS HEADER_FILE_ONLY)
      get_source_file_property(value ${source} ${property})
      if(value)
        list(APPEND own ${property})
      endif()
    endforeach()
    if(NOT own)
      list(APPEND left ${source})
    endif()
  endforeach()
  set(${list} ${left} PARENT_SCOPE)
endfunction()

function(slipproof_join target name)  # slipproof_join(TARGET NAME FILES...): compiles them as NAME.cpp
  set_source_files_properties(${ARGN} PROPERTIES HEADER_FILE_ONLY ON)
  list(TRANSFORM ARGN REPLACE "(.+)" "#include \"\\1\"\n" OUTPUT_VARIABLE text)
  list(JOIN text "" text)
  file(CONFIGURE OUTPUT ${name}.cpp CONTENT "${text}" @ONLY)
  target_sources(${target} PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp)
endfunction()
