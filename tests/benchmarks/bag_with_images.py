#!/usr/bin/env python3
"""bag_with_images.py RECORDING.csv FOLDER [GIGABYTES]: the recording among pictures, as bag.bag (ROS 1), bag.mcap and
bag.db3 (ROS 2). The pictures' bytes are holes in the files, so that a file of 3 GB is made in seconds and takes little of
the disk; reading them costs the same as reading others from the page cache. Raw pictures are all of one size, compressed
ones of a new size each."""
import csv
import os
import random
import sqlite3
import struct
import sys

START = 1700000000
RAW = 640 * 480 * 3  # [bytes] of a picture
BORDER = "=" * 80 + "\nMSG: "
HEADER1 = BORDER + "std_msgs/Header\nuint32 seq\ntime stamp\nstring frame_id\n"
HEADER2 = (BORDER + "std_msgs/Header\nbuiltin_interfaces/Time stamp\nstring frame_id\n" + BORDER +
           "builtin_interfaces/Time\nint32 sec\nuint32 nanosec\n")
TOPICS = {  # number: topic, type, definition without the header's, which ROS 1 and 2 have each their own of
    0: ("/joint_states", "sensor_msgs/JointState",
        "std_msgs/Header header\nstring[] name\nfloat64[] position\nfloat64[] velocity\nfloat64[] effort\n"),
    1: ("/ft/wrench", "geometry_msgs/WrenchStamped",
        "std_msgs/Header header\ngeometry_msgs/Wrench wrench\n" + BORDER + "geometry_msgs/Wrench\n"
        "geometry_msgs/Vector3 force\ngeometry_msgs/Vector3 torque\n" + BORDER +
        "geometry_msgs/Vector3\nfloat64 x\nfloat64 y\nfloat64 z\n"),
    2: ("/camera/raw", "sensor_msgs/Image", "std_msgs/Header header\nuint32 height\nuint32 width\nstring encoding\n"
        "uint8 is_bigendian\nuint32 step\nuint8[] data\n"),
    3: ("/camera/compressed", "sensor_msgs/CompressedImage", "std_msgs/Header header\nstring format\nuint8[] data\n")}


def text(value):
    data = value.encode()
    return struct.pack("<I", len(data)) + data


def stamp(t):
    ns = round(t * 1e9)
    return START + ns // 10**9, ns % 10**9


class Cdr:
    """Plain CDR, little-endian; with `packed` the bytes of ROS 1."""

    def __init__(self, packed, t):
        self.packed, self.data = packed, b""
        if packed:
            self.put("I", 0)
        self.put("I", *stamp(t))
        self.text("frame")

    def put(self, form, *values):
        if not self.packed:
            self.data += b"\0" * (-len(self.data) % struct.calcsize(form))
        self.data += struct.pack("<%d%s" % (len(values), form), *values)

    def text(self, value):
        self.put("I", len(value) + (0 if self.packed else 1))
        self.data += value.encode() + (b"" if self.packed else b"\0")

    def bytes(self):
        return self.data if self.packed else b"\0\1\0\0" + self.data


def message(packed, topic, t, content):
    """Its bytes, and how many zeros follow them."""
    out = Cdr(packed, t)
    if topic == 0:
        out.put("I", 7)
        for j in range(7):
            out.text("panda_joint%d" % (j + 1))
        for values in content:
            out.put("I", 7)
            out.put("d", *values)
    elif topic == 1:
        out.put("d", *content)
    elif topic == 2:
        out.put("I", 480, 640)
        out.text("rgb8")
        out.put("B", 0)
        out.put("I", 1920, RAW)
    else:
        out.text("jpeg")
        out.put("I", content)
    return out.bytes(), {2: RAW, 3: content}.get(topic, 0)


def messages(path, size):
    """(topic, time, content) of the recording and of as many pictures as make `size` bytes."""
    with open(path, newline="") as file:
        rows = [{name: float(value) for name, value in row.items() if name != "label"} for row in csv.DictReader(file)]
    chance = random.Random(1)
    every = max(1, int(len(rows) * (RAW + 100000) / size))
    for k, row in enumerate(rows):
        t = row["time"]
        yield 1, t, [row[c] for c in ("fx", "fy", "fz", "tx", "ty", "tz")]
        yield 0, t, [[row["q%d" % j] for j in range(1, 8)],
                     [row["dq%d" % j] for j in range(1, 8)] if "dq1" in row else [0.0] * 7, [0.0] * 7]
        if k % every == 0:
            yield 2, t, None
            yield 3, t, chance.randrange(50000, 150000)


def fields(**values):
    return b"".join(struct.pack("<I", len(name) + 1 + len(value)) + name.encode() + b"=" + value
                    for name, value in values.items())


def record1(head, data, more=0):
    return struct.pack("<I", len(head)) + head + struct.pack("<I", len(data) + more) + data


def make_bag(recording, path, size):
    with open(path, "wb") as file:
        file.write(b"#ROSBAG V2.0\n" + record1(fields(op=b"\x03", index_pos=struct.pack("<Q", 0)), b" " * 4027))
        parts, length = [], 0

        def flush():
            nonlocal parts, length
            file.write(record1(fields(op=b"\x05", compression=b"none", size=struct.pack("<I", length)), b"", length))
            for data, zeros in parts:
                file.write(data)
                file.seek(zeros, os.SEEK_CUR)
            parts, length = [], 0

        for topic, (name, kind, definition) in TOPICS.items():
            inner = fields(topic=name.encode(), type=kind.encode(), md5sum=b"*", message_definition=(
                definition + HEADER1).encode())
            data = record1(fields(op=b"\x07", conn=struct.pack("<I", topic), topic=name.encode()), inner)
            parts.append((data, 0))
            length += len(data)
        for topic, t, content in messages(recording, size):
            body, zeros = message(True, topic, t, content)
            head = fields(op=b"\x02", conn=struct.pack("<I", topic), time=struct.pack("<II", *stamp(t)))
            data = record1(head, body, zeros)
            parts.append((data, zeros))
            length += len(data) + zeros
            if length > 768 * 1024:  # rosbag's own limit
                flush()
        flush()
        file.truncate()


def make_mcap(recording, path, size):
    def record(op, content, more=0):
        return struct.pack("<BQ", op, len(content) + more) + content

    with open(path, "wb") as file:
        file.write(b"\x89MCAP0\r\n" + record(1, text("ros2") + text("bag_with_images.py")))
        parts, length = [], 0

        def flush():
            nonlocal parts, length
            file.write(record(6, struct.pack("<QQQI", 0, 0, length, 0) + text("") + struct.pack("<Q", length), length))
            for data, zeros in parts:
                file.write(data)
                file.seek(zeros, os.SEEK_CUR)
            parts, length = [], 0

        def add(data, zeros=0):
            nonlocal length
            parts.append((data, zeros))
            length += len(data) + zeros

        for topic, (name, kind, definition) in TOPICS.items():
            add(record(3, struct.pack("<H", topic + 1) + text(kind.replace("/", "/msg/")) + text("ros2msg") +
                       text(definition + HEADER2)))
            add(record(4, struct.pack("<HH", topic, topic + 1) + text(name) + text("cdr") + text("")))
        for topic, t, content in messages(recording, size):
            body, zeros = message(False, topic, t, content)
            ns = stamp(t)[0] * 10**9 + stamp(t)[1]
            add(record(5, struct.pack("<HIQQ", topic, 0, ns, ns) + body, zeros), zeros)
            if length > 4 << 20:  # the limit of mcap's own writers
                flush()
        flush()
        file.write(record(15, struct.pack("<I", 0)) + record(2, struct.pack("<QQI", 0, 0, 0)) + b"\x89MCAP0\r\n")


def make_sqlite(recording, path, size):
    if os.path.exists(path):
        os.remove(path)
    database = sqlite3.connect(path)
    database.execute("CREATE TABLE topics(id INTEGER PRIMARY KEY,name TEXT NOT NULL,type TEXT NOT NULL,"
                     "serialization_format TEXT NOT NULL,offered_qos_profiles TEXT NOT NULL)")
    database.execute("CREATE TABLE messages(id INTEGER PRIMARY KEY,topic_id INTEGER NOT NULL,"
                     "timestamp INTEGER NOT NULL,data BLOB NOT NULL)")
    for topic, (name, kind, _) in TOPICS.items():
        database.execute("INSERT INTO topics VALUES(?,?,?,'cdr','')", (topic + 1, name, kind.replace("/", "/msg/")))
    for topic, t, content in messages(recording, size):
        body, zeros = message(False, topic, t, content)
        ns = stamp(t)[0] * 10**9 + stamp(t)[1]
        database.execute("INSERT INTO messages(topic_id,timestamp,data) VALUES(?,?,?)",
                         (topic + 1, ns, body + b"\0" * zeros))
    database.commit()
    database.close()


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    bytes_wanted = int(1e9 * float(sys.argv[3] if len(sys.argv) > 3 else 3))
    os.makedirs(sys.argv[2], exist_ok=True)
    for make, ending in (make_bag, "bag"), (make_mcap, "mcap"), (make_sqlite, "db3"):
        make(sys.argv[1], os.path.join(sys.argv[2], "bag." + ending), bytes_wanted)
