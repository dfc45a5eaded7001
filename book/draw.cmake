# Draws a figure. Whatever gnuplot says is a fault: it warns of missing columns and draws on.
cmake_minimum_required(VERSION 3.22)
get_filename_component(folder ${OUT} DIRECTORY)
file(MAKE_DIRECTORY ${folder})
execute_process(
  COMMAND ${CMAKE_COMMAND} -E env LC_ALL=C.UTF-8 ${GNUPLOT} -e "data='${DATA}'; out='${OUT}'" ${SCRIPT}
  RESULT_VARIABLE status ERROR_VARIABLE said)
if(NOT status EQUAL 0 OR NOT said STREQUAL "")
  file(REMOVE ${OUT})
  string(STRIP "${said}" said)
  message(FATAL_ERROR "${SCRIPT}: ${said}")
endif()
