#!/usr/bin/env bash
# Builds the fuzzers: build.sh SOURCE BUILD CLANG++. A second time it builds what changed.
set -euo pipefail
readonly source=$1 build=$2 clang=$3
cmake --preset fuzz -S "$source" -B "$build" -DCMAKE_CXX_COMPILER="$clang" -DCMAKE_C_COMPILER="${clang/++/}"
ninja -C "$build" fuzzers
