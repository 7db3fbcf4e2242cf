#!/usr/bin/env bash
# run.sh [PROJECT]: installs what is missing, builds, and opens the project (the start room if none
# is named) in the window. Without a display it renders the project to PNG files in ./pictures and
# prints its lux table.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
project=$(realpath "${1:-$root/assets/rooms/computer-room-panels.hanei}")

"$root/packaging/install_packages.sh" build run
cd "$root"
cmake --preset release -DHANEI_TESTS=OFF >/dev/null
cmake --build --preset release --target hanei
hanei=$root/build/release/hanei

if [ -n "${DISPLAY:-}" ] || [ -n "${WAYLAND_DISPLAY:-}" ]; then
    exec "$hanei" "$project"
fi
mkdir -p pictures
name=$(basename "$project" .hanei)
"$hanei" solve "$project"
for part in total direct four-up; do
    "$hanei" render "$project" --part "$part" --out "pictures/$name-$part.png"
    echo "pictures/$name-$part.png"
done
"$hanei" render "$project" --scale photo --out "pictures/$name-photo.png"
echo "pictures/$name-photo.png"
