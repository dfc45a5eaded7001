# Lets a section's program speak, and keeps it in TOLD: NAME.txt, NAME.json, its data, NAME.check.json.
cmake_minimum_required(VERSION 3.22)
function(hear file)
  execute_process(COMMAND ${PROGRAM} ${ARGN} OUTPUT_FILE ${TOLD}/${file} RESULT_VARIABLE status)
  # A check that fails is told as failing.
  if(NOT status EQUAL 0 AND NOT (status EQUAL 1 AND "--check" IN_LIST ARGN))
    message(FATAL_ERROR "${NAME} ${ARGN} ended with ${status}")
  endif()
endfunction()

file(MAKE_DIRECTORY ${TOLD})
file(GLOB old ${TOLD}/${NAME}.*)
if(old)
  file(REMOVE ${old})
endif()
hear(${NAME}.txt)
hear(${NAME}.json --json)
hear(${NAME}.files --data ${TOLD})
hear(${NAME}.check.json --check --json)
