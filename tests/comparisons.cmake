# Fails where a test compares by doctest's Approx, which is absolute below one: to it 1e-9 and 2e-9 are equal. Numbers are
# compared by within_relative(), within_ulps() and the others of edition/compare.hpp, each with its reason.
cmake_minimum_required(VERSION 3.22)
file(GLOB_RECURSE files ${ROOT}/src/*.?pp ${ROOT}/chapters/*.?pp ${ROOT}/tests/*.?pp)
if(NOT files)
  message(FATAL_ERROR "no files in ${ROOT}")
endif()
foreach(file IN LISTS files)
  file(STRINGS ${file} found REGEX "(^|[^A-Za-z_])Approx[^A-Za-z_]")
  if(found)
    message(SEND_ERROR "${file}: ${found}")
  endif()
endforeach()
