"""Makes part programs from a seed: every number and order of words is drawn, every program is valid.

Each program has one subject; what it is about stands in the name of the function that writes it.
"""

import math
import random

SEED = 20240601
PER_SUBJECT = 8


class Writer:
    """Draws words and keeps the programmed point, so that arcs can be closed exactly."""

    def __init__(self, random_numbers):
        self.random = random_numbers
        self.lines = []

    def add(self, *words, shuffled=False):
        words = [word for word in words if word]
        if shuffled:
            self.random.shuffle(words)
        blank = self.random.choice(["", " "])
        self.lines.append(blank.join(words))

    def number(self, low=-50.0, high=50.0, digits=3):
        return round(self.random.uniform(low, high), digits)

    def written(self, value):
        """The same number in one of its spellings."""
        text = f"{value:.4f}".rstrip("0").rstrip(".")
        return self.random.choice([text, f"{value:.4f}", f"[{text}]", f"[{text} * 2 / 2]"])

    def word(self, letter, low=-50.0, high=50.0):
        return letter + self.written(self.number(low, high))

    def some_axes(self, letters="XYZ"):
        chosen = self.random.sample(letters, self.random.randint(1, len(letters)))
        return [self.word(letter) for letter in chosen]


def head(writer, *more):
    writer.add("G21 G17 G90 G40 G49 G80 G94")
    writer.add("G91.1 G98 F200", *more)


def straight_moves(writer):
    head(writer, "G64")
    for _ in range(12):
        writer.add(writer.random.choice(["", "", "G90", "G91", "G20", "G21"]))
        feed = writer.word("F", 10, 900)
        motion = writer.random.choice(["G0", "G1", "g01", "G00"])
        writer.add(motion, *writer.some_axes("XYZABC"), feed, shuffled=True)


def feeds_of_all_modes(writer):
    head(writer, "S500 M3")
    for _ in range(10):
        mode = writer.random.choice(["G93", "G94", "G95"])
        feed = {"G93": (0.5, 8), "G94": (20, 800), "G95": (0.05, 0.5)}[mode]
        writer.add(mode, "G1", writer.word("F", *feed), *writer.some_axes())


def arcs_with_centres(writer):
    plane, letters, centres = writer.random.choice(
        [("G17", "XY", "IJ"), ("G18", "ZX", "KI"), ("G19", "YZ", "JK")])
    along = next(letter for letter in "XYZ" if letter not in letters)
    absolute = writer.random.random() < 0.4
    start = [writer.number(), writer.number()]
    head(writer)
    writer.add(plane, "G90.1" if absolute else "G91.1")
    writer.add("G0", f"{letters[0]}{start[0]}", f"{letters[1]}{start[1]}", f"{along}1")
    for _ in range(8):
        centre = [writer.number(), writer.number()]
        radius = math.dist(start, centre)
        angle = writer.random.uniform(0.3, 6.0) + math.atan2(start[1] - centre[1], start[0] - centre[0])
        end = [centre[0] + radius * math.cos(angle), centre[1] + radius * math.sin(angle)]
        if writer.random.random() < 0.2:
            end = start
        offsets = centre if absolute else [c - s for c, s in zip(centre, start)]
        words = [f"{a}{v:.6f}" for a, v in zip(letters + centres, end + offsets)]
        helix = f"{along}{writer.number(-9, 9)}" if writer.random.random() < 0.4 else ""
        turns = f"P{writer.random.randint(1, 4)}" if writer.random.random() < 0.3 else ""
        writer.add(writer.random.choice(["G2", "G3"]), *words, helix, turns, shuffled=True)
        start = [round(value, 6) for value in end]


def arcs_with_radius(writer):
    plane, letters = writer.random.choice([("G17", "XY"), ("G18", "ZX"), ("G19", "YZ")])
    head(writer)
    writer.add(plane)
    start = [0.0, 0.0]
    writer.add("G0 X0 Y0 Z0")
    for _ in range(8):
        end = [writer.number(), writer.number()]
        chord = math.dist(start, end)
        radius = chord / 2 * writer.random.uniform(1.01, 3.0) * writer.random.choice([1, -1])
        words = [f"{letter}{value}" for letter, value in zip(letters, end)]
        writer.add(writer.random.choice(["G2", "G3"]), *words, f"R{radius:.6f}")
        start = end


def drilling_cycles(writer):
    plane, depth = writer.random.choice([("G17", "Z"), ("G17", "Z"), ("G18", "Y"), ("G19", "X")])
    across = [letter for letter in "XYZ" if letter != depth]
    head(writer, "S600 M3")
    writer.add(plane)
    writer.add("G0", *[f"{letter}{writer.number()}" for letter in across])
    for _ in range(3):
        level = writer.random.choice(["G98", "G99"])
        writer.add("G0", f"{depth}{writer.number(12, 30)}")
        drill_holes(writer, level, depth, across)
        writer.add("G80")


def drill_holes(writer, level, depth, across):
    """A sequence of cycles with one R: see differences.md for what happens when R rises."""
    clearance = f"R{writer.number(1, 9)}"
    boring = ["G85", "G89"] if level == "G99" else ["G85"]
    for number in range(3):
        code = writer.random.choice(["G73", "G81", "G82", "G83"] + boring)
        words = [f"{depth}{writer.number(-30, -2)}", clearance, level if number == 0 else ""]
        if code in ("G73", "G83"):
            words.append(f"Q{writer.number(2, 9)}")
        if code in ("G82", "G89"):
            words.append(f"P{writer.number(0.1, 2)}")
        if writer.random.random() < 0.3:
            words.append(f"L{writer.random.randint(1, 3)}")
        writer.add(code, *words, *[f"{a}{writer.number()}" for a in across], shuffled=True)
        for _ in range(writer.random.randint(0, 2)):
            writer.add(*[f"{letter}{writer.number()}" for letter in across])


def incremental_cycles(writer):
    head(writer, "S600 M4")
    writer.add("G0 X0 Y0", f"Z{writer.number(10, 20)}")
    writer.add("G91", writer.random.choice(["G98", "G99"]))
    code = writer.random.choice(["G81", "G82", "G83", "G73"])
    words = [f"X{writer.number()}", f"Y{writer.number()}", f"Z{writer.number(-20, -5)}", "R-3"]
    words += {"G81": [], "G82": ["P0.5"], "G83": ["Q4"], "G73": ["Q6"]}[code]
    writer.add(code, *words, f"L{writer.random.randint(2, 5)}", shuffled=True)
    writer.add("X5")
    writer.add("G80")
    writer.add("G90 G0 Z50")


def work_offsets(writer):
    head(writer)
    for system in writer.random.sample(range(1, 10), 3):
        rotation = f"R{writer.number(-180, 180)}" if writer.random.random() < 0.4 else ""
        writer.add("G10 L2", f"P{system}", *writer.some_axes("XYZA"), rotation)
        name = f"G{53 + system}" if system < 7 else f"G59.{system - 6}"
        writer.add(name, "G0 X1 Y2 Z3")
        writer.add("G1", *writer.some_axes())
        if writer.random.random() < 0.5:
            writer.add("G92", *writer.some_axes("XY"))
            writer.add("G1", *writer.some_axes())
            writer.add(writer.random.choice(["G92.1", "G92.2"]))
        writer.add("G10 L20", f"P{system}", *writer.some_axes("YZ"))
        writer.add("G0", *writer.some_axes())
        writer.add("G53 G0", *writer.some_axes())
        writer.add("G0", *writer.some_axes())
    writer.add("G54")


def tools_and_lengths(writer):
    head(writer)
    for tool in writer.random.sample(range(1, 10), 4):
        writer.add(f"T{tool}", "M6")
        writer.add(f"S{writer.random.randint(100, 9000)}", writer.random.choice(["M3", "M4"]),
                   writer.random.choice(["M8", "M7", "M9", ""]))
        writer.add(writer.random.choice(["G43", f"G43 H{tool}", "G43.1 Z12.5", "G49"]))
        writer.add("G0", *writer.some_axes())
        writer.add("G1", *writer.some_axes())
        writer.add(writer.random.choice(["M5", "M9", "G4 P0.25", "M0", "M1"]))


def expressions(writer):
    head(writer)
    names = [f"#{writer.random.randint(1, 99)}", "#<depth>", "#<_global>"]
    functions = ["SIN", "COS", "TAN", "SQRT", "ABS", "FIX", "FUP", "ROUND", "EXP", "ASIN", "ACOS"]
    for name in names:
        writer.add(f"{name}={writer.number(1, 9)}")
    for _ in range(10):
        inner = f"{writer.random.choice(names)} / 10"
        terms = [f"{writer.random.choice(functions)}[{inner}]", str(writer.number(1, 9)),
                 writer.random.choice(names), f"ATAN[{writer.number(1, 9)}]/[{writer.number(1, 9)}]"]
        writer.random.shuffle(terms)
        divided = writer.random.choice(["/", "MOD"]) + f" {writer.number(1, 9)}"
        text = f"[{terms[0]} {writer.random.choice('+-*')} {terms[1]} {divided}]"
        text = f"[{text} {writer.random.choice(['GT', 'LE', 'EQ', 'AND', 'XOR', '+', '*'])} {terms[2]}]"
        writer.add("G1", f"X{text}", f"Y[{terms[3]} - {names[1]}]", f"#{writer.random.randint(100, 120)}=3")


def o_word_flow(writer):
    head(writer)
    writer.add("#1=0 #2=0")
    kind = writer.random.choice(["while", "repeat", "do", "if"])
    count = writer.random.randint(2, 6)
    opening = {"while": f"o10 while [#1 LT {count}]", "repeat": f"o10 repeat [{count}]",
               "do": "o10 do", "if": f"o10 if [#1 LT {count}]"}[kind]
    closing = {"while": "o10 endwhile", "repeat": "o10 endrepeat",
               "do": f"o10 while [#1 LT {count}]", "if": "o10 endif"}[kind]
    writer.add(opening)
    writer.add("#1=[#1+1]")
    writer.add("o20 if [#1 MOD 2 EQ 0]")
    writer.add("G1 X#1", writer.word("Y"))
    writer.add("o20 elseif [#1 EQ 3]")
    if kind in ("while", "do") and writer.random.random() < 0.4:
        writer.add(writer.random.choice(["o10 continue", "o10 break"]))
    writer.add("G0 Z#1")
    writer.add("o20 else")
    writer.add("G1 Y[#1*2]")
    writer.add("o20 endif")
    writer.add(closing)
    writer.add("G0 X0")


def o_word_calls(writer):
    name = writer.random.choice(["o<side>", "o100"])
    writer.add(f"{name} sub")
    writer.add("#<length>=[#1 + #2]")
    writer.add("G91 G1 X#<length> Y#3")
    writer.add("o50 if [#1 GT 5]")
    writer.add(f"{name} return [#1 * 2]")
    writer.add("o50 endif")
    writer.add("G1 Z1")
    writer.add(f"{name} endsub [#2 - 1]")
    head(writer)
    for _ in range(4):
        arguments = " ".join(f"[{writer.number(0, 9)}]" for _ in range(3))
        writer.add(f"{name} call {arguments}")
        writer.add("G90 G1 X#<_value>")


SUBJECTS = (straight_moves, feeds_of_all_modes, arcs_with_centres, arcs_with_radius, drilling_cycles,
            incremental_cycles, tools_and_lengths, expressions, o_word_flow, o_word_calls)


def write_programs(folder, seed=SEED, per_subject=PER_SUBJECT):
    """Writes the programs into `folder`; the same for the same seed."""
    paths = []
    for subject in SUBJECTS:
        for number in range(per_subject):
            writer = Writer(random.Random(f"{seed} {subject.__name__} {number}"))
            subject(writer)
            writer.add("M2")
            path = folder / f"{subject.__name__}_{number}.ngc"
            path.write_text("\n".join(writer.lines) + "\n")
            paths.append(path)
    return paths
