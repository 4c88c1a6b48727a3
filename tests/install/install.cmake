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

# The installed checker accepts the installed proofs.
run(${SCRATCH}/moved/bin/slipproof-check ${SCRATCH}/moved/share/slipproof/proofs)
if(NOT output MATCHES "\ns ACCEPTED [1-9][0-9]* accepted, 0 rejected, 0 missing, 0 undecided, 0 unreadable\n$")
  message(FATAL_ERROR "the installed checker ends with: ${output}")
endif()

run(${SCRATCH}/moved/bin/slipproof --version)
if(NOT output STREQUAL "slipproof ${VERSION}\n")
  message(FATAL_ERROR "the installed program printed: ${output}")
endif()
