#!/usr/bin/env bash
# frontier.sh [SECONDS]: draws the README's plots of accuracy against time anew, each within so many seconds (120),
# with the program that run.sh or test.sh built. Nothing of the user's is read or written, and no room's times are
# known to the next.
set -euo pipefail
cd "$(dirname "$0")/.."
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
mkdir -p assets/frontier
for room in empty-room computer-room-panels office; do
  echo "== $room"
  XDG_STATE_HOME="$scratch/$room state" build/release/hanei study "assets/rooms/$room.hanei" --budget "${1:-120}" --out "$scratch/$room"
  cp "$scratch/$room/accuracy-time.svg" "assets/frontier/$room.svg"
done
