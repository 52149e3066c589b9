#!/bin/sh
# The command line as people meet it: exit status, what is printed where, and what is left behind. cli.sh FROND DATA
# shellcheck source=tests/cli/case.sh
. "$(dirname "$0")/case.sh"
data=$second

prints() { # a line of stdout
    grep -qxF -- "$1" out.txt || fail "$last: stdout lacks: $1"
}

quiet() { # nothing on stderr
    [ ! -s err.txt ] || fail "$last: stderr is not empty"
}

absent() {
    [ ! -e "$1" ] || fail "$last: left $1 behind"
}

present() {
    [ -s "$1" ] || fail "$last: did not make $1"
}

# Help and version: on stdout, status 0.
for command in run render replay check explain devices grow bolt; do
    expect 0 "$command" --help
    quiet
    head -n 1 out.txt | grep -q "^usage: frond $command" || fail "$last: no usage"
    ! grep '{[a-z]*}' out.txt || fail "$last: names an option that there is none of"
done
expect 0 replay --help
grep -q ' a print: 1 to 16 pixels a cell ' out.txt || fail "$last: does not say what --scale allows"
expect 0 --help
quiet
expect 0 --version
prints "frond 0.1.0"
quiet

# Usage: on stderr, status 2, nothing on stdout.
expect 2
grep -q '^frond: no command; one of ' err.txt || fail "$last: the list of commands is missing"
expect 2 rendr
grep -q "^frond: unknown command 'rendr'; did you mean render? One of " err.txt || fail "$last: no suggestion"
expect 2 render
says "frond render: no script is given; see frond render --help"
expect 2 render a.yaml
says "frond render: no picture is asked for: -o FILE.png; see frond render --help"
expect 2 render a.yaml b.yaml -o a.png
says "frond render: one script at a time; see frond render --help"
expect 2 render a.yaml -o
says "frond render: -o: a value is missing; see frond render --help"
expect 2 render a.yaml --output
says "frond render: --output: a value is missing; see frond render --help"
expect 2 render a.yaml -o a.png --siez 3
says "frond render: --siez: unknown option; see frond render --help"
expect 2 render a.yaml -o a.png -x
says "frond render: -x: unknown option; see frond render --help"
expect 2 render a.yaml -o a.png --size 0x5
says "frond render: --size: '0x5' is not it; WxH, each 1 to 16384 pixels"
expect 2 render a.yaml -o a.png --size 5x5x5
says "frond render: --size: '5x5x5' is not it; WxH, each 1 to 16384 pixels"
expect 2 render a.yaml -o a.png --every 0
says "frond render: --every: '0' is not it; 1 to 10000000 ticks"
expect 2 render a.yaml -o a.png --seed -1
says "frond render: --seed: '-1' is not it; 0 to 2147483647"
expect 2 render a.yaml -o a.png --threads 999
says "frond render: --threads: '999' is not it; 1 to 64"
expect 2 render a.yaml -o a.png --ticks " 5"
says "frond render: --ticks: ' 5' is not it; 0 to 10000000 ticks"
expect 2 check
says "frond check: no script is given; see frond check --help"
expect 2 explain a b
says "frond explain: one key at a time; see frond explain --help"
expect 2 explain alpa_a
grep -q "^frond explain: nothing is called 'alpa_a'; did you mean alpha_a? One of " err.txt || fail "$last: no suggestion"

# check: all problems, status 1, and nothing to say of what is right.
cp "$data"/sessions/*.yaml .
expect 0 check one-drop.yaml two-drops.yaml guided.yaml
quiet
expect 0 check "$data"/../../config/sessions/*.yaml # those that ship
quiet
printf 'frond: 1\nactions:\n  - {tick: 0, drop: {at: [0.5, 2], radius: 5000}}\n' >bad.yaml
problems="bad.yaml:3:32: actions[0].drop.at[1]: 2 is out of range; 0 to 1 of the sheet
bad.yaml:3:44: actions[0].drop.radius: 5000 is out of range; 0.5 to 512 cells"
expect 1 check one-drop.yaml bad.yaml two-drops.yaml
says "$problems"
expect 1 check no-such.yaml
says "no-such.yaml: cannot be read: No such file or directory"
printf 'exhibit: 1\nscenes:\n  - {id: a}\n  - {id: b, inputs: [{from: a, as: mask}]}\n' >empty.yaml
expect 0 check empty.yaml # it can be shown
grep -q "^empty.yaml:4:22: scenes\[1\].inputs\[0\].from: warning: " err.txt || fail "$last: no warning"

# A wrong script leaves no file behind.
expect 1 render bad.yaml -o bad.png --stats bad.json --fields bad.exr --frames bad
says "$problems"
absent bad.png
absent bad.json
absent bad.exr
absent bad
expect 1 render one-drop.yaml -o nowhere/a.png
says "frond render: nowhere/a.png: its folder is not there"
expect 1 render one-drop.yaml -o .
says "frond render: .: is a folder; the name of a file is needed"

# Pictures stay in the script's folder.
mkdir inside outside
printf 'secret' >outside/a.png
ln -s ../outside/a.png inside/link.png
for path in ../outside/a.png /etc/hostname link.png; do
    printf 'frond: 1\nactions:\n  - {tick: 0, mask: {picture: %s}}\n' "$path" >inside/s.yaml
    expect 1 check inside/s.yaml
    says "inside/s.yaml:3:31: actions[0].mask.picture: '$path' leads out of this file's folder; a picture lies in it or below"
done
printf 'frond: 1\nactions:\n  - {tick: 0, mask: {picture: no.png}}\n' >inside/s.yaml
expect 1 check inside/s.yaml
says "inside/s.yaml:3:31: actions[0].mask.picture: 'no.png' is not there; a picture in this file's folder or below"
printf 'text' >inside/text.png
printf 'frond: 1\nactions:\n  - {tick: 0, mask: {picture: text.png}}\n' >inside/s.yaml
expect 1 check inside/s.yaml
grep -q "^inside/s.yaml:3:31: actions\[0\].mask.picture: 'text.png' .*not a picture" err.txt || fail "$last: no reason"

# A session, quietly: the picture, frames, figures; the same for any number of threads, with sleep or without.
expect 0 render one-drop.yaml -o a.png --size 64x48 --ticks 60 --frames frames --every 25 --stats a.json --threads 1
quiet
present a.png
present frames/000025.png
present frames/000050.png
absent frames/000060.png
grep -q '"ticks": 60,' a.json || fail "$last: the figures lack the ticks"
grep -q '"pattern.carved": {' a.json || fail "$last: the figures lack a field"
[ "$(od -An -tu1 -j16 -N8 a.png | tr -s ' ')" = " 0 0 0 64 0 0 0 48" ] || fail "$last: the picture is not 64x48"
expect 0 render one-drop.yaml -o b.png --size 64x48 --ticks 60 --stats b.json --threads 2 --dense
cmp -s a.json b.json || fail "$last: threads and sleep change the figures"
cmp -s a.png b.png || fail "$last: threads and sleep change the picture"
expect 0 render one-drop.yaml -o c.png --ticks 60 --seed 5 --stats c.json --fields c.exr
[ "$(od -An -tx1 -N4 c.exr | tr -d ' ')" = 762f3101 ] || fail "$last: c.exr is no EXR"
for name in pattern.catalyst pattern.active pattern.carved solvent.density ink.density; do
    grep -aq "$name" c.exr || fail "$last: c.exr lacks $name"
done
cmp -s a.json c.json && fail "$last: another seed is the same painting"

# The branches, for a pen.
expect 0 render one-drop.yaml --svg d.svg --paper 150 --ticks 300
quiet
grep -q '^<svg xmlns="http://www.w3.org/2000/svg" width="150mm" ' d.svg || fail "$last: d.svg is not 150 mm wide"
grep -q '^<path stroke-width=' d.svg || fail "$last: d.svg has no branch"
expect 0 render one-drop.yaml --svg e.svg --paper 150 --ticks 300 --threads 2
cmp -s d.svg e.svg || fail "$last: threads change the branches"
expect 2 render one-drop.yaml --svg f.svg --paper 9
says "frond render: --paper: '9' is not it; 10 to 5000 mm"
absent f.svg
expect 1 render one-drop.yaml --svg nowhere/f.svg
says "frond render: nowhere/f.svg: its folder is not there"

# A picture guides a painting.
cp a.png inside/text.png
printf 'frond: 1\ncanvas: {width: 32, height: 32}\nticks: 2\nactions:\n  - {tick: 0, guide: {picture: text.png}}\n' >inside/s.yaml
expect 0 render inside/s.yaml -o d.png
present d.png

# run: a session to out/, two pixels a cell, and six pictures of how it grew; their paths on stdout.
printf 'frond: 1\ncanvas: {width: 32, height: 24}\nticks: 12\n' >small.yaml
expect 0 run small.yaml --display none
quiet
prints "out/small.png"
prints "out/small-growth/"
present out/small.png
[ "$(od -An -tu1 -j16 -N8 out/small.png | tr -s ' ')" = " 0 0 0 64 0 0 0 48" ] || fail "$last: not two pixels a cell"
for tick in 02 04 06 08 10 12; do
    present "out/small-growth/0000$tick.png"
done
absent out/small-growth/000001.png

# explain: every key with its range.
expect 0 explain drop.radius
prints "  radius (number; 0.5 to 512 cells; default 8)"
expect 0 explain
for word in frond canvas alpha_a brush_solvent "  moss" "  ochre" "  reef"; do
    grep -q -- "$word" out.txt || fail "$last: lacks $word"
done
expect 0 explain graph "$data"/../../config/exhibits/cracked-glaze.yaml
prints "  ├─ dark ──▶ mask of glaze: growth keeps to it"
expect 0 explain graph "$data"/../../config/exhibits/cracked-glaze.yaml --dot
prints '  "cracks" -> "glaze" [taillabel = "dark", headlabel = "mask"];'
expect 2 explain graph
says "frond explain graph: no exhibit is given; see frond explain --help"
expect 2 explain clear --json
says "frond explain: --json and --dot are for graph EXHIBIT; see frond explain --help"
printf 'exhibit: 1\nsheet: {cells: 16384}\nscenes: [{id: a, opening: [{drop: {at: [0.5, 0.5], ink: cobalt}}]}]\n' >fed.yaml
expect 2 render fed.yaml --scene b -o fed.png
says "frond render: --scene: no scene is called 'b'; one of a"
expect 0 render fed.yaml --scene a --ticks 20 -o fed.png
quiet
expect 0 explain clear
prints "clear: A fresh sheet."

expect 0 explain inputs
for word in "^inputs: " "^bindings: " "^  debounce" "two-finger drag" "^turn: "; do
    grep -q "$word" out.txt || fail "$last: lacks $word"
done
grep -q "^drop:" out.txt && fail "$last: more than inputs"
expect 0 explain bindings.ms
prints "  ms (whole number; 1 to 60000 ms; default 600)"

# Inputs files: known by their key, checked like scripts, alone and with a session.
expect 0 check "$data"/../../config/inputs/*.yaml
quiet
printf 'inputs: 1\nbindings:\n  - {touch: tap, drop: {radius: 0}}\n' >inputs.yaml
expect 1 check one-drop.yaml inputs.yaml
says "inputs.yaml:3:33: bindings[0].drop.radius: 0 is out of range; 0.5 to 512 cells"
expect 1 run small.yaml --display headless --frames 2 --inputs inputs.yaml
says "inputs.yaml:3:33: bindings[0].drop.radius: 0 is out of range; 0.5 to 512 cells"
printf 'inputs: 1\nbindings:\n  - {touch: tap, drop: {ink: carbon black}}\n' >inputs.yaml
expect 0 check inputs.yaml
quiet
printf 'frond: 1\ncanvas: {width: 32, height: 24}\nticks: 12\ninks: [cyan]\n' >cyan.yaml
expect 1 run cyan.yaml --display headless --frames 2 --inputs inputs.yaml
says "inputs.yaml:3:30: bindings[0].drop.ink: 'carbon black' is not among the session's inks; one of cyan"

# Exhibits: the shipped ones, with their recorded sessions, are right.
expect 0 check "$data"/../../config/exhibits/*.yaml "$data"/../../config/exhibits/sessions/*.yaml
quiet
printf 'exhibit: 1\n' >exhibit.yaml
expect 0 check exhibit.yaml
quiet

# All that is wrong with one, in the order of the file: its scenes, sessions and pictures too.
mkdir -p exhibit/stock
cp a.png exhibit/stock/good.png
printf 'text' >exhibit/stock/text.png
printf 'frond: 1\nactions:\n  - {tick: 0, drop: {at: [0.5, 2]}}\n' >exhibit/session.yaml
cat >exhibit/e.yaml <<'END'
exhibit: 1
titel: {en: Frost}
sheet: {cells: 345600, seed: -1}
scenes:
  - {id: dawn, palette: reaf, guide: ../a.png}
  - {id: dawn, mask: stock/no.png}
pictures: stock
sessions: [session.yaml, no.yaml]
seats:
  - {zone: [0, 0, 0.6, 1], ink: black}
  - {zone: [0.5, 0, 1, 1]}
inputs:
  bindings:
    - {button: red, drop: {}}
schedule:
  - {days: mon-fri, open: 9, close: "18:00"}
END
expect 1 check exhibit/e.yaml
says "exhibit/e.yaml:2:1: titel: unknown key; did you mean title? One of exhibit, title, display, sheet, engine, languages, texts, palettes, scenes, pictures, sessions, palette, seats, inputs, visit, access, schedule, wake, gallery, staff, mqtt
exhibit/e.yaml:3:30: sheet.seed: -1 is out of range; 0 to 2147483647
exhibit/e.yaml:5:25: scenes[0].palette: unknown palette 'reaf'; did you mean reef? One of reef, garden, dusk, earth, press, harbour, kingfisher, lantern
exhibit/e.yaml:5:38: scenes[0].guide: '../a.png' leads out of this file's folder; a picture lies in it or below
exhibit/e.yaml:6:10: scenes[1].id: 'dawn' is there already; another word
exhibit/e.yaml:6:22: scenes[1].mask: 'stock/no.png' is not there; a picture in this file's folder or below
exhibit/e.yaml:7:11: pictures: 'stock/text.png' not a picture that Frond reads (PNG, JPEG, TIFF, EXR, WebP); a PNG, JPEG, TIFF, EXR or WebP picture
exhibit/e.yaml:8:12: sessions[0]: session.yaml:3:32: actions[0].drop.at[1]: 2 is out of range; 0 to 1 of the sheet
exhibit/e.yaml:8:26: sessions[1]: 'no.yaml' is not there; a session in this file's folder or below
exhibit/e.yaml:10:33: seats[0].ink: 'black' is not among the first scene's inks; one of phthalo turquoise, quinacridone magenta, ochre, cobalt blue
exhibit/e.yaml:11:12: seats[1].zone: overlaps that of seats[0]; zones that share nothing but edges
exhibit/e.yaml:14:16: inputs.bindings[0].button: unknown button 'red'; there are none in gpio.buttons
exhibit/e.yaml:16:27: schedule[0].open: '9' is no time; a time of day, 0:00 to 24:00"
printf 'exhibit: 1\nscenes:\n  - {id: dawn, guide: stock/good.png, mask: stock/good.png}\n' >exhibit/e.yaml
expect 0 check exhibit/e.yaml
quiet

# A bomb: references are refused before anything grows.
printf 'exhibit: 1\na: &a [x]\nscenes: [*a, *a, *a]\n' >exhibit.yaml
expect 1 check exhibit.yaml
grep -qxF "exhibit.yaml:3:11: an alias; write the value out" err.txt || fail "$last: no alias"
yes '#' | head -c 1100000 >exhibit.yaml
expect 1 check exhibit.yaml
says "exhibit.yaml: the file is larger than 1 MiB; a script is at most 1 MiB"

expect 0 explain exhibit
for word in "^exhibit: " "^display: " "^scenes: " "^  opacity" "^staff: "; do
    grep -q "$word" out.txt || fail "$last: lacks $word"
done
grep -q "^drop:" out.txt && fail "$last: more than exhibits"
expect 0 explain palette.target
prints "  target (number; 15 to 60 mm; default 18)"
expect 0 explain visit
prints "visit: How long everything takes."
prints "  idle (number; 5 to 3600 s; default 60)"
expect 2 explain visti
grep -q "^frond explain: nothing is called 'visti'; did you mean visit? One of " err.txt || fail "$last: no suggestion"

# devices: without a device, without permission, and on a descriptor captured elsewhere.
expect 0 devices
grep -q "controller" out.txt || fail "$last: nothing about controllers"
expect 0 devices --watch --seconds 1
expect 2 devices --seconds 1
says "frond devices: --seconds goes with --watch; see frond devices --help"
expect 2 devices --json
says "frond devices: --json goes with --descriptor; see frond devices --help"
expect 2 devices --watch --seconds 0
says "frond devices: --seconds: '0' is not it; 1 to 86400 seconds"
expect 2 devices knob
says "frond devices: 'knob' is too much; see frond devices --help"
expect 1 devices --inputs no-such.yaml
says "no-such.yaml: cannot be read: No such file or directory"
printf '05 01 09 37 a1 01 09 37 15 81 25 7f 75 08 95 01 81 06 c0' >knob.txt
expect 0 devices --descriptor knob.txt
quiet
grep -q "Dial" out.txt || fail "$last: no dial"
expect 0 devices --descriptor knob.txt --json
grep -q '"Dial"' out.txt || fail "$last: no dial"
printf '05 01 c0' >bad.txt
expect 1 devices --descriptor bad.txt
grep -q "^frond devices: bad.txt: byte 2: " err.txt || fail "$last: no byte"

# grow: usage; a dendrite and a tree from a picture of this repository, in every format.
expect 2 grow
says "frond grow: no picture is given; see frond grow --help"
expect 2 grow a.png
says "frond grow: nothing is asked for: -o FILE.png; see frond grow --help"
expect 2 grow a.png b.png -o c.png
says "frond grow: one picture at a time; see frond grow --help"
expect 2 grow a.png -o b.png --metaphor vines
grep -q "^frond grow: --metaphor: 'vines' is not it; one of ink, vine, " err.txt || fail "$last: no metaphors"
for bad in "--endpoints 0" "--endpoints 3x" "--plant 0.5" "--plant 0.5,1.5" "--random 2" "--random nan" "--blur 1,"; do
    # shellcheck disable=SC2086 # an option and its value
    expect 2 grow a.png -o b.png $bad
    grep -q "^frond grow: --[a-z]*: '.*' is not it; " err.txt || fail "$last: what is wrong is not said"
done
expect 1 grow no-such.png -o nothing.png
grep -q "^frond grow: no-such.png" err.txt || fail "$last: no file"
absent nothing.png
painting=$data/../../config/pictures/demonstration.png
expect 0 grow "$painting" -o a.png -o a.svg -o a.exr --detail 128 --endpoints 250 --plant 0.2,0.9 --plant 0.8,0.9 --stats a.json
quiet
for file in a.png a.svg a.exr; do
    present "$file"
done
grep -q '"cycles":0' a.json || fail "$last: cycles"
grep -q '"seeds":2' a.json || fail "$last: seeds"
[ "$(grep -c '^<path class="branch" ' a.svg)" -gt 100 ] || fail "$last: hardly a path"
expect 0 grow "$painting" -o b.png --tree --metaphor painted --background "$painting" --detail 160 --size 300 --stats b.json
present b.png
[ "$(grep -c '"components":1' b.json)" -eq 2 ] || fail "$last: not two whole layers"
expect 0 explain grow.endpoints
quiet

verdict
