# Writes, for each of the SECTIONS, say pendulum/s09.cpp, what is compiled for it: a file of the same name in the folder INTO,
# with the section's includes, and then the section in the namespace pendulum_09. SECTION() must name the file's own place.
# Writes OPTIONS too, with which they are compiled besides: RACING tells by its text a section that races ways.
cmake_minimum_required(VERSION 3.22)
set(options "")
foreach(section IN LISTS SECTIONS)
  string(REGEX MATCH "^([a-z]+)/s(0?([0-9]+))\\.cpp$" place "${section}")
  set(chapter ${CMAKE_MATCH_1})
  set(scope ${CMAKE_MATCH_1}_${CMAKE_MATCH_2})
  set(number ${CMAKE_MATCH_3})

  file(READ ${section} text)
  set(text "\n${text}")
  string(REGEX MATCH "\nSECTION\\([^\n]*" named "${text}")
  if(NOT named MATCHES "^\nSECTION\\(${chapter}, ${number}, \"")
    string(STRIP "${named}" named)
    message(FATAL_ERROR " chapters/${section}: says \"${named}\"; allowed: SECTION(${chapter}, ${number}, \"...\")")
  endif()

  string(REGEX MATCHALL "\n#include[^\n]*" includes "${text}")
  list(JOIN includes "" includes)
  string(STRIP "${includes}" includes)
  file(WRITE ${INTO}/${section}
    "${includes}\n\nnamespace ${scope}\n{\n#include \"${section}\"  // NOLINT(bugprone-suspicious-include)\n}\n")
  if(text MATCHES "${RACING}")
    set(options "-O2")
  endif()
endforeach()
file(WRITE ${OPTIONS} "${options}\n")
