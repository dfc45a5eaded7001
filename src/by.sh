#!/bin/sh
# by.sh OTHER COMPILER OPTIONS...: a compilation by the OTHER compiler.
other=$1
shift 2
exec "$other" "$@"
