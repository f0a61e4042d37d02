#!/usr/bin/python3
"""Makes the recordings beside this script, without any code of Heft's: ROS 1 bags by Debian's rosbag, the database of a
ROS 2 bag by sqlite3, MCAP files byte by byte from the specification, HDF5 by h5py. Needs the packages python3-rosbag
python3-geometry-msgs python3-sensor-msgs python3-h5py python3-zstandard lz4. What they hold is formula(): joints at
100 Hz, the wrench at 200 Hz, for one second."""
import math
import os
import sqlite3
import struct
import subprocess
import sys

START = 1700000000
HERE = os.path.dirname(os.path.abspath(__file__))
NAMES = ["panda_joint%d" % j for j in range(1, 8)]
HOME = [0.0, -0.785, 0.0, -2.356, 0.0, 1.571, 0.785]


def q(t):
    return [HOME[j] + 0.2 * math.sin(3.0 * t + j) for j in range(7)]


def dq(t):
    return [0.6 * math.cos(3.0 * t + j) for j in range(7)]


def wrench(t):
    return [math.sin(5.0 * t), 2.0 * math.cos(4.0 * t), -5.0 + t, 0.1 * t, -0.2 * math.sin(t), 0.05]


def samples():
    """(time, True for joints) in the order of arrival."""
    out = []
    for k in range(200):
        out.append((k / 200.0, False))
        if k % 2 == 0:
            out.append((k / 200.0, True))
    return out


def stamp(t):
    ns = round(t * 1e9)
    return START + ns // 1000000000, ns % 1000000000


# ROS 1 ------------------------------------------------------------------------------------------------------------
def make_bags():
    import genpy
    import rosbag
    from geometry_msgs.msg import WrenchStamped
    from sensor_msgs.msg import JointState

    for compression in ["none", "bz2", "lz4"]:
        bag = rosbag.Bag(os.path.join(HERE, "ros1_%s.bag" % compression), "w", compression=compression,
                         chunk_threshold=16 * 1024)
        for t, joints in samples():
            secs, nsecs = stamp(t)
            if joints:
                message = JointState()
                message.name = ["panda_finger_joint1"] + NAMES
                message.position = [0.04] + q(t)
                message.velocity = [0.0] + dq(t)
            else:
                message = WrenchStamped()
                f = wrench(t)
                force, torque = message.wrench.force, message.wrench.torque
                force.x, force.y, force.z, torque.x, torque.y, torque.z = f
                message.header.frame_id = "ft_sensor"
            message.header.stamp = genpy.Time(secs, nsecs)
            bag.write("/joint_states" if joints else "/ft/wrench", message, genpy.Time(secs, nsecs + 200000))
        bag.close()


# CDR --------------------------------------------------------------------------------------------------------------
class Cdr:
    def __init__(self, big=False):
        self.order = ">" if big else "<"
        self.data = b""
        self.head = b"\0\0\0\0" if big else b"\0\1\0\0"

    def put(self, form, *values):
        for value in values:
            size = struct.calcsize(form)
            self.data += b"\0" * (-len(self.data) % size) + struct.pack(self.order + form, value)

    def text(self, value):
        self.put("I", len(value) + 1)
        self.data += value.encode() + b"\0"

    def doubles(self, values):
        self.put("I", len(values))
        self.put("d", *values)

    def header(self, t, frame):
        secs, nsecs = stamp(t)
        self.put("i", secs)
        self.put("I", nsecs)
        self.text(frame)

    def bytes(self):
        return self.head + self.data


def cdr_joints(t, big=False):
    out = Cdr(big)
    out.header(t, "")
    order = [3, 0, 1, 2, 4, 5, 6]  # not in the order of the arm
    out.put("I", 7)
    for j in order:
        out.text(NAMES[j])
    out.doubles([q(t)[j] for j in order])
    out.doubles([])
    out.doubles([])
    return out.bytes()


def cdr_wrench(t, big=False):
    out = Cdr(big)
    out.header(t, "ft_sensor")
    out.put("d", *wrench(t))
    return out.bytes()


def make_sqlite():
    folder = os.path.join(HERE, "ros2_bag")
    os.makedirs(folder, exist_ok=True)
    path = os.path.join(folder, "ros2_bag_0.db3")
    if os.path.exists(path):
        os.remove(path)
    db = sqlite3.connect(path)
    db.execute("CREATE TABLE topics(id INTEGER PRIMARY KEY,name TEXT NOT NULL,type TEXT NOT NULL,"
               "serialization_format TEXT NOT NULL,offered_qos_profiles TEXT NOT NULL)")
    db.execute("CREATE TABLE messages(id INTEGER PRIMARY KEY,topic_id INTEGER NOT NULL,timestamp INTEGER NOT NULL,"
               "data BLOB NOT NULL)")
    db.execute("INSERT INTO topics VALUES(1,'/joint_states','sensor_msgs/msg/JointState','cdr','')")
    db.execute("INSERT INTO topics VALUES(2,'/ft/wrench','geometry_msgs/msg/WrenchStamped','cdr','')")
    db.execute("INSERT INTO topics VALUES(3,'/rosout','rcl_interfaces/msg/Log','cdr','')")
    for t, joints in samples():
        data = cdr_joints(t) if joints else cdr_wrench(t)
        secs, nsecs = stamp(t)
        db.execute("INSERT INTO messages(topic_id,timestamp,data) VALUES(?,?,?)",
                   (1 if joints else 2, secs * 1000000000 + nsecs + 300000, data))
    db.commit()
    db.close()
    with open(os.path.join(folder, "metadata.yaml"), "w") as out:
        out.write("rosbag2_bagfile_information:\n  version: 5\n  storage_identifier: sqlite3\n"
                  "  relative_file_paths:\n    - ros2_bag_0.db3\n  duration:\n    nanoseconds: 995000000\n")
    subprocess.check_call(["zstd", "-q", "-f", path, "-o", os.path.join(HERE, "ros2_compressed.db3.zstd")])


# MCAP -------------------------------------------------------------------------------------------------------------
MAGIC = b"\x89MCAP0\r\n"
HEADER = "builtin_interfaces/Time stamp\nstring frame_id\n"
TIME = "int32 sec\nuint32 nanosec\n"
BORDER = "=" * 80 + "\n"
JOINTS = ("# comment\nstd_msgs/Header header\n\nstring[] name\nfloat64[] position\nfloat64[] velocity\n"
          "float64[] effort\n" + BORDER + "MSG: std_msgs/Header\n" + HEADER + BORDER +
          "MSG: builtin_interfaces/Time\n" + TIME)
WRENCH = ("std_msgs/Header header\nWrench wrench\n" + BORDER + "MSG: geometry_msgs/Wrench\nVector3 force\n"
          "Vector3  torque\n" + BORDER + "MSG: geometry_msgs/Vector3\nfloat64 x\nfloat64 y\nfloat64 z\n" + BORDER +
          "MSG: std_msgs/Header\n" + HEADER + BORDER + "MSG: builtin_interfaces/Time\n" + TIME)


def text(value):
    data = value.encode()
    return struct.pack("<I", len(data)) + data


def record(op, content):
    return struct.pack("<BQ", op, len(content)) + content


def lz4_frame(data):
    return subprocess.run(["lz4", "-c", "-q"], input=data, stdout=subprocess.PIPE, check=True).stdout


def make_mcap():
    import zstandard
    for compression in ["", "zstd", "lz4"]:
        out = MAGIC + record(1, text("ros2") + text("by hand"))
        head = record(3, struct.pack("<H", 1) + text("sensor_msgs/msg/JointState") + text("ros2msg") + text(JOINTS))
        head += record(3, struct.pack("<H", 2) + text("geometry_msgs/msg/WrenchStamped") + text("ros2msg") +
                       text(WRENCH))
        head += record(4, struct.pack("<HH", 7, 1) + text("/joint_states") + text("cdr") + struct.pack("<I", 0))
        head += record(4, struct.pack("<HH", 8, 2) + text("/ft/wrench") + text("cdr") + struct.pack("<I", 0))
        messages = []
        for k, (t, joints) in enumerate(samples()):
            data = cdr_joints(t, True) if joints else cdr_wrench(t)
            secs, nsecs = stamp(t)
            time = secs * 1000000000 + nsecs
            messages.append(record(5, struct.pack("<HIQQ", 7 if joints else 8, k, time + 1000, time) + data))
        if compression:
            for part in range(3):
                block = (head if part == 0 else b"") + b"".join(messages[100 * part:100 * part + 100])
                packed = zstandard.compress(block) if compression == "zstd" else lz4_frame(block)
                out += record(6, struct.pack("<QQQI", 0, 0, len(block), 0) + text(compression) +
                              struct.pack("<Q", len(packed)) + packed)
                out += record(7, b"message index, to be skipped")
        else:
            out += head + b"".join(messages)
        out += record(0x0F, struct.pack("<I", 0)) + record(2, struct.pack("<QQI", 0, 0, 0)) + MAGIC
        with open(os.path.join(HERE, "plain.mcap" if not compression else compression + ".mcap"), "wb") as file:
            file.write(out)


# HDF5 -------------------------------------------------------------------------------------------------------------
def make_hdf5():
    import h5py
    import numpy
    with h5py.File(os.path.join(HERE, "log.h5"), "w") as file:
        robot = file.create_group("robot")
        times = [t for t, joints in samples() if joints]
        robot.create_dataset("time", data=numpy.array([t + START for t in times]))
        robot.create_dataset("q", data=numpy.array([q(t) for t in times]), compression="gzip")
        robot.create_dataset("dq", data=numpy.array([dq(t) for t in times]))
        sensor = file.create_group("sensor")
        times = [t for t, joints in samples() if not joints]
        stamps = numpy.array([(START * 1000000 + round(1000000 * t)) for t in times], dtype="int64")
        sensor.create_dataset("timestamp", data=stamps)  # microseconds
        sensor.create_dataset("ft", data=numpy.array([wrench(t) for t in times], dtype="float32").T)
        file.create_dataset("image", data=numpy.zeros((4, 5, 6)))


if __name__ == "__main__":
    for make in [make_bags, make_sqlite, make_mcap, make_hdf5]:
        make()
    sys.exit(0)
