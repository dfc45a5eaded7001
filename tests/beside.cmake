# The libraries for a build beside another (EDITION_BESIDE): another processor, compiler or C++ library than the distribution's
# packages are compiled for. Of these the headers are taken; GSL's parts are compiled here, like the edition itself without
# fused products, which the distribution's own GSL has where every processor has them.
enable_language(C)
include(book/live/libraries.cmake)
fetch_sources(libgsl-dev)
if(NOT fetched)
  message(FATAL_ERROR "GSL's sources could not be fetched")
endif()
set(headers ${CMAKE_BINARY_DIR}/include)
link_headers(${headers})
foreach(library Boost::headers Eigen3::Eigen doctest::doctest CLI11::CLI11 nlohmann_json::nlohmann_json fmt::fmt GSL::gsl GSL::gslcblas)
  add_library(${library} INTERFACE IMPORTED)
  target_include_directories(${library} SYSTEM INTERFACE ${headers})
endforeach()
target_compile_definitions(fmt::fmt INTERFACE FMT_HEADER_ONLY)

set(gsl ${EDITION_LIVE_SOURCES}/gsl)
list(TRANSFORM gsl_parts PREPEND ${gsl}/ OUTPUT_VARIABLE parts)
list(TRANSFORM parts APPEND .c)
add_library(gsl STATIC ${parts})
target_compile_options(gsl PRIVATE -w -O2 -ffp-contract=off $<$<C_COMPILER_ID:Clang>:${unfolded}>)
target_compile_definitions(gsl PRIVATE HAVE_CONFIG_H)
target_include_directories(gsl PRIVATE ${PROJECT_SOURCE_DIR}/book/live/gsl ${gsl})
target_include_directories(gsl SYSTEM PRIVATE ${headers})
target_link_libraries(gsl PRIVATE m)
target_link_libraries(GSL::gsl INTERFACE gsl)
# Much of its linear algebra calls what no section calls, and what is not compiled here.
target_link_options(GSL::gsl INTERFACE -Wl,--allow-shlib-undefined,-z,lazy)
