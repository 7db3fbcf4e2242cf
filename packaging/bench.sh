#!/usr/bin/env bash
# bench.sh OUT.csv [FILTER]: builds a release and times kernels, shadows and whole studies into
# OUT.csv, one row a case; FILTER (a regular expression) runs only the cases whose name it matches.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
out=$(realpath -m "${1:?bench.sh OUT.csv [FILTER]}")

"$root/packaging/install_packages.sh" build test
cd "$root"
cmake --preset release -DHANEI_TESTS=ON >/dev/null
cmake --build --preset release --target hanei_bench
build/release/tests/hanei_bench --benchmark_filter="${2:-.}" --benchmark_out="$out" --benchmark_out_format=csv
