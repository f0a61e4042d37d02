#!/usr/bin/env python3
"""What core/diagnosis is made of, in numbers: diagnosis-counts.py [ROOT]

ROOT is a checkout, by default the one that this file is in; an older one may be given to compare with. Counts by
regular expressions, good to a few per cent: named numeric constants and how many names they have, other numbers with a
fraction, causes named outside causes/, longest file and function, includes between units and folders that run up.
The order of folders is that of add_subdirectory() in core/diagnosis/CMakeLists.txt.

A named constant counts as tuned unless it is one of these: the number of a form or kind ("static constexpr int", "enum"),
a size on a page (report/), rounding (at most 1e-6) or infinity (at least 1e6), or a name of FACTS below. Parameters'
sizes and bounds in causes/ have no names; they are among the other numbers.
"""
import collections
import pathlib
import re
import sys

ROOT = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else pathlib.Path(__file__).resolve().parent.parent
FOLDER = ROOT / "core" / "diagnosis"
CONSTANT = re.compile(r"\b(k[A-Z]\w*)\s*(?:\{|=)\s*-?[\d.][\w.+-]*(?=\s*[,;}*/])")
NUMBER = re.compile(r"(?<![\w.])\d+\.\d*(?:e[+-]?\d+)?")
TRIVIAL = {"0.0", "1.0", "2.0", "0.5"}
FACTS = {  # What nobody tunes: units and quadrature, sizes of arrays and models, limits to how much is computed
    "kDegrees", "kMilli", "kMetre", "kRad", "kNode", "kWeight", "kGolden", "kLinear", "kHalfWaves", "kUsualSmoothing",
    "kRounds", "kLooks", "kBatch", "kDraws", "kParts", "kMostFalls", "kMaxOrder", "kMostHalfBlocks", "kMostPlaces", "kTried",
    "kTriedLater", "kRivals", "kFinished", "kTop", "kTerms", "kKept", "kForms", "kOfOne", "kMostSiblings", "kSmoothest", "kAtOnce",
    "kLimits", "kBlock", "kBins", "kEvery", "kLong", "kCoarseHz", "kCoarseBlocksHz"}
TABLES = {"sensor_range.cpp"}  # Of data sheets
TAG = re.compile(r"\benum\b|static constexpr int\b")
GIVEN = {"core/diagnosis/options", "core/diagnosis/calibration"}  # Headers that all folders are given


def bare(text):
    """Code without comments and texts."""
    text = re.sub(r'"(?:[^"\\\n]|\\.)*"', '""', text)
    return re.sub(r"//[^\n]*", "", text)


def tuned(path, text):
    """Names of the constants that somebody tuned."""
    if path.parent.name == "report":
        return []
    out = []
    for line in bare(text).split(";"):
        for match in CONSTANT.finditer(line + ";"):
            value = float(re.search(r"[\d.]+(?:e[+-]?\d+)?", match.group(0).split(match.group(1), 1)[1]).group(0))
            fact = match.group(1) in FACTS or TAG.search(line) or 0 < value <= 1e-6 or value >= 1e6
            if not fact:
                out.append(match.group(1))
    return out


def functions(text):
    """Lengths of what begins at a line's start with a name and parentheses and ends with } there; of methods, by two."""
    for indent in ("", "  "):
        for match in re.finditer(rf"^{indent}(?! )[^\s#/}}][^\n]*\([^;{{]*\{{\n.*?^{indent}\}}\n", text, re.M | re.S):
            head = match.group(0).split("\n", 1)[0]
            if not re.match(rf"{indent}(namespace|class|struct|enum|return|if|for|while|switch|parallelFor|const auto)\b", head):
                yield match.group(0).count("\n"), head.strip()


def cycles(graph):
    """Size of the largest set of units that include each other in a circle (Tarjan)."""
    index, low, stack, largest = {}, {}, [], 0

    def visit(unit):
        nonlocal largest
        index[unit] = low[unit] = len(index)
        stack.append(unit)
        for other in graph[unit]:
            if other not in index:
                visit(other)
                low[unit] = min(low[unit], low[other])
            elif other in stack:
                low[unit] = min(low[unit], index[other])
        if low[unit] == index[unit]:
            members = 0
            while True:
                members += 1
                if stack.pop() == unit:
                    break
            largest = max(largest, members)

    sys.setrecursionlimit(10000)
    for unit in list(graph):
        if unit not in index:
            visit(unit)
    return largest


def main():
    files = sorted(p for p in FOLDER.rglob("*") if p.suffix in (".h", ".cpp"))
    texts = {p: p.read_text() for p in files}
    names = collections.Counter()
    numbers = 0
    for path, text in texts.items():
        code = bare(text)
        found = CONSTANT.findall(code)
        names.update(found)
        if path.name in TABLES:
            continue
        numbers += sum(1 for n in NUMBER.findall(re.sub(CONSTANT, "", code)) if n not in TRIVIAL)
    ids = set()
    for path, text in texts.items():
        if path.parent.name == "causes":
            ids |= set(re.findall(r'string_view \w+ = "([a-z_]+)"', text))
            ids |= set(re.findall(r'id\(\) const override \{ return "([a-z_]+)"', text))
    ids |= {"spikes", "dropouts", "jitter", "quantisation", "frame_error"}
    outside = [p for p in files if p.parent.name != "causes"]
    literal = re.compile('"(?:%s)"' % "|".join(sorted(ids)))
    literals = sum(len(literal.findall(re.sub(r"//[^\n]*", "", texts[p]))) for p in outside)
    constants = sum(len(re.findall(r"\bids::\w+", bare(texts[p]))) for p in outside)

    unit = {p: str(p.relative_to(ROOT).with_suffix("")) for p in files}
    graph = collections.defaultdict(set)
    for path, text in texts.items():
        graph[unit[path]]
        for include in re.findall(r'#include "(core/diagnosis/[\w/]+)\.h"', text):
            if include != unit[path]:
                graph[unit[path]].add(include)
    order = re.findall(r"add_subdirectory\((\w+)\)|heft_module\(diagnosis_?(\w*)", (FOLDER / "CMakeLists.txt").read_text())
    place = {}
    for folder, module in order:
        place[folder or module or "top"] = len(place)
    top = {"frames": "result", "result": "result", "options": "result"}

    def level(name):
        parts = name.split("/")
        return place.get(parts[2] if len(parts) > 3 else top.get(parts[2], "top"), len(place))

    up = [(a, b) for a in graph for b in graph[a] if level(b) > level(a) and b not in GIVEN]
    longest_file = max(files, key=lambda p: texts[p].count("\n"))
    longest = max(((n, head, p) for p in files if p.suffix == ".cpp" for n, head in functions(texts[p])), key=lambda x: x[0])
    long_functions = sum(1 for p in files for n, _ in functions(texts[p]) if n > 80)
    print(f"files {len(files)}, lines {sum(t.count(chr(10)) for t in texts.values())}, units {len(graph)}")
    print(f"named numeric constants {sum(names.values())}, different names {len(names)}, "
          f"most used {', '.join(f'{n} {c}x' for n, c in names.most_common(4))}")
    counted = {p: tuned(p, text) for p, text in texts.items()}
    shared = sum(len(v) for p, v in counted.items() if p.name == "calibration.h")
    print(f"tuned constants {sum(len(v) for v in counted.values())}: {shared} shared in calibration.h, the others with the one "
          f"rule that uses them")
    print(f"other numbers with a fraction {numbers}")
    print(f"cause IDs outside causes/: {literals} literals, {constants} named constants (ids::)")
    print(f"longest file {longest_file.relative_to(FOLDER)} ({texts[longest_file].count(chr(10))} lines), "
          f"files above 400 lines {sum(1 for t in texts.values() if t.count(chr(10)) > 400)}")
    print(f"longest function {longest[0]} lines ({longest[2].relative_to(FOLDER)}: {longest[1][:60]}), above 80 lines {long_functions}")
    print(f"includes between units {sum(len(v) for v in graph.values())}, that run up {len(up)}, "
          f"units in the largest cycle {cycles(graph)}")
    for a, b in sorted(up):
        print(f"  up: {a} -> {b}")


main()
