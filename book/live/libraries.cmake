# The libraries of the sections for another compiler than the system's own: those that are headers, and of GSL the sources.

# The sources of packages, as the distribution has them, at the version that is installed.
set(EDITION_LIVE_SOURCES ${PROJECT_SOURCE_DIR}/build/sources CACHE PATH "Where the distribution's sources of GSL and gnuplot lie")

# Fetches those of the PACKAGES that are not there; sets `fetched`.
function(fetch_sources)
  set(missing)
  foreach(package IN LISTS ARGN)
    string(REGEX REPLACE "^lib|-(dev|nox)$" "" source ${package})
    if(NOT EXISTS ${EDITION_LIVE_SOURCES}/${source})
      list(APPEND missing ${package})
    endif()
  endforeach()
  set(status 0)
  if(missing)
    message(STATUS "Fetching the sources of ${missing}")
    execute_process(COMMAND ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/fetch.sh ${EDITION_LIVE_SOURCES} ${missing}
      RESULT_VARIABLE status OUTPUT_VARIABLE said ERROR_VARIABLE said)
  endif()
  set(fetched ON PARENT_SCOPE)
  if(NOT status EQUAL 0)
    string(STRIP "${said}" said)
    message(STATUS "${said}")
    set(fetched OFF PARENT_SCOPE)
  endif()
endfunction()

# Links into FOLDER the headers of the libraries that are headers only, and GSL's, each by itself: never all of /usr/include.
function(link_headers folder)
  file(MAKE_DIRECTORY ${folder})
  foreach(header fmt/format.h nlohmann/json.hpp doctest/doctest.h boost/version.hpp gsl/gsl_math.h Eigen/Core CLI/CLI.hpp)
    get_filename_component(name ${header} DIRECTORY)
    find_path(live_${name} ${header} PATH_SUFFIXES eigen3 REQUIRED)
    file(CREATE_LINK ${live_${name}}/${name} ${folder}/${name} SYMBOLIC)
  endforeach()
endfunction()

# The parts of GSL that the sections call, and what these call.
set(gsl_parts err/error err/message err/stream err/strerror
  ode-initval2/control ode-initval2/cscal ode-initval2/cstd ode-initval2/driver ode-initval2/evolve ode-initval2/rk8pd
  ode-initval2/rkf45 ode-initval2/bsimp ode-initval2/step ode-initval2/msadams ode-initval2/msbdf
  eigen/gensymm eigen/gensymmv eigen/symm eigen/symmv linalg/cholesky linalg/householder linalg/symmtd
  linalg/lu permutation/init permutation/permutation permutation/permute blas/blas block/init
  cblas/daxpy cblas/dcopy cblas/ddot cblas/dgemm cblas/dgemv cblas/dger cblas/dnrm2 cblas/dscal cblas/dswap
  cblas/dsymm cblas/dsymv cblas/dsyr2 cblas/dsyr2k cblas/dsyrk cblas/dtrsm cblas/dtrsv
  cblas/idamax cblas/xerbla vector/init vector/vector vector/copy vector/oper vector/subvector vector/swap vector/view
  matrix/init matrix/matrix matrix/copy matrix/oper matrix/rowcol matrix/submatrix matrix/swap matrix/view
  integration/glfixed integration/fixed integration/legendre integration/qags integration/qag integration/workspace
  integration/qk integration/qk15 integration/qk21 integration/qk31 integration/qk41 integration/qk51 integration/qk61
  sum/levin_utrunc sum/work_utrunc specfunc/ellint specfunc/elljac
  sys/infnan sys/fdiv sys/minmax sys/hypot sys/expm1 sys/log1p sys/invhyp sys/ldfrexp sys/coerce sys/prec)
