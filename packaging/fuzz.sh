#!/usr/bin/env bash
# fuzz.sh [SECONDS] [TARGET]: fuzzes every reader of files, or one (ies, ldt, tm33, luminaire, project,
# reference, ...), for SECONDS each (600). What it learns is kept in build/fuzz/corpus for the next
# time; an input that breaks a reader is written to build/fuzz/found-TARGET-....
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
seconds=${1:-600}

"$root/packaging/install_packages.sh" build test
cmake -S "$root/tests/fuzz" -B "$root/build/fuzz" -G Ninja -DCMAKE_CXX_COMPILER=clang++-14 >/dev/null
cmake --build "$root/build/fuzz"
cd "$root/build/fuzz"
for fuzzer in read_${2:-*}; do
    [ -x "$fuzzer" ] || { echo "fuzz.sh: there is no reader ${fuzzer#read_}" >&2; exit 2; }
    target=${fuzzer#read_}
    "$root/tests/fuzz/run.sh" "$target" "./$fuzzer" "corpus/$target" "$root/../shared" \
        -max_total_time="$seconds" -print_final_stats=1
done
