#!/usr/bin/env python3
"""Writes log.npz, table.npy and log.mat: what make_fixtures.py has in its recordings, 101 samples at 100 Hz, as NumPy and
MATLAB (version 5, compressed) save it. Needs nothing but Python: the formats are written here, so that the reader's
library does not test itself."""
import math
import struct
import zipfile
import zlib

HOME = [0.0, -0.785, 0.0, -2.356, 0.0, 1.571, 0.785]
TIMES = [0.01 * k for k in range(101)]


def joints(t):
    return [HOME[j] + 0.2 * math.sin(3.0 * t + j) for j in range(7)]


def wrench(t):
    return [math.sin(5.0 * t), 2.0 * math.cos(4.0 * t), -5.0 + t, 0.1 * t, -0.2 * math.sin(t), 0.05]


def npy(descr, shape, data, fortran=False):
    header = f"{{'descr': {descr}, 'fortran_order': {fortran}, 'shape': {shape}, }}"
    header += " " * (-(10 + len(header) + 1) % 64) + "\n"
    return b"\x93NUMPY\x01\x00" + struct.pack("<H", len(header)) + header.encode() + data


def floats(values, code="d", order="<"):
    return struct.pack(f"{order}{len(values)}{code}", *values)


def write_npz(path):
    rows = len(TIMES)
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as out:
        def add(name, content):
            info = zipfile.ZipInfo(name, (2024, 1, 1, 0, 0, 0))
            info.compress_type = zipfile.ZIP_DEFLATED
            out.writestr(info, content)
        add("timestamp_ns.npy", npy("'<i8'", f"({rows},)", floats([round(1e9 * t) for t in TIMES], "q")))
        # One in Fortran's order, one big-endian.
        add("q.npy", npy("'<f8'", f"({rows}, 7)", floats([joints(t)[j] for j in range(7) for t in TIMES]), True))
        add("ft_wrench.npy", npy("'>f8'", f"({rows}, 6)", floats([v for t in TIMES for v in wrench(t)], order=">")))
        add("note.npy", npy("'<U5'", "()", "hello".encode("utf-32-le")))


def write_npy(path):
    """A structured array, as numpy.genfromtxt(names=True) makes it."""
    rows = b"".join(floats([t]) + floats(joints(t)) + floats(wrench(t)) for t in TIMES)
    descr = "[('time', '<f8'), ('q', '<f8', (7,)), ('wrench', '<f8', (6,))]"
    with open(path, "wb") as out:
        out.write(npy(descr, f"({len(TIMES)},)", rows))


def element(kind, data):
    return struct.pack("<II", kind, len(data)) + data + b"\0" * (-len(data) % 8)


def matrix(name, rows, columns, values):
    """miMATRIX of doubles, column by column."""
    return element(14, element(6, struct.pack("<II", 6, 0)) + element(5, struct.pack("<ii", rows, columns)) +
                   element(1, name.encode()) + element(9, floats(values)))


def structure(name, fields):
    names = b"".join(field.encode().ljust(32, b"\0") for field, _ in fields)
    return element(14, element(6, struct.pack("<II", 2, 0)) + element(5, struct.pack("<ii", 1, 1)) +
                   element(1, name.encode()) + struct.pack("<HHi", 5, 4, 32) + element(1, names) +
                   b"".join(content for _, content in fields))


def write_mat(path):
    rows = len(TIMES)
    log = structure("log", [
        ("time", matrix("", rows, 1, TIMES)),
        ("q", matrix("", rows, 7, [joints(t)[j] for j in range(7) for t in TIMES])),
        ("wrench", matrix("", 6, rows, [v for t in TIMES for v in wrench(t)])),
    ])
    packed = zlib.compress(log)
    with open(path, "wb") as out:
        out.write(b"MATLAB 5.0 MAT-file, written by make_arrays.py".ljust(124, b" ") + struct.pack("<H", 0x0100) + b"IM")
        out.write(matrix("gain", 1, 1, [2.5]))
        out.write(struct.pack("<II", 15, len(packed)) + packed)


if __name__ == "__main__":
    write_npz("log.npz")
    write_npy("table.npy")
    write_mat("log.mat")
