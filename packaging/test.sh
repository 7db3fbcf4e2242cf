#!/usr/bin/env bash
# test.sh [PRESET]: installs what is missing, builds and runs all tests. PRESET is release (as
# without), dev, sanitize-address or sanitize-thread.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
preset=${1:-release}

"$root/packaging/install_packages.sh" build run test
cd "$root"
cmake --preset "$preset" -DHANEI_TESTS=ON >/dev/null
cmake --build --preset "$preset"
result=0
report=$root/build/$preset/tests.xml
ctest --preset "$preset" --parallel "$(nproc)" --output-junit "$report" || result=$?

# One closing line: every test that ran, counted from CTest's own report.
count() { grep -m1 -oE "[[:space:]]$1=\"[0-9]+\"" "$report" | grep -oE '[0-9]+'; }
total=$(count tests); failed=$(count failures); skipped=$(($(count skipped) + $(count disabled)))
echo "$((total - failed - skipped)) passed, $failed failed, $skipped skipped"
exit "$result"
