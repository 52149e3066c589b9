#!/bin/sh
# frond replay as people meet it: what it paints again, what it says, what it leaves behind. replay.sh FROND DATA
# shellcheck source=tests/cli/case.sh
. "$(dirname "$0")/case.sh"
data=$second

# A session and its journal are one painting, to the bit.
expect 0 render "$data/sessions/small.yaml" -o a.png --stats a.json --journal a.frond
expect 0 replay a.frond -o b.png --stats b.json --threads 3
says ""
cmp -s a.json b.json || fail "$last: other figures than the session's"
cmp -s a.png b.png || fail "$last: another picture than the session's"

# A print, and pictures on the way.
expect 0 replay a.frond -o print.png --scale 4 --frames frames --every 25 --size 80x60
says ""
[ "$(size_of print.png)" = 640x480 ] || fail "$last: the print has $(size_of print.png) pixels"
[ "$(cd frames && echo *)" = "000025.png 000050.png 000060.png" ] || fail "$last: other frames"
[ "$(size_of frames/000025.png)" = 80x60 ] || fail "$last: frames of $(size_of frames/000025.png) pixels"

# So are those that grow something over a picture, at any size, and on the way.
expect 0 render "$data/sessions/trees.yaml" -o trees.png --size 320x240 --frames grown --every 30 --journal trees.frond
says ""
expect 0 replay trees.frond -o again.png --size 320x240 --frames regrown --every 30
says ""
cmp -s trees.png again.png || fail "$last: another picture than the session's"
cmp -s grown/000030.png regrown/000030.png || fail "$last: another frame than the session's"
cmp -s grown/000060.png grown/000090.png && fail "$last: nothing grows"
sed '/stock:/d; /plant:/d; /tend:/d; /undo:/d; /redo:/d; /hold:/d; /shape:/d' "$data/sessions/trees.yaml" >bare.yaml
expect 0 render bare.yaml -o bare.png --size 320x240
cmp -s trees.png bare.png && fail "$last: nothing lies over the painting"
expect 0 replay trees.frond -o trees-print.png --scale 4
[ "$(size_of trees-print.png)" = 640x480 ] || fail "$last: the print has $(size_of trees-print.png) pixels"

# And chemistry: words, pictures and strokes, its figures, and its channels beside the painting's.
expect 0 render "$data/sessions/chemistry.yaml" -o dish.png --stats dish.json --fields dish.exr --frames reacts --every 45 \
    --journal dish.frond
says ""
expect 0 replay dish.frond -o again.png --stats again.json --frames reacts-again --every 45
says ""
cmp -s dish.png again.png || fail "$last: another picture than the session's"
cmp -s dish.json again.json || fail "$last: other figures than the session's"
cmp -s reacts/000045.png reacts-again/000045.png || fail "$last: another frame than the session's"
cmp -s reacts/000045.png reacts/000090.png && fail "$last: nothing reacts"
grep -q '"class": "w' dish.json || fail "$last: it is neither worms nor waves: $(grep '"class"' dish.json)"
for channel in chemistry.u chemistry.v chemistry.along.x chemistry.dark; do
    grep -q "$channel" dish.exr || fail "$last: no channel $channel"
done
sed '/react:/d; /dose:/d; /style:/d' "$data/sessions/chemistry.yaml" >bare.yaml
expect 0 render bare.yaml -o bare.png --stats bare.json
cmp -s dish.png bare.png && fail "$last: nothing lies over the painting"
grep -q '"scenes"' bare.json && fail "$last: a scene without any"

cat >bolt.yaml <<'YAML'
frond: 1
canvas: {width: 160, height: 120}
ticks: 40
actions:
  - {tick: 0, strike: {at: [0.5, 0.8]}}
YAML
expect 0 render bolt.yaml -o bolt.png --stats bolt.json --fields bolt.exr
grep -q '"bolts": 1,' bolt.json || fail "$last: no bolt is counted: $(cat bolt.json)"
grep -q 'lightning.around' bolt.exr || fail "$last: no channel of the potential"

# A torn journal is played up to the tear, and says so; other files are refused in a line.
head -c -9 a.frond >torn.frond
expect 0 replay torn.frond -o torn.png
grep -q '^frond replay: torn.frond: it is torn, and played up to there: byte [0-9]*: the record is cut short$' err.txt ||
    fail "$last: the tear is not told"
expect 1 replay "$data/sessions/small.yaml" -o c.png
says "frond replay: the journal: it is no journal of Frond"
expect 1 replay nowhere.frond -o c.png
says "frond replay: nowhere.frond: there is no such file or folder"
{ head -c 8 a.frond && printf '\002\000' && tail -c +11 a.frond; } >later.frond
expect 1 replay later.frond -o c.png
says "frond replay: the journal: the journal is of version 2.0; this Frond (0.1.0) reads version 1"
[ ! -e c.png ] || fail "$last: left a picture behind"

# A plan of the branches.
expect 0 replay a.frond --svg plan.svg --paper 150
grep -q '<svg .*width="150' plan.svg || fail "$last: no plan 150 mm wide"
expect 2 replay a.frond --svg plan.svg --paper 9
says "frond replay: --paper: '9' is not it; 10 to 5000 mm"

# The command line.
expect 2 replay
says "frond replay: no journal is given; see frond replay --help"
expect 2 replay a.frond
says "frond replay: nothing is asked for: -o FILE.png, or another; see frond replay --help"
expect 2 replay a.frond -o a.png --scale 17
says "frond replay: --scale: '17' is not it; 1 to 16"
expect 1 replay a.frond --video film.avi
says "frond replay: film.avi: the name of a film ends in .mp4 or .webm"

# A film, where ffmpeg is; without, a line. Nothing is left of one that could not be made.
PATH=/nowhere expect 1 replay a.frond --video film.mp4
says "frond replay: ffmpeg: is not installed"
if command -v ffmpeg >/dev/null; then
    for film in film.mp4 film.webm; do
        expect 0 replay a.frond --video "$film" --every 2 --size 81x61
        says ""
        ffprobe -v error -count_frames -select_streams v -show_entries stream=width,height,nb_read_frames -of csv=p=0 \
            "$film" >probe.txt 2>&1
        [ "$(cat probe.txt)" = 80,60,30 ] || fail "$last: $(cat probe.txt)"
    done
    mkdir shut
    expect 1 replay a.frond --video shut/../missing/film.mp4
    says "frond replay: shut/../missing/film.mp4: its folder is not there"
else
    echo "no ffmpeg: films are not tested"
fi
[ -z "$(find . -name '*.part*')" ] || fail "a part of a film is left"

verdict
