#!/usr/bin/env bash
# run.sh TARGET FUZZER CORPUS SHARED OPTION...: gives the fuzzer of a reader everything found so far and
# all files of its formats as they are, then lets it change them as libFuzzer's options say. CORPUS is
# a folder for inputs that reach new code; "-" forgets them, so that a run repeats. 77: no fuzzer.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
target=$1 fuzzer=$2 corpus=$3 shared=$4
shift 4
[ -x "$fuzzer" ] || { echo "skipped: $fuzzer is not built; it needs clang++-14 and its libFuzzer"; exit 77; }

case $target in
    ies | ldt) names=(-name "*.$target") ;;
    gldf) names=(-name '*.gldf' -o -name product.xml) ;;
    tm33) names=(-name '*.xml') ;;
    luminaire) names=(-name '*.ies' -o -name '*.ldt' -o -name '*.xml') ;;
    project) names=(-name '*.hanei') ;;
    reference) names=(-path '*/reference/*.json') ;;
    measured) names=(-path '*/measured/*.csv') ;;
    gltf) names=(-name '*.gltf' -o -name '*.glb') ;;
    *) echo "run.sh: $target is no reader" >&2; exit 2 ;;
esac
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
places=()
for place in "$here/found/$target" "$here/seeds" "$here/../golden" "$here/../../assets" "$shared"; do
    if [ -d "$place" ]; then places+=("$(realpath "$place")"); fi
done
find "${places[@]}" -type f \( -path "*/found/$target/*" -o "${names[@]}" \) | LC_ALL=C sort >"$scratch/files"

export UBSAN_OPTIONS=print_stacktrace=1
quietly() { "$@" >"$scratch/log" 2>&1 || { tail -n 60 "$scratch/log"; exit 1; }; }
quietly xargs -d '\n' -a "$scratch/files" "$fuzzer" -timeout=20
paste -sd, "$scratch/files" >"$scratch/seeds"
if [ "$corpus" = - ]; then corpus=$scratch/corpus; fi
mkdir -p "$corpus"
quietly "$fuzzer" -timeout=10 -malloc_limit_mb=64 -max_len=16384 -dict="$here/words/$target.dict" \
    -seed_inputs="@$scratch/seeds" -artifact_prefix="found-$target-" "$@" "$corpus"
echo "$target: $(wc -l <"$scratch/files") files, $(grep -a '^Done' "$scratch/log")"
