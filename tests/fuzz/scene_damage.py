"""Blows to the text of a scene: bytes, encodings, lines, values, numbers, units, keys, headers, file names."""
import re

NUMBERS = ["0", "-1", "1", "1e-300", "1e-320", "1e300", "1e308", "1e309", "nan", "inf", "-inf", "0x10", "1_000", "1e-9",
           "9223372036854775807", "9223372036854775808", "-9223372036854775808", "1e9", "0.1", "1000", "3.5", "+2", "1,5"]
UNITS = ["mm", "um", "m", "km", "inch", "nm", "", "s", "ms", "Hz", "m/s", "mm/s", "m s-1", "m/s^2", "deg", "rad", "rpm",
         "N/m", "Pa", "MPa", "g/cm^3", "kg", "g/s", "mm 2", "10 mm", "mm @ 3", "mm since 1", "lg(re 1 mm)", "dozen",
         "percent mm", "mm^0", "mm^99", "2 (1.5 mm)", "\u00b5m", "m\u00b2/m", "\u00a0mm", "mm\u0000", "degC", "((((mm", "per s"]
TEXTS = ["", " ", "a", "x" * 300, "x" * 100000, "a/b", "../..", "-", "--help", "\\u0000", "\\n", "\\u001b[31mred", "\\u202eabc",
         "\u00e9\u00e8", "\U0001f600", "'", "\\\"", "<b>", "$(id)", "beginnings", "comparison.json", ".", "..", "nul", "%s%n"]
FILES = ["die.stl", ".", "..", "/dev/zero", "/dev/null", "/dev/stdin", "pipe.stl", "sparse.stl", "empty.stl", "folder.stl",
         "/proc/self/mem", "scene.toml", "x" * 300 + ".stl", "no_such.stl", "die.STEP", "loop.stl", "pipe.csv", "sparse.csv"]
# Keys with the least and the most that their documentation allows, and just beyond.
EXTREMES = {
    "seed": ["0", "9223372036854775807"], "gravity": ['"1e-300 m/s^2"', '"1000 m/s^2"'],
    "grain_diameter": ['"0.03 mm"', '"0.0471 mm"', '"6 mm"', '"9.4 mm"', '"100 mm"'],
    "sphere_radius": ['"0.001 mm"', '"10 mm"', '"0.01 mm"'], "spacing": ["0.2", "4", "2.4", "1.4"],
    "reduced_modulus": ['"1e4 Pa"', '"1e12 Pa"'], "friction": ["0", "10"], "work_of_adhesion": ['"0 J/m^2"', '"10 J/m^2"'],
    "damping_over_radius": ['"0 Pa s/m"', '"1e9 Pa s/m"'], "tangential_over_radius": ['"0 Pa"', '"1e12 Pa"'],
    "fill_height": ['"0.001 mm"', '"1 m"'], "solid_fraction": ["0.05", "0.74"], "rim_speed": ['"0 m/s"', '"1 m/s"'],
    "lattice_constant": ["1", "5"], "random_offset": ["0", "0.5"], "velocity": ['"1e-300 m/s"', '"10 m/s"', '"0.1 mm/s"'],
    "acceleration": ['"1e-300 m/s^2"', '"10000 m/s^2"'], "passages": ["1", "1000", "7"], "pause": ['"0 s"', '"60 s"'],
    "clearance": ['"0 mm"', '"1 m"'], "travel": ['"0.001 mm"', '"10 m"'], "frequency": ['"1e-300 Hz"', '"10 kHz"'],
    "amplitude": ['"0.001 mm"', '"100 mm"', '"360 deg"'], "duration": ['"1e-300 s"', '"1000 s"'], "ramp": ['"1e-300 s"', '"100 s"'],
    "time_step": ['"1e-300 s"', '"1 ms"', '"1 ns"'], "time_step_fraction": ["1e-300", "1", "1e-6"], "skin": ['"1e-300 mm"', '"10 mm"'],
    "max_time": ['"1e-300 s"', '"10000 s"', '"1 ms"'], "checkpoint_interval": ['"1 s"', '"86400 s"'],
    "averaging_width": ['"1e-300 mm"', '"100 mm"'], "azimuth_bins": ["4", "360"], "snapshot_interval": ['"0.1 ms"', '"1000 s"'],
    "fill_plane": ['"-10 m"', '"10 m"'], "position": ['["10 m", "0 mm", "0 mm"]', '["0 mm", "0 mm", "-10 m"]'],
    "angle": ['"-360 deg"', '"360 deg"'], "interval": ['"1e-300 s"', '"1000 s"'], "chord_tolerance": ['"1e-5 mm"', '"1 mm"'],
    "speed": ['"60000 rpm"', '"1e-300 rpm"'], "most_sheared": ["0", "0.1"], "carry_beyond": ['"0 mm"', '"1 m"'],
    "from": ['["-10 m", "-10 m", "-10 m"]'], "to": ['["10 m", "10 m", "10 m"]'], "mass": ['"1e-300 kg"', '"1000 kg"'],
    "rate": ['"1e-300 kg/s"', '"1000 kg/s"'], "air_viscosity": ['"1 Pa s"'], "grain_mass": ['"1e-300 kg"', '"1 kg"'],
    "part": ['"no such part"'], "length_unit": ['"m"', '"um"', '"inch"'], "repair": ['"wrap"', '"off"'], "kind": ['"mesh"', '"wait"'],
    "model": ['"A"', '"B"', '"C"', '"D"'], "mirror": ['"x"', '"y"'], "opening": ['"centres"'], "around_tools": ["true"],
    "drop_spilled": ["false"], "skip_far_walls": ["false"], "sleep": ["true"], "setting": ['"quick"', '"reference"'],
}
NEW_LINES = ['setting = "quick"', "[[variant]]", 'name = "x"', "[[step]]", 'kind = "wait"', "[measure]", "[economy]", 'mirror = "y"',
             "[numerics]", 'periodic = { x = "5 mm", y = "5 mm" }', "[[probe]]", 'quantity = "load"', "[[snapshot]]", 'every = "1 us"',
             "[suction]", '[contact.normal]', 'law = "JKR"', "[powder.sizes]", 'distribution = "log-normal"', "a.b.c.d.e.f = 1",
             "x = " + "[" * 5000, "." .join("a" * 5000) + " = 1", "x = " + "{a=" * 2000 + "1" + "}" * 2000, "x = '''", 'x = """']


def damage(text, others, rng):
    """`text` (str) with one to four blows; bytes."""
    for _ in range(rng.choice([1, 1, 1, 2, 2, 3, 4])):
        text = rng.choice(BLOWS)(text, others, rng)
    data = text.encode("utf-8", "surrogatepass") if rng.random() > 0.02 else encode_otherwise(text, rng)
    return damage_bytes(data, rng) if rng.random() < 0.12 else data


def encode_otherwise(text, rng):
    encoding = rng.choice(["utf-16", "utf-16-le", "utf-32", "latin-1", "utf-8-sig", "cp037"])
    return text.encode(encoding, "replace")


def damage_bytes(data, rng):
    data = bytearray(data)
    for _ in range(rng.randint(1, 6)):
        if not data:
            break
        at = rng.randrange(len(data))
        blow = rng.randrange(5)
        if blow == 0:
            data[at] ^= 1 << rng.randrange(8)
        elif blow == 1:
            data[at] = rng.randrange(256)
        elif blow == 2:
            del data[at:at + rng.randint(1, 40)]
        elif blow == 3:
            data[at:at] = data[at:at + rng.randint(1, 40)]
        else:
            del data[at:]
    return bytes(data)


def lines_of(text):
    return text.split("\n")


def change_line(text, others, rng):
    lines = lines_of(text)
    at = rng.randrange(len(lines))
    blow = rng.randrange(5)
    if blow == 0:
        del lines[at]
    elif blow == 1:
        lines.insert(rng.randrange(len(lines) + 1), lines[at])
    elif blow == 2:
        other = rng.randrange(len(lines))
        lines[at], lines[other] = lines[other], lines[at]
    elif blow == 3:
        lines.insert(at, rng.choice(lines_of(rng.choice(others))))
    else:
        lines.insert(at, rng.choice(NEW_LINES))
    return "\n".join(lines)


def values(text):
    """Places of values: key, begin, end."""
    return [(m.group(1), m.start(2), m.end(2)) for m in re.finditer(r"(?m)^\s*([\w.\"-]+)\s*=\s*(.*?)\s*(?:#.*)?$", text)]


def change_value(text, others, rng):
    places = values(text)
    if not places:
        return text
    key, begin, end = rng.choice(places)
    kind = rng.randrange(4)
    if kind == 0:
        value = rng.choice(NUMBERS)
    elif kind == 1:
        value = '"' + rng.choice(NUMBERS) + rng.choice(["", " ", " "]) + rng.choice(UNITS) + '"'
    elif kind == 2:
        value = '"' + rng.choice(TEXTS) + '"'
    else:
        value = rng.choice(["true", "false", "[]", "{}", "[1, 2, 3]", '["0 mm", "0 mm", "0 mm"]', "1979-05-27", "[0, 0, 0]", '["die", "die"]'])
    return text[:begin] + value + text[end:]


def to_extreme(text, others, rng):
    """One to three keys at the end of what is allowed."""
    for _ in range(rng.randint(1, 3)):
        places = [place for place in values(text) if place[0].split(".")[-1] in EXTREMES]
        if not places:
            return text
        key, begin, end = rng.choice(places)
        text = text[:begin] + rng.choice(EXTREMES[key.split(".")[-1]]) + text[end:]
    return text


def add_extreme(text, others, rng):
    """A key that the table may not have yet, at the end of what it allows."""
    lines = lines_of(text)
    headers = [n for n, line in enumerate(lines) if line.startswith("[")]
    key = rng.choice(sorted(EXTREMES))
    lines.insert(rng.choice(headers) + 1 if headers else 0, key + " = " + rng.choice(EXTREMES[key]))
    return "\n".join(lines)


def scale_number(text, others, rng):
    numbers = list(re.finditer(r"(?<![\w.])-?\d+(\.\d+)?", text))
    if not numbers:
        return text
    at = rng.choice(numbers)
    factor = rng.choice([-1, 0.1, 10, 1e-3, 1e3, 0.5, 2, 1.0000001, 1e-6, 1e6])
    return text[:at.start()] + ("%.10g" % (float(at.group()) * factor)) + text[at.end():]


def change_unit(text, others, rng):
    units = list(re.finditer(r'"-?[\d.e+-]+ ?([^"\n]+)"', text))
    if not units:
        return text
    at = rng.choice(units)
    return text[:at.start(1)] + rng.choice(UNITS) + text[at.end(1):]


def change_key(text, others, rng):
    keys = list(re.finditer(r"(?m)^\s*([\w.]+)\s*=", text))
    if not keys:
        return text
    at = rng.choice(keys)
    key = at.group(1)
    cut = rng.randrange(len(key))
    new = rng.choice([key[:cut] + key[cut + 1:], key + "s", key.upper(), rng.choice(keys).group(1), "x" * 300, key + "." + key,
                      rng.choice(sorted(EXTREMES)), '"' + key + '"', "", "\u00e9"])
    return text[:at.start(1)] + new + text[at.end(1):]


def change_file(text, others, rng):
    files = list(re.finditer(r'(?m)^file\s*=\s*"([^"\n]*)"', text))
    if not files:
        return text
    at = rng.choice(files)
    return text[:at.start(1)] + rng.choice(FILES) + text[at.end(1):]


def change_header(text, others, rng):
    headers = list(re.finditer(r"(?m)^\[+([\w.]+)\]+", text))
    if not headers:
        return text
    at = rng.choice(headers)
    name = rng.choice([at.group(1), rng.choice(headers).group(1), "walls", "economy", "contact", at.group(1)[1:]])
    return text[:at.start()] + rng.choice(["[%s]", "[[%s]]", "[%s", "[%s]]", "[]%s"]) % name + text[at.end():]


BLOWS = [change_line, change_value, change_value, to_extreme, to_extreme, to_extreme, add_extreme, scale_number, scale_number,
         change_unit, change_key, change_file, change_header]
