#!/bin/sh
# frond bolt as people meet it: every output is opened and looked into. bolt.sh FROND
# shellcheck source=tests/cli/case.sh
. "$(dirname "$0")/case.sh"

says() { # how stderr begins
    grep -qF -- "frond bolt: $1" err.txt || fail "$last: stderr is not: $1"
}

# reads ARGUMENTS...: what the reader finds in a file.
reads() {
    python3 "$here/bolt_reader.py" "$@" >out.txt 2>err.txt || fail "$last: $*"
}

# Usage: option, value and range are named.
expect 0 bolt --help
for option in dimensions eta eta-end particles seed jitter method error off-grid mask eta-map outline environment \
    environment-radius attractor repulsor seed-at turn projection potential height stats frames lines trunk lsystem tropism shyness; do
    grep -q -- "--$option\b" out.txt || fail "$last: nothing about --$option"
done
expect 2 bolt
says "nothing is asked for: -o FILE.png; see frond bolt --help"
expect 2 bolt -o a.jpg
says "--output: 'a.jpg' is not it; a name that ends with .png, .svg, .obj or .ply"
expect 2 bolt -o a.png --kind lightnin
says "--kind: 'lightnin' is not it; one of lightning, tesla, "
expect 2 bolt -o a.png --eta 21
says "--eta: '21' is not it; 0 to 20"
expect 2 bolt -o a.png --particles 0
says "--particles: '0' is not it; 1 to 16000000"
expect 2 bolt -o a.png --size 9000x2
says "--size: '9000x2' is not it; WxH, each 1 to 8192 pixels"
expect 2 bolt -o a.png --colour red
says "--colour: 'red' is not it; #RRGGBB, each 00 to ff"
expect 2 bolt -o a.png --projection xyw
says "--projection: 'xyw' is not it; three different ones of xyz"
for bad in 5 1,2,3 1,2:x line:1,2 line:1,2/0,0 cylinder:0,0/0,1 cylinder:0,0/0,1/0 1,2/3,4 200000,0 1,nan 1,2: 1,2!!; do
    expect 2 bolt -o a.png --attractor $bad
    says "--attractor: '$bad' is not it; "
done
expect 2 bolt -o a.png --seed-at 1
says "--seed-at: '1' is not it; "
expect 1 bolt -o no/a.png
says "no/a.png: its folder is not there"
expect 1 bolt -o a.png --mask no.png
says "no.png: there is no such file"
[ ! -e a.png ] || fail "something was left behind"

# Every kind of output of one growth, and what they say of it.
expect 0 bolt --kind tree --particles 500 --size 240x180 --seed 4 -o a.png -o a.svg -o a.obj -o a.ply --potential p.png \
    --height h.png --stats a.json --frames film --film 3
reads png a.png 240 180 8
reads png p.png 240 180 8
reads png h.png 240 180 16
reads png film/000001.png 240 180 8
reads png film/000002.png 240 180 8
reads svg a.svg a.json
reads tubes a.obj
reads tubes a.ply
reads stats a.json 500 tree
rsvg-convert a.svg -o svg.png || fail "the SVG is not one"
reads alike a.png svg.png
reads alike a.png film/000002.png
expect 0 bolt --kind tree --particles 500 --size 240x180 --seed 4 -o b.png --turn 0.25
cmp -s a.png b.png && fail "$last: it is not turned"
expect 0 bolt --kind tree --particles 500 --size 240x180 --seed 4 -o b.png -o b.obj -o b.ply --lines
cmp -s a.png b.png || fail "$last: the same is not the same"
reads lines b.obj
reads lines b.ply

# Charges: it grows towards and away from; it is complete where it hits.
expect 0 bolt --bare --particles 600 --span 200 --eta 4 --attractor 120,0:4000 --size 100x100 -o a.png
expect 0 bolt --bare --particles 600 --span 200 --eta 4 --repulsor 120,0:4000 --size 100x100 -o b.png
reads sides a.png b.png
expect 0 bolt --bare --particles 5000 --eta 4 --span 200 --attractor "plane:0,60/0,1:2000!" --stats hit.json
grep -q '"status":"hit"' hit.json || fail "$last: it does not hit"
expect 0 bolt --bare --particles 300 --dimensions 3 --attractor "line:40,0,5/0,1,0:20" --repulsor "cylinder:-30,0/0,1/5:20!" \
    --attractor "stroke:10,10,1;40,50,1;60,0,2:4" --seed-at 0,0/4,4,4 --stats s.json
grep -q '"shape":"stroke"' s.json || fail "$last: no stroke"

# Pictures, read by the helper: a mask, its outline, eta by place, light around.
reads draw disc.png
reads draw black.png
reads draw left.png
expect 0 bolt --bare --particles 3000 --eta 1 --span 120 --mask disc.png --size 120x120 --style line -o m.png
reads within m.png
expect 0 bolt --bare --particles 1500 --eta 1 --span 120 --outline disc.png --stats o.json
expect 0 bolt --bare --particles 700 --eta 2 --eta-map disc.png --size 100x100 --span 200 -o e.png
expect 0 bolt --bare --particles 900 --eta 4 --environment left.png --environment-radius 200 --environment-strength 2 \
    --size 100x100 --span 200 -o l.png
reads sides e.png l.png

# What cannot be: a clear word, or a sensible picture.
expect 1 bolt --mask black.png -o a.png
says "black.png: no seed lies where this mask is light"
expect 1 bolt --bare --outline black.png -o a.png
says "black.png: no light meets dark in it"
expect 1 bolt --bare --particles 1 -o a.png
says "a.png: nothing has grown but a single seed"
expect 1 bolt --bare --dimensions 4 --environment left.png -o a.png
says "--environment: is for 2 and 3 dimensions, these are 4"
expect 0 bolt --bare --eta 20 --particles 300 --stats a.json
reads stats a.json 300 lightning
expect 0 bolt --bare --eta 0 --particles 300 --stats b.json
expect 0 bolt --bare --attractor 0,0:5000 --attractor 0,0:5000 --repulsor 0,0:5000 --seed-at 0,0 --seed-at 0,0 --particles 300 \
    --stats a.json
reads stats a.json 300 lightning
expect 0 bolt --bare --dimensions 4 --particles 250 --projection xyw --size 90x90 -o a.ply
reads tubes a.ply

# Plants: the same outputs; their own options, which are of no aggregate.
expect 0 bolt --lsystem bush --size 240x240 -o a.png -o a.svg -o a.obj -o a.ply --potential p.png --height h.png --stats a.json
reads png a.png 240 240 8
reads png h.png 240 240 16
reads tubes a.obj
reads tubes a.ply
reads svg a.svg a.json
grep -q '"kind":"bush"' a.json || fail "$last: no bush"
expect 0 bolt --lsystem bush --size 240x240 -o b.png
cmp -s a.png b.png || fail "$last: the same is not the same"
expect 0 bolt --lsystem tree --bare --seed-at 0,80,0 --attractor 110,-60,0:9000 --tropism 30 --size 200x200 -o a.png
expect 0 bolt --lsystem tree --bare --seed-at 0,80,0 --attractor -110,-60,0:9000 --tropism 30 --size 200x200 -o b.png
reads sides a.png b.png
expect 0 bolt --lsystem vine --steps 30 --eta 0 --orders 1 --size 120x120 -o a.png --stats a.json
grep -q '"orders":1' a.json || fail "$last: no orders"
expect 2 bolt --lsystem oak -o a.png
says "--lsystem: 'oak' is not it; one of none, tree, vine, bush, fan"
expect 2 bolt --tropism 30 -o a.png
says "--tropism: '30' is not it; it is of plants: --lsystem tree, vine, bush or fan"
expect 2 bolt --lsystem tree --dimensions 4 -o a.png
says "--dimensions: '4' is not it; 2 to 3"

verdict
