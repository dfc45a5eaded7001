# Installs BUILD into a folder of its own, moves that, and lets another project find the library there; an installed program
# runs from there too.
cmake_minimum_required(VERSION 3.22)
set(there ${BUILD}/installed)
file(REMOVE_RECURSE ${there} ${there}-first)

function(must)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE said ERROR_VARIABLE said)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${ARGN}\nended with ${status}:\n${said}")
  endif()
endfunction()

must(${CMAKE_COMMAND} --install ${BUILD} --prefix ${there}-first)
file(RENAME ${there}-first ${there})
foreach(file IN ITEMS ${DOCUMENTS}/LICENSE ${LIBRARIES}/cmake/euler-on-oscillation/euler-on-oscillation-config.cmake)
  if(NOT EXISTS ${there}/${file})
    message(FATAL_ERROR "${file} is not installed")
  endif()
endforeach()
foreach(program IN ITEMS pendulum-01 pendulum-03)  # one that is a program itself, and one that is compiled together with it
  must(${CMAKE_COMMAND} -E env --unset=LD_LIBRARY_PATH ${there}/${PROGRAMS}/${program} --check)
endforeach()
must(${CMAKE_COMMAND} -S ${CONSUMER} -B ${there}/consumer -G ${GENERATOR} -DCMAKE_PREFIX_PATH=${there}
  -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_CXX_FLAGS=${FLAGS})
must(${CMAKE_COMMAND} --build ${there}/consumer)
must(${there}/consumer/consumer)
file(REMOVE_RECURSE ${there})
