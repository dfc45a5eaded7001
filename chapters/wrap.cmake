# Writes WRAPPER, the file that is compiled for SECTION, say pendulum/s09.cpp: the section's includes, and then the section
# in the namespace pendulum_09. SECTION() must name the file's own place. Writes OPTIONS too, with which it is compiled besides:
# RACING tells by its text a section that races ways.
cmake_minimum_required(VERSION 3.22)
string(REGEX MATCH "^([a-z]+)/s(0?([0-9]+))\\.cpp$" place "${SECTION}")
set(chapter ${CMAKE_MATCH_1})
set(scope ${CMAKE_MATCH_1}_${CMAKE_MATCH_2})
set(number ${CMAKE_MATCH_3})

file(READ ${SECTION} text)
set(text "\n${text}")
string(REGEX MATCH "\nSECTION\\([^\n]*" named "${text}")
if(NOT named MATCHES "^\nSECTION\\(${chapter}, ${number}, \"")
  string(STRIP "${named}" named)
  message(FATAL_ERROR " chapters/${SECTION}: says \"${named}\"; allowed: SECTION(${chapter}, ${number}, \"...\")")
endif()

string(REGEX MATCHALL "\n#include[^\n]*" includes "${text}")
list(JOIN includes "" includes)
string(STRIP "${includes}" includes)
file(WRITE ${WRAPPER}
  "${includes}\n\nnamespace ${scope}\n{\n#include \"${SECTION}\"  // NOLINT(bugprone-suspicious-include)\n}\n")

if(text MATCHES "${RACING}")
  file(WRITE ${OPTIONS} "-O2\n")
else()
  file(WRITE ${OPTIONS} "\n")
endif()
