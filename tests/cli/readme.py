#!/usr/bin/env python3
"""readme.py FROND ROOT: the README says what is so. Its commands run, its options are those of --help, and each of
those is used somewhere; its files are there; its lists are those of the program and of the tree."""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

FROND, ROOT = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
TEXT = (ROOT / "README.md").read_text()
NUMBERS = "nought one two three four five six seven eight nine ten eleven twelve".split()
PATIENCE = int(os.environ.get("FROND_PATIENCE", 1))  # tests/sanitized.cmake
problems = []


def check(holds, text):
    if not holds:
        problems.append(text)


def frond(*arguments, timeout=180 * PATIENCE):
    return subprocess.run([FROND, *arguments], cwd=work, capture_output=True, text=True, timeout=timeout,
                          stdin=subprocess.DEVNULL)


def blocks():
    """Indented blocks, each as its lines without the indent."""
    found, lines = [], []
    for line in TEXT.split("\n") + ["."]:
        if line.startswith("    "):
            lines.append(line[4:])
        elif lines and line:
            found.append(lines)
            lines = []
    return found


def commands():
    """What the README says people may type: whole calls of frond, without what it says of them."""
    calls = []
    for lines in blocks():
        for line in lines:
            if line.startswith("frond "):
                calls.append(re.split(r"\s{3,}", line)[0])
            elif line.startswith(" ") and calls and re.match(r"\s+\[?-", line):
                calls[-1] += " " + line.strip()
    return calls + [re.sub(r"\s+", " ", span) for span in re.findall(r"`(frond [a-z][^`]*)`", TEXT)]


# What stands for something in a call, and what it is here.
SAMPLES = {
    "EXHIBIT.yaml": "exhibit.yaml", "EXHIBIT": "exhibit.yaml", "SESSION.yaml": "session.yaml", "INPUTS.yaml": "inputs.yaml",
    "config/inputs/example.yaml": "inputs.yaml", "JOURNAL": "a.frond", "PICTURE": "picture.png", "LANDSCAPE": "picture.png",
    "DIR": "folder", "N": "3", "ID": "second", "KEY": "drop.radius", "KIND": "snow", "X,Y:CHARGE": "0.5,0.2:50",
    # Smaller than the README's.
    "1920x1080@60": "160x100@60", "1440x900": "64x48", "1440x1440": "64x48", "90": "0",
}
# What makes a call short, or puts it off the screen; True: its options alone are tried.
SHORTER = {
    "run": ["--display", "headless", "--engine", "cpu", "--frames", "3", "--mode", "160x100", "--rotate", "0"],
    "render": ["--ticks", "12", "--every", "6"], "grow": ["--size", "64", "--endpoints", "40"],
    "bolt": ["--size", "64x64", "--particles", "40", "--extent", "16"], "replay": ["--every", "6"], "devices": ["--seconds", "1"],
    "bench": True,
}


def option_groups(call):
    """A call as the words that must be there, and its groups in brackets."""
    groups = [group.split() for group in re.findall(r"\[([^\[\]]*)\]", call)]
    return re.sub(r"\[[^\[\]]*\]", " ", call).split(), groups


def sample(word):
    return SAMPLES.get(word, word.split("|")[0])


def run(call):
    words, groups = option_groups(call)
    command = words[1]
    for group in groups:
        words += group if (command, group[0]) != ("bolt", "--frames") else []  # seconds; bolt.sh has it
    if len(words) == 2 and command not in ("explain", "devices", "report"):
        return  # the command is only named
    if command == "run" and any("|" in word and "none" in word for word in words):
        words = [word.replace("kms|window|headless|none", "headless") for word in words]
    words = [sample(word.replace("kms|window|", "").replace("auto|cpu|gpu", "cpu")) for word in words]
    if "--video" in words and not shutil.which("ffmpeg"):
        words = [word for word in words if word not in ("--video", "a.mp4")]
    more = SHORTER.get(command, [])
    if command == "bolt" and "--lsystem" in words:
        more = ["--size", "64x64"]
    if command == "devices" and "--watch" not in words:
        more = []
    if more is True:
        return
    if command == "run" and "session.yaml" not in words and "exhibit.yaml" not in words:
        words.append("session.yaml" if "--inputs" in words else "exhibit.yaml")
    if command == "run" and "--frames" in words:
        more = [word for word in more if word not in ("--frames", "3")]
    if command == "report":
        words += ["--status", "."]
    if command == "render" and "--scene" in words:
        words = [word if word != "session.yaml" else "exhibit.yaml" for word in words]
    given = words[1:] + more
    done = frond(*given)
    check(done.returncode == 0, f"frond {' '.join(given)}: status {done.returncode}: {done.stderr.strip()[:300]}")
    for written in re.findall(r"\S+\.(?:png|svg|obj|ply|exr|json|frond)\b", " ".join(given)):
        check(written in SAMPLES.values() or (work / written).exists(), f"{call}: made no {written}")


def help_of(command):
    return frond(command, "--help").stdout


def check_options(calls):
    helps = {command: set(re.findall(r"--[a-z][a-z-]*", help_of(command))) for command in names}
    for call in calls:
        command = call.split()[1]
        for option in re.findall(r"--[a-z][a-z-]*", call):
            check(option in helps.get(command, ()), f"README: {call}: frond {command} --help has no {option}")
    ours = set().union(*helps.values())
    others = set(re.findall(r"--[a-z][a-z-]*", " ".join(
        (ROOT / file).read_text() for file in ("tests/run", "app/run", "app/setup.bash", "tests/kernel/machine"))))
    others |= {"--preset", "--build", "--prefix", "--install", "--now", "--keep", "--write"}  # CMake, systemctl, tests
    for option in set(re.findall(r"`(--[a-z][a-z-]*)", TEXT)):
        check(option in ours | others, f"README: nothing has an option {option}")
    used = TEXT + "".join(file.read_text(errors="replace") for folder in ("tests", "config", "app")
                          for file in (ROOT / folder).rglob("*")
                          if file.is_file() and file.suffix in (".sh", ".py", ".c", ".txt", ".in", ".yaml", ".bash", "")
                          and not file.name.startswith("command_") and file.parent.name != "stock")
    rows = set(re.findall(r"^  ([a-z_]+) \(", frond("explain").stdout, re.M))
    for command, options in helps.items():
        for option in sorted(options - {"--help"}):
            row = option[2:].replace("-", "_") in rows or command == "bolt"  # a table's own tests have each
            check(row or re.search(re.escape(option) + r"(?![a-z-])", used), f"frond {command} {option}: nobody uses it")


def check_files():
    for span in re.findall(r"`([^`\n]+)`", TEXT) + re.findall(r"\]\(([^)]+)\)", TEXT):
        for path in re.findall(r"(?:app|config|platform|shaders|sim|tests)/[\w./*-]+", span):
            if re.search(r"(^|[\s(])" + re.escape(path), span):
                check(list(ROOT.glob(path.rstrip("./").replace("NAME", "*"))), f"README: there is no {path}")
        if re.fullmatch(r"[\w*-]+\.(?:[ch]|yaml|comp|frag)", span) and "." in span:
            known = list(ROOT.glob(f"*/**/{span}")) or span == "engines.json"
            check(known, f"README: no file is called {span}")


def words_after(start, end):
    found = re.search(re.escape(start) + r"(.*?)" + re.escape(end), TEXT, re.S)
    check(found, f"README: nothing stands between '{start}' and '{end}'")
    return re.findall(r"`([a-z_]+)`", found.group(1)) if found else []


def section(heading):
    """Rows of a part of `frond explain`, with what it says of each."""
    text = frond("explain").stdout
    found = re.search(rf"^{heading}: .*\n((?:  .*\n)+)", text, re.M)
    return re.findall(r"^  (\S[^(\n]*?)(?: \(|$)", found.group(1), re.M) if found else []


def check_lists():
    verbs = re.findall(r"VERB\([A-Z_]+, (\w+)\)", (ROOT / "sim/action/verbs.h").read_text())
    check(words_after("The verbs are", "Any action may name") == verbs, "README: the verbs are " + ", ".join(verbs))
    for verb in verbs:
        check(frond("explain", verb).stdout.startswith(verb + ": "), f"frond explain {verb} says nothing of the verb")
    actions = section("do")
    said = words_after("actions every verb of a script,", "Each source")
    check(sorted(said) == sorted(actions), "README: actions beside the verbs are " + ", ".join(actions))
    exhibits = sorted(path.name for path in (ROOT / "config/exhibits").glob("*.yaml"))
    listed = re.findall(r"^\| `([\w-]+\.yaml)` \|", TEXT, re.M)
    check(sorted(listed) == exhibits, "README: exhibits are " + ", ".join(exhibits))
    brushes = re.search(r"side by side: ([a-z, ]+)\]", TEXT)
    check(brushes and brushes.group(1).split(", ") == section("brushes"), "README: brushes: " + ", ".join(section("brushes")))
    inks = len(re.findall(r"^  \S", frond("explain").stdout.split("\ninks: One")[1].split("\n", 1)[1]
                          .split("\npalettes: Four")[0], re.M))
    palettes = len(re.findall(r"^  \S", frond("explain").stdout.split("\npalettes: Four")[1].split("\n", 1)[1], re.M))
    check(f"{NUMBERS[inks].capitalize()} inks and {NUMBERS[palettes]} palettes" in TEXT,
          f"README: there are {inks} inks and {palettes} palettes")
    check(f"{NUMBERS[len(exhibits)].capitalize()} come with" in TEXT, f"README: {len(exhibits)} exhibits come with Frond")
    drawings = len(list((ROOT / "config/pictures/stock").glob("*.svg")))
    check(f"{NUMBERS[drawings]} drawings come with Frond" in TEXT, f"README: {drawings} drawings come with Frond")
    benches = re.search(r"^Benches: (.*)$", help_of("bench"), re.M).group(1).split(", ")
    check(f"frond bench [{'|'.join(benches)}]" in TEXT, "README: benches are " + ", ".join(benches))


with tempfile.TemporaryDirectory() as folder:
    work = pathlib.Path(folder)
    names = re.findall(r"^  frond ([a-z]+)", frond("--help").stdout, re.M)
    session = next("\n".join(lines) for lines in blocks() if lines[0] == "frond: 1")
    (work / "session.yaml").write_text(session + "\n")
    (work / "exhibit.yaml").write_text("exhibit: 1\nsheet: {cells: 16384}\nscenes:\n  - {id: first}\n  - {id: second, opening: "
                                       "[{drop: {at: [0.5, 0.5]}}]}\n")
    shutil.copy(ROOT / "config/inputs/example.yaml", work / "inputs.yaml")
    check(frond("grow", ROOT / "config/pictures/brushes.png", "-o", "picture.png", "--size", "64").returncode == 0,
          "no picture to grow over")
    check(frond("render", "session.yaml", "-o", "b.png", "--ticks", "12", "--journal", "a.frond").returncode == 0,
          "no journal to replay")
    calls = commands()
    check(len(calls) > 15, "README: hardly any command is found in it")
    for name in names:
        check(any(call.split()[1] == name for call in calls), f"README: nothing is said of frond {name}")
    for call in calls:
        check(call.split()[1] in names, f"README: {call}: there is no such command")
        run(call)
    check_options(calls)
    check_files()
    check_lists()
for problem in problems:
    print(problem)
sys.exit(1 if problems else 0)
