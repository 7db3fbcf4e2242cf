#!/bin/bash
# The real window, used with real mouse and key events on a screen of its own: drags a luminaire,
# sees the illuminance change, undoes it, exports a picture, measures the idle window, quits.
#
#     smoke.sh PROGRAM PROJECT
#
# Ends with 0 when all of it worked, 1 when not, 77 when there is nothing to run it on.
set -u
program=$1
project=$2
luminaire="Ceiling panel 1"
point="point Desk A, beside the terminal"
patience=180   # s for any one answer: the machine may be busy with other tests

for tool in Xvfb xdotool; do
    if ! command -v $tool >/dev/null; then
        echo "skipped: $tool is not installed"
        exit 77
    fi
done

folder=$(mktemp -d)
state=$folder/state.json
screen_process=
program_process=
clean_up() {
    [ -n "$program_process" ] && kill "$program_process" 2>/dev/null
    [ -n "$screen_process" ] && kill "$screen_process" 2>/dev/null
    rm -rf "$folder"
}
trap clean_up EXIT

fail() {
    echo "FAILED: $1"
    [ -f "$state" ] && sed '/"widgets"/,$d' "$state"
    [ -f "$folder/log" ] && cat "$folder/log"
    exit 1
}

# value NAME: a figure or word of the state; place NAME: the middle of a widget or object, as "x y".
value() { sed -n "s/^  \"$1\": \"\{0,1\}\([^\"]*\)\"\{0,1\},\$/\1/p" "$state"; }
place() {
    sed -n "s/^    \"$1\": \[\(.*\)\],\{0,1\}\$/\1/p" "$state" | tail -1 |
        awk -F', ' '{ if (NF == 4) printf "%d %d", ($1 + $3) / 2, ($2 + $4) / 2; else printf "%d %d", $1, $2 }'
}
# wait_for WHAT COMMAND...: until the command succeeds.
wait_for() {
    local what=$1
    shift
    for ((k = 0; k < patience * 10; ++k)); do
        "$@" && return 0
        kill -0 "$program_process" 2>/dev/null || [ "$what" = "the end" ] || fail "the program ended while waiting for $what"
        sleep 0.1
    done
    fail "waited $patience s in vain for $what"
}
settled() { [ -f "$state" ] && [ "$(value settled)" = true ]; }
is() { [ "$(value "$1")" = "$2" ]; }
ended() { ! kill -0 "$program_process" 2>/dev/null; }
ticks() { awk '{ print $14 + $15 }' "/proc/$program_process/stat"; }

mkfifo "$folder/display"
Xvfb -displayfd 3 -screen 0 1400x900x24 -noreset -nolisten tcp 3>"$folder/display" 2>/dev/null &
screen_process=$!
read -r -t 30 number <"$folder/display" || fail "the screen did not start"
export DISPLAY=:$number

cp "$project" "$folder/room.hanei"
"$program" --user-folder "$folder/user" --state-file "$state" --size 1280x800 "$folder/room.hanei" >"$folder/log" 2>&1 &
program_process=$!
wait_for "the first answer" settled
lux=$(value "$point")
[ -n "$lux" ] || fail "no figure for $point"
echo "lit: $point $lux lx, first answer after $(value 'answer ms') ms"

read -r x y <<<"$(place "$luminaire")"
xdotool mousemove "$x" "$y" click 1
wait_for "the choice of $luminaire" is selected "$luminaire"
read -r x y <<<"$(place "$luminaire")"
xdotool mousemove "$x" "$y" mousedown 1
for step in 10 20 30 40 50 60; do xdotool mousemove $((x + step)) $((y + step / 4)); done
xdotool mouseup 1
wait_for "the step of the drag" is "undo depth" 1
wait_for "the answer to the drag" settled
moved=$(value "$point")
[ "$moved" != "$lux" ] || fail "the dragged luminaire changed nothing"
echo "dragged: $moved lx, answer $(value 'answer ms') ms after release"

sleep 1
before=$(ticks)
sleep 10
idle=$(($(ticks) - before))
echo "idle: $idle ticks of $(getconf CLK_TCK) a second in 10 s"
[ "$idle" -le 5 ] || fail "an idle window used $idle ticks in 10 s"

xdotool key ctrl+z
wait_for "undo" is "undo depth" 0
wait_for "the answer to undo" settled
[ "$(value "$point")" = "$lux" ] || fail "after undo $(value "$point") lx, before $lux lx"
echo "undone: the same figure to the last digit"

xdotool key ctrl+e
wait_for "the export dialog" grep -q '"export.accept"' "$state"
xdotool key Return
picture="room view total $(date +%F).png"
wait_for "the picture" test -s "$folder/$picture"
wait_for "the message" is message "Exported $picture"
echo "exported: $(stat -c '%s bytes' "$folder/$picture")"

xdotool key ctrl+q
wait_for "the end" ended
wait "$program_process"
code=$?
program_process=
[ $code -eq 0 ] || fail "the program ended with $code"
echo "passed"
