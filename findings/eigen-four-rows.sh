#!/bin/sh
# Eigen 3.4.0 (Debian libeigen3-dev 3.4.0-4), g++ 12 (Debian g++-12 12.2.0-14+deb12u1): the generalized eigenvalues of symmetric
# matrices of four rows bring along the blocked product of great matrices, whatever the type says of their size. With the rows
# bounded by four, or fixed at four, hardly less is compiled than for matrices of any size: some hundred kilobytes, which take
# g++ some eight times as long as reading the headers. One call of a compiled library (GSL's gsl_eigen_gensymmv) does the same.
#
# The guess: a matrix whose size is known, or bounded, when it is compiled gets short unrolled loops; a great matrix's blocks,
# packing and kernels are left out. So one writes the bound to have less compiled, and nothing changes. They are reached by
# a condition on the size that is asked when the program runs, and so are compiled for sizes at which it never holds.
#
#> rows         functions of the blocked product   kB of code
#> any number   9                                  more than 90
#> at most 4    9                                  more than 90
#> 4            8                                  more than 90
. "$(dirname "$0")/room.sh"
debian g++-12=12.2.0-14+deb12u1 libeigen3-dev=3.4.0-4
cat >"$room/ask" <<'S'
asked() { # rows, type
  {
    echo '#include <Eigen/Eigenvalues>'
    echo "using Square = $2;"
    echo 'double least(const Square& pull, const Square& mass)'
    echo '{'
    echo '  return Eigen::GeneralizedSelfAdjointEigenSolver<Square>(pull, mass, Eigen::EigenvaluesOnly).eigenvalues()[0];'
    echo '}'
  } >modes.cpp
  g++-12 -std=c++20 -O2 -isystem /usr/include/eigen3 -c modes.cpp
  product=$(nm -C modes.o | grep -c 'gebp_kernel\|gemm_pack\|general_matrix_matrix')
  kilobytes=$(size modes.o | awk 'END { print int($1 / 1000) }')
  printf '%-12s %-34s %s\n' "$1" "$product" "$([ "$kilobytes" -gt 90 ] && echo 'more than 90' || echo "$kilobytes")"
}
printf '%-12s %-34s %s\n' rows 'functions of the blocked product' 'kB of code'
asked 'any number' Eigen::MatrixXd
asked 'at most 4' 'Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 4, 4>'
asked 4 Eigen::Matrix4d
S
in_room bash ask >"$room/seen"
as_seen "$room/seen"
