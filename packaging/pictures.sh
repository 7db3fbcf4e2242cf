#!/usr/bin/env bash
# pictures.sh: draws the README's pictures anew with the program that run.sh or test.sh built.
set -euo pipefail
cd "$(dirname "$0")/.."
hanei=build/release/hanei
"$hanei" render assets/rooms/computer-room-panels.hanei --view overview --size 1280x760 --out assets/pictures/computer-room.png
"$hanei" render assets/rooms/computer-room-panels.hanei --part four-up --out assets/pictures/computer-room-four-up.png
"$hanei" render assets/rooms/computer-room-panels.hanei --view "Under the desk" --scale photo --exact --size 1120x700 --out assets/pictures/under-the-desk.png
"$hanei" render assets/rooms/computer-room-panels.hanei --view "Under the desk" --part shadow-classes --shadow-outlines --luminaire 2 --size 1120x700 --out assets/pictures/under-the-desk-shadows.png
