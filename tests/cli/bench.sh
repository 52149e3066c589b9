#!/bin/sh
# frond bench: what it is asked for and what it tells, as text and as JSON. The quickest of them stands for all. bench.sh FROND
# shellcheck source=tests/cli/case.sh
. "$(dirname "$0")/case.sh"

expect 2 bench nonsense
says "frond bench: no bench 'nonsense'; one of painting, gpu, trees, growth, chemistry, scenes"
expect 2 bench chemistry growth
[ ! -s out.txt ] || fail "$last: begins all the same"

expect 0 bench chemistry --json
says ""
# Each figure has a name of its own, a value above zero and a unit.
python3 - out.txt <<'PYTHON' || fail "$last: not what --help promises"
import json
import sys

benches = [json.loads(line) for line in open(sys.argv[1], encoding="utf-8")]
assert [bench["bench"] for bench in benches] == ["chemistry"], benches
figures = benches[0]["figures"]
assert len({figure["name"] for figure in figures}) == len(figures) >= 4, figures
assert all(figure["value"] > 0 and figure["unit"] for figure in figures), figures
value = {figure["name"]: figure["value"] for figure in figures}
plain, maps = (value[f"gray_scott_{kind}mcellsteps_per_cpu_s_1024"] for kind in ("", "maps_"))
assert maps < 2.5 * plain, figures  # maps of feed and kill cost something; the two are timed one after the other
PYTHON

verdict
