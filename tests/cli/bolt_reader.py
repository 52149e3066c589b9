"""Readers of what frond bolt writes, none of them Frond's own: PNG, SVG, OBJ, PLY. Exits with what is wrong."""

import json
import math
import re
import struct
import sys
import zlib


def check(holds, text):
    if not holds:
        sys.exit(text)


def read_png(path):
    """Width, height, bits and rows of samples, a tuple a pixel."""
    data = open(path, "rb").read()
    check(data[:8] == b"\x89PNG\r\n\x1a\n", "no PNG")
    at, packed, header = 8, b"", None
    while at < len(data):
        size, kind = struct.unpack(">I4s", data[at : at + 8])
        body = data[at + 8 : at + 8 + size]
        (sum_,) = struct.unpack(">I", data[at + 8 + size : at + 12 + size])
        check(zlib.crc32(kind + body) == sum_, "a checksum is wrong")
        if kind == b"IHDR":
            header = struct.unpack(">IIBBBBB", body)
        packed += body if kind == b"IDAT" else b""
        at += 12 + size
    width, height, bits, colour, _, _, interlace = header
    check(interlace == 0, "interlaced")
    channels = {0: 1, 2: 3, 6: 4}[colour]
    step, raw = channels * bits // 8, zlib.decompress(packed)
    stride, before, rows = width * step, bytes(width * step), []
    check(len(raw) == (stride + 1) * height, "rows are missing")
    for y in range(height):
        kind = raw[y * (stride + 1)]
        row = bytearray(raw[y * (stride + 1) + 1 : (y + 1) * (stride + 1)])
        for i in range(stride):
            left = row[i - step] if i >= step else 0
            up, corner = before[i], before[i - step] if i >= step else 0
            if kind == 1:
                row[i] = (row[i] + left) & 255
            elif kind == 2:
                row[i] = (row[i] + up) & 255
            elif kind == 3:
                row[i] = (row[i] + (left + up) // 2) & 255
            elif kind == 4:
                guess = left + up - corner
                near = min((left, up, corner), key=lambda v: (abs(guess - v), (left, up, corner).index(v)))
                row[i] = (row[i] + near) & 255
        before = bytes(row)
        samples = struct.unpack(">%dH" % (stride // 2), before) if bits == 16 else before
        rows.append([tuple(samples[i : i + channels]) for i in range(0, len(samples), channels)])
    return width, height, bits, rows


def png(path, width, height, bits):
    found = read_png(path)
    check(found[:3] == (int(width), int(height), int(bits)), "it is %dx%d of %d bits" % found[:3])
    values = {pixel for row in found[3] for pixel in row}
    check(len(values) > 30, "there is hardly anything in it: %d colours" % len(values))
    if bits == "16":
        check(max(values)[0] == 65535 or max(values)[0] > 60000, "heights end at %d" % max(values)[0])
        check(any(value[0] & 255 for value in values), "there are but 8 bits in it")


def grey(path):
    """Shape and brightness beside that of the corner: what is drawn."""
    width, height, _, rows = read_png(path)
    ground = rows[0][0]
    return width, height, [[sum(abs(p[c] - ground[c]) for c in range(3)) for p in row] for row in rows]


def alike(one, other):
    """Both show the same shape: most of what one draws, the other draws too."""
    width, height, a = grey(one)
    check((width, height) == grey(other)[:2], "sizes differ")
    b = grey(other)[2]
    cells = [(y, x) for y in range(height) for x in range(width)]
    drawn = {cell for cell in cells if a[cell[0]][cell[1]] > 120}
    also = {cell for cell in cells if b[cell[0]][cell[1]] > 120}
    check(len(drawn) > 200, "hardly anything is drawn: %d" % len(drawn))
    both = len(drawn & also)
    check(both > 0.5 * min(len(drawn), len(also)), "%d and %d pixels share %d" % (len(drawn), len(also), both))


def middle(path):
    width, height, drawn = grey(path)
    sums = [sum(drawn[y][x] for y in range(height)) for x in range(width)]
    return sum(x * s for x, s in enumerate(sums)) / sum(sums) / width


def sides(east, west):
    check(middle(east) > middle(west) + 0.08, "%.2f and %.2f: not to the right" % (middle(east), middle(west)))


def within(path):
    """Nothing but faint light outside a disc of a third of the picture."""
    width, height, drawn = grey(path)
    inside = outside = 0
    for y in range(height):
        for x in range(width):
            far = math.hypot(x - width / 2, y - height / 2) / width
            inside += drawn[y][x] if far < 0.33 else 0
            outside += drawn[y][x] if far > 0.4 else 0
    check(inside > 20 * outside, "%d within, %d without" % (inside, outside))


def svg(path, stats):
    text = open(path).read()
    paths = re.findall(r'<path class="branch" [^>]*data-width="([\d.]+) ([\d.]+)" d="M([^"]*)Z"/>', text)
    branches = json.load(open(stats))["branches"]
    check(len(paths) == branches, "%d paths, %d branches" % (len(paths), branches))
    check(all(float(root) >= 0 and "L" in way for root, _, way in paths), "a path is none")
    check('class="leaf"' in text, "no leaves")


def read_obj(path):
    """Places, radii (of lines), faces, group of each face."""
    places, radii, faces, groups, group = [], [], [], [], ""
    for line in open(path):
        words = line.split()
        if not words or words[0] == "#":
            continue
        if words[0] == "v":
            places.append(tuple(map(float, words[1:])))
        elif words[0] == "vt":
            radii.append(float(words[1]))
        elif words[0] == "g":
            group = words[1]
        elif words[0] in "fl":
            faces.append([int(word.split("/")[0]) - 1 for word in words[1:]])
            groups.append(group)
        else:
            sys.exit("what is " + line)
    return places, radii, faces, groups


def read_ply(path):
    data = open(path, "rb").read()
    head, body = data.split(b"end_header\n", 1)
    lines = head.decode().split("\n")
    check(lines[:2] == ["ply", "format binary_little_endian 1.0"], "no PLY")
    count = {words[1]: int(words[2]) for words in (line.split() for line in lines) if words[:1] == ["element"]}
    places, radii, branches = [], [], []
    for i in range(count["vertex"]):
        x, y, z, radius, branch = struct.unpack_from("<ffffi", body, 20 * i)
        places.append((x, y, z))
        radii.append(radius)
        branches.append(branch)
    at, faces = 20 * count["vertex"], []
    for _ in range(count.get("face", 0)):
        check(body[at] == 3, "no triangle")
        faces.append(list(struct.unpack_from("<iii", body, at + 1)))
        at += 13
    for _ in range(count.get("edge", 0)):
        faces.append(list(struct.unpack_from("<ii", body, at)))
        at += 8
    check(at == len(body), "%d bytes are too many" % (len(body) - at))
    return places, radii, faces, [branches[face[0]] for face in faces]


def read_mesh(path):
    places, radii, faces, groups = read_ply(path) if path.endswith(".ply") else read_obj(path)
    check(places and faces, "empty")
    check(all(math.isfinite(v) for place in places for v in place), "a place is nowhere")
    check(all(0 <= v < len(places) for face in faces for v in face), "a corner is missing")
    return places, radii, faces, groups


def tubes(path):
    """Each branch is closed, of one sense, and its outside is outside."""
    places, _, faces, groups = read_mesh(path)
    edges, volumes = {}, {}
    for face, group in zip(faces, groups):
        for i in range(3):
            edge = (group, face[i], face[(i + 1) % 3])
            check(edge not in edges, "an edge has two faces of one side")
            edges[edge] = True
        (ax, ay, az), (bx, by, bz), (cx, cy, cz) = (places[v] for v in face)
        volume = ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx)
        volumes[group] = volumes.get(group, 0) + volume / 6
    check(all((group, b, a) in edges for group, a, b in edges), "a branch has a hole")
    inside_out = [group for group, volume in volumes.items() if volume < -1e-3]
    check(len(volumes) > 20 and len(inside_out) <= len(volumes) // 100, "inside out: %s" % inside_out[:9])


def lines(path):
    places, radii, faces, _ = read_mesh(path)
    check(len(radii) == len(places) and min(radii) > 0 and max(radii) > 2 * min(radii), "radii")
    check(all(len(face) == 2 for face in faces), "no lines")


def stats(path, particles, kind):
    found = json.load(open(path))
    check(found["kind"] == kind and found["particles"] == int(particles), "%(kind)s of %(particles)d" % found)
    check(found["status"] in ("complete", "hit", "far enough"), found["status"])
    check(found["radius_of_gyration"] > 1 and 0.8 < found["box_dimension"] < 3 and found["branches"] > 1, "figures")
    check(found["longest_way"] > 3 and found["seconds"] >= 0, "way")
    for key in ("dimensions", "eta", "span", "jitter", "style", "trunk", "charges", "seeds"):
        check(key in found["parameters"], "no " + key)


def draw(path):
    """A picture of 96x96: a disc, the left third, or nothing, by its name."""
    light = {
        "disc": lambda x, y: math.hypot(x - 47.5, y - 47.5) < 32,
        "left": lambda x, y: 36 <= x < 60,
        "black": lambda x, y: False,
    }[path.split(".")[0]]
    rows = b"".join(b"\0" + bytes(255 if light(x, y) else 0 for x in range(96)) for y in range(96))

    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))

    with open(path, "wb") as out:
        out.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", 96, 96, 8, 0, 0, 0, 0)))
        out.write(chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


if __name__ == "__main__":
    globals()[sys.argv[1]](*sys.argv[2:])
