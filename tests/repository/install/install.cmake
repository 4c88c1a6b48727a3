# Installs the build to a stage, moves the stage, and builds and runs a consumer that knows nothing but the stage.
file(REMOVE_RECURSE ${SCRATCH}/stage ${SCRATCH}/moved ${SCRATCH}/consumer)
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${ARGN}: ${result}\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

run(${CMAKE_COMMAND} --install ${BUILD} --config ${CONFIG} --prefix ${SCRATCH}/stage)
file(RENAME ${SCRATCH}/stage ${SCRATCH}/moved)

run(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/consumer -B ${SCRATCH}/consumer -D CMAKE_CXX_COMPILER=${COMPILER}
    -D CMAKE_PREFIX_PATH=${SCRATCH}/moved -D CMAKE_BUILD_TYPE=Release -D EXPECTED_VERSION=${VERSION})
run(${CMAKE_COMMAND} --build ${SCRATCH}/consumer)
run(${SCRATCH}/consumer/consumer)
if(NOT output STREQUAL "scene.toml:3:7: sigma is 1/4\n")
  message(FATAL_ERROR "the consumer printed: ${output}")
endif()

# What is installed is the public headers and what they include, and nothing else.
run(${COMPILER} -std=c++20 -M -I ${SCRATCH}/moved/include ${CMAKE_CURRENT_LIST_DIR}/consumer/main.cpp)
string(REGEX MATCHALL "${SCRATCH}/moved/include/slipproof/[^ \n]+" included "${output}")
file(GLOB_RECURSE installed ${SCRATCH}/moved/include/slipproof/*)
list(REMOVE_ITEM installed ${included})
if(installed)
  message(FATAL_ERROR "installed, but no public header includes it: ${installed}")
endif()
file(STRINGS ${SCRATCH}/moved/include/slipproof/slipproof.hpp public REGEX "^#include <slipproof/")
list(LENGTH public public)
if(public GREATER 18)
  message(FATAL_ERROR "slipproof.hpp lists ${public} public headers, expected at most 18: what no page or example uses stays private")
endif()

# The same from C, by CMake and by pkg-config: a scene that names a shipped mechanism.
set(scene ${SCRATCH}/moved/share/slipproof/cases/mechanisms/scenes/block-on-incline.toml)
function(expect_motions)
  run(${ARGN} ${scene})
  if(NOT output STREQUAL "stick/stick with ax = 0\nslip+/slip+ with ax = 2943/2500\n")
    message(FATAL_ERROR "${ARGN} printed: ${output}")
  endif()
endfunction()
expect_motions(${SCRATCH}/consumer/consumer_c)
set(ENV{PKG_CONFIG_PATH} ${SCRATCH}/moved/${LIBDIR}/pkgconfig)
run(sh -c "cc -std=c99 $(pkg-config --cflags slipproof) -o ${SCRATCH}/with_pc ${CMAKE_CURRENT_LIST_DIR}/consumer/main.c $(pkg-config --libs slipproof)")
expect_motions(${CMAKE_COMMAND} -E env LD_LIBRARY_PATH=${SCRATCH}/moved/${LIBDIR} ${SCRATCH}/with_pc)

# The program finds what was installed with it, and not the sources: it complains of what is spoiled there.
run(${SCRATCH}/moved/bin/slipproof verify --only A5.1 --samples 20)
file(APPEND ${SCRATCH}/moved/share/slipproof/proofs/rozenblat-yashin/claims.toml "spoiled")
execute_process(COMMAND ${SCRATCH}/moved/bin/slipproof verify --only A5.1 RESULT_VARIABLE result ERROR_VARIABLE output)
string(FIND "${output}" "${SCRATCH}/moved/share/slipproof/proofs/rozenblat-yashin/claims.toml:" place)
if(NOT result EQUAL 3 OR NOT place EQUAL 0)
  message(FATAL_ERROR "spoiled claims beside the program: ${result}\n${output}")
endif()

# The installed checker accepts the installed proofs.
run(${SCRATCH}/moved/bin/slipproof-check ${SCRATCH}/moved/share/slipproof/proofs)
if(NOT output MATCHES "\ns ACCEPTED [1-9][0-9]* accepted, 0 rejected, 0 missing, 0 undecided, 0 unreadable\n$")
  message(FATAL_ERROR "the installed checker ends with: ${output}")
endif()

run(${SCRATCH}/moved/bin/slipproof --version)
if(NOT output STREQUAL "slipproof ${VERSION}\n")
  message(FATAL_ERROR "the installed program printed: ${output}")
endif()
