#!/usr/bin/env python3
"""Writes tests/fuzz/corpus: a few small inputs for every parser, from nothing and from tests/data/recordings."""
import json
import math
import pathlib
import sqlite3
import struct
import zlib

HERE = pathlib.Path(__file__).resolve().parent
CORPUS = HERE / "corpus"
RECORDINGS = HERE.parent / "data" / "recordings"


def put(parser, name, content):
    folder = CORPUS / parser
    folder.mkdir(parents=True, exist_ok=True)
    (folder / name).write_bytes(content if isinstance(content, bytes) else content.encode())


def table(separator=",", rows=24, header="time,q1,q2,q3,q4,q5,q6,q7,fx,fy,fz,tx,ty,tz"):
    lines = [header.replace(",", separator)] if header else []
    for k in range(rows):
        t = 0.01 * k
        values = [t] + [math.sin(t + j) for j in range(7)] + [math.cos(3 * t + a) for a in range(6)]
        lines.append(separator.join(f"{v:.6g}" for v in values))
    return "\n".join(lines) + "\n"


def cdr(values, pad=0):
    return b"\x00\x01\x00\x00" + b"\0" * pad + b"".join(struct.pack("<d", v) for v in values)


WRENCH = "Vector3 force\nVector3 torque\n" + "=" * 80 + "\nMSG: geometry_msgs/Vector3\nfloat64 x\nfloat64 y\nfloat64 z\n"
JOINTS = "string[] name\nfloat64[] position\nfloat64[] velocity\n"


def sqlite_bag():
    file = CORPUS / "bag.db3"
    file.unlink(missing_ok=True)
    db = sqlite3.connect(file)
    db.execute("PRAGMA page_size=512")
    db.execute("CREATE TABLE topics(id INTEGER PRIMARY KEY,name TEXT,type TEXT,serialization_format TEXT,offered_qos_profiles TEXT)")
    db.execute("CREATE TABLE messages(id INTEGER PRIMARY KEY,topic_id INTEGER,timestamp INTEGER,data BLOB)")
    db.execute("INSERT INTO topics VALUES(1,'/wrench','geometry_msgs/msg/Wrench','cdr','')")
    for k in range(8):
        db.execute("INSERT INTO messages VALUES(?,1,?,?)", (k, 10**18 + k * 10**7, cdr([k, 1, 2, 3, 4, 5])))
    db.commit()
    db.close()
    content = file.read_bytes()
    file.unlink()
    return content


def rtde(types, numbers):
    """What a controller of Universal Robots sends: version, a text, the outputs' types, rows."""

    def package(kind, content):
        return struct.pack(">H", 3 + len(content)) + kind + content

    out = package(b"V", b"\x01") + package(b"v", struct.pack(">4I", 5, 11, 0, 0))
    out += package(b"M", b"\x05hello\x04test\x01") + package(b"O", b"\x01" + types.encode()) + package(b"S", b"\x01")
    for k in range(4):
        row = [0.002 * k] + [0.1 * i + 0.01 * k for i in range(numbers - 1)]
        out += package(b"U", b"\x01" + struct.pack(f">{numbers}d", *row))
    return out + package(b"U", b"\x01" + struct.pack(f">{numbers}d", *[math.nan] * numbers))


def npy(rows=8):
    head = "{'descr': '<f8', 'fortran_order': False, 'shape': (%d, 14), }" % rows
    head += " " * (63 - (len(head) + 10) % 64) + "\n"
    body = b"".join(struct.pack("<d", 0.01 * k if c == 0 else math.sin(k + c)) for k in range(rows) for c in range(14))
    return b"\x93NUMPY\x01\x00" + struct.pack("<H", len(head)) + head.encode() + body


def mat4():
    name = b"time\0"
    values = b"".join(struct.pack("<d", 0.01 * k) for k in range(12))
    return struct.pack("<5i", 0, 12, 1, 0, len(name)) + name + values


def mat5(variables):
    """A file of version 5. Each variable: its class, sizes, name, what follows the name, and whether it is packed."""
    def element(kind, data):
        return struct.pack("<2I", kind, len(data)) + data + bytes(-len(data) % 8)

    out = b"MATLAB 5.0 MAT-file".ljust(124) + b"\0\1IM"
    for kind, sizes, name, rest, packed in variables:
        inner = element(6, struct.pack("<2I", kind, 0)) + element(5, struct.pack(f"<{len(sizes)}i", *sizes))
        matrix = element(14, inner + element(1, name) + rest)
        matrix = struct.pack("<2I", 15, len(zlib.compress(matrix))) + zlib.compress(matrix) if packed else matrix
        out += matrix
    return out


def damaged_mat5():
    """Files whose second variable asks for more than its bytes hold: cells, fields of a structure, numbers of a field."""
    def numbers(values):
        return struct.pack("<2I", 9, 8 * len(values)) + struct.pack(f"<{len(values)}d", *values)

    first = (6, (12, 1), b"time", numbers([0.01 * k for k in range(12)]), False)
    fields = struct.pack("<HHi", 5, 4, 8) + struct.pack("<2I", 1, 8) + b"force\0\0\0"
    field = struct.pack("<4I", 6, 8, 6, 0) + struct.pack("<2I2i", 5, 8, 30000, 30000) + struct.pack("<2I", 1, 0)
    field += numbers([1, 2])
    field = struct.pack("<2I", 14, len(field)) + field
    for packed in (False, True):
        end = "_packed.mat" if packed else ".mat"
        yield "many_cells" + end, mat5([first, (1, (20000, 20000), b"c", bytes(64), packed)])
        yield "many_elements" + end, mat5([first, (2, (20000, 20000), b"s", fields + bytes(64), packed)])
        yield "many_numbers" + end, mat5([first, (2, (1, 1), b"s", fields + field, packed)])


def main():
    for name, text in {
        "plain.csv": table(),
        "semicolons.csv": table(";").replace(".", ","),
        "poses.csv": "time,qx,qy,qz,qw,fx,fy,fz,tx,ty,tz,label\n"
        + "".join(f"{k},0,0,{math.sin(k):.6f},{math.cos(k):.6f},1,2,3,4,5,6,free\n" for k in range(12)),
        "odd.csv": "\ufeff\"time\",\"fx\"\r\n0,1e308\r\n1,nan\r\n,\r\n",
    }.items():
        put("csv", name, text)
        put("table", name, text)
        put("recording", name, text)
    put("table", "headless.csv", table(header=None))
    put("table", "lists.csv", "time,name,position,fx,fy,fz\n"
        + "".join(f"0.0{k},\"['a', 'b']\",\"[0.{k}, 1]\",1,2,3\n" for k in range(4)) + '0.05,"[(",")",1,2,3\n')
    put("table", "frames.csv", "time,child_frame_id,px,py,pz,qx,qy,qz,qw\n"
        + "".join(f"0.0{k},{frame},{k},0,0,0,0,0,1\n" for k in range(4) for frame in ("tool0", "cam", "")))
    put("table", "a_joint_a_row.csv", "time,joint,position\n"
        + "".join(f"0.0{k},j{j},{k}\n" for k in range(4) for j in range(3)))
    put("table", "echo.csv", "".join(f"17,{k},,a,b,0.{k},1\n18,{k},f,a,b,0.{k},1,\n" for k in range(3))
        + "".join(f"17,{k},,a,b,c,0.{k},1,2,3,4,5\n" for k in range(3)))
    lines = "".join(
        json.dumps({"time": 0.01 * k, "q": [0.1 * k] * 7, "wrench": {"force": {"x": k, "y": 1, "z": 2}, "torque": [1, 2, 3]}}) + "\n"
        for k in range(12)
    )
    put("json_lines", "nested.jsonl", lines)
    put("json_lines", "topics.jsonl", '{"topic":"/a","msg":{"header":{"stamp":{"secs":1,"nsecs":2}},"name":["j1"],"position":[1]}}\n'
        '{"topic":"/b","msg":{"force":{"x":1}}}\n{"topic":3,"msg":[]}\n{"topic":"/c","data":{"header":7}}\n')
    put("json_lines", "stamps.jsonl", '{"header":{"stamp":{"sec":9e18,"nanosec":999999999}},"fx":NaN}\n{"fx":[1,null]}\n')
    put("recording", "nested.jsonl", lines)
    put("ros_bag", "cut.bag", (RECORDINGS / "ros1_none.bag").read_bytes()[:6000])
    put("ros_bag", "lz4.bag", (RECORDINGS / "ros1_lz4.bag").read_bytes()[:8000])
    put("mcap", "cut.mcap", (RECORDINGS / "plain.mcap").read_bytes()[:5000])
    put("mcap", "zstd.mcap", (RECORDINGS / "zstd.mcap").read_bytes()[:9000])
    put("recording", "cut.mcap", (RECORDINGS / "plain.mcap").read_bytes()[:5000])
    bag = sqlite_bag()
    put("sqlite_bag", "bag.db3", bag)
    put("sqlite_bag", "head.db3", bag[:512])
    put("recording", "bag.db3", bag)
    put("hdf5", "log.h5", (RECORDINGS / "log.h5").read_bytes())
    put("matlab", "v4.mat", mat4())
    put("matlab", "v5.mat", (RECORDINGS / "log.mat").read_bytes())
    for name, data in damaged_mat5():
        put("matlab", name, data)
    put("numpy", "table.npy", npy())
    put("numpy", "log.npz", (RECORDINGS / "log.npz").read_bytes())
    put("recording", "table.npy", npy())
    put("meta", "full.json", json.dumps({
        "robot": "panda", "kind": "motion", "gravity_m_s2": [0, 0, -9.81], "angle_unit": "deg", "pose": "base_in_sensor",
        "sensor": {"mount": {"parent": "panda_link8", "xyz_m": [0, 0, 0.04], "rpy_rad": [0, 0, 1]}, "model": "Gamma",
                   "wrench_sign": "payload_on_sensor", "force_unit": "kgf", "torque_unit": 0.001, "wrench_point": [0, 0, 0.1]},
        "known_payload": {"mass_kg": 1, "com_m": [0, 0, 0.1], "inertia_com_kgm2": [[1, 0, 0], [0, 1, 0], [0, 0, 1]]},
        "marks": [{"from_s": 1, "to_s": 2, "label": "free"}]}))
    put("meta", "odd.json", '{"robot":null,"gravity_m_s2":[1e308,1e308,0],"marks":[{"from_s":2,"to_s":1,"label":"x"}]}')
    put("messages", "wrench", b"geometry_msgs/Wrench\n" + WRENCH.encode() + b"\0" + cdr([1, 2, 3, 4, 5, 6]))
    put("messages", "joints", b"sensor_msgs/JointState\n" + JOINTS.encode() + b"\0"
        + struct.pack("<II2sI2d", 1, 2, b"j1", 2, 0.1, 0.2) + struct.pack("<I", 0))
    transforms = ("a/T[] transforms\n" + "=" * 80 + "\nMSG: a/T\nstring child_frame_id\nfloat64 x\n").encode()
    put("messages", "transforms", b"a/TF\n" + transforms + b"\0" + struct.pack("<II2sd", 2, 2, b"t0", 1.0)
        + struct.pack("<Id", 0, 2.0))
    put("messages", "odd", b"a/B\nB b\nfloat64[4294967295] x\nstring<=9 s\nint8 X=1\n\0\0\1\0\0\xff\xff\xff\xff")
    put("map", "full.json", '{"use":{"wrench":"/ft","q1":"/arm:position[j1]","time":"t"},"scale":{"torque":0.001},"offset_s":{"/ft":0.01},'
        '"join":["w.csv"],"pose_of":"flange","clock":"header","rate_hz":125,"sensor":{"torque_unit":"N mm"}}')
    put("map", "odd.json", '{"offset_s":{"/ft":1e300},"rate_hz":-1}')
    for k, text in enumerate(["box:0.1,0.2,0.3@0,0,0.1,0,0,1", "cylinder:0.05,0.2", "tube:0.05,0.04,0.2:wall=0.001",
                              '{"bodies":[{"kind":"sphere","dims_m":[0.1],"xyz_m":[0,0,0],"rpy_rad":[0,0,0],"mass_kg":1},'
                              '{"kind":"mesh","file":"x.ply","unit":"mm"}],"certainty":"good","total_mass_kg":2}']):
        put("shape", f"shape{k}", text)
        put("shape_points", f"shape{k}", text)
    put("payload", "full.json", '{"mass_kg":1,"com_m":[0,0,0.1],"inertia_com_kgm2":[[1e-3,0,0],[0,1e-3,0],[0,0,1e-3]]}')
    put("payload", "part.json", '{"payload":{"mass_kg":-1,"com_m":[1e400,0]}}')
    link = '<link name="{}"><inertial><origin xyz="0 0 0.1"/><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>'
    joint = '<joint name="j{0}" type="{1}"><parent link="l{0}"/><child link="l{2}"/><origin xyz="0 0 0.3" rpy="0 1 0"/><axis xyz="0 0 1"/><limit lower="-1" upper="1" velocity="2" effort="9"/></joint>'
    put("urdf", "arm.urdf", '<?xml version="1.0"?><robot name="r">' + "".join(link.format(f"l{k}") for k in range(4))
        + joint.format(0, "revolute", 1) + joint.format(1, "prismatic", 2) + joint.format(2, "fixed", 3) + "</robot>")
    put("urdf_copy", "arm.urdf", '<?xml version="1.0"?>\n<robot name="r"><!-- a < b -->\n  <link name="base"/>\n  <link name=\'l1\'>\n    <visual/><inertial><mass value="1"/></inertial>\n'
        '  </link><link name="tool0"/>\n<joint name="j" type="fixed"><parent link="l1"/><child link="tool0"/></joint></robot>\n')
    put("urdf_copy", "odd.urdf", '\xef\xbb\xbf<robot name="&amp;"><link name="flange"><inertial/><inertial>\r\n</inertial ></link><link name="l1" /></robot')
    put("urdf", "odd.urdf", '<robot name="&amp;&#x41;"><!-- c --><link name="a"/><link name="b"/><joint name="j" type="continuous"><parent link="a"/>'
        '<child link="b"/><axis xyz="0 0 0"/><mimic joint="j" multiplier="nan"/></joint></robot>')
    put("session", "full.heft", json.dumps({
        "schema": "heft.session/1", "recordings": [{"file": "a.csv", "meta": "a.meta.json", "marks": [{"from_s": 1, "to_s": 2, "label": "contact"}]}],
        "current": 0, "step": "mark", "method": "map", "trim": 0.1, "shape": {"bodies": [{"kind": "box", "dims_m": [1, 1, 1]}]}}))
    put("session", "newer.heft", '{"schema":"heft.session/99"}')
    channel = {"id": 1, "topic": "/ft", "encoding": "json", "schemaName": "geometry_msgs/WrenchStamped", "schema": "", "schemaEncoding": ""}
    cdr_channel = {**channel, "id": 2, "encoding": "cdr", "schemaName": "geometry_msgs/msg/Wrench", "schema": WRENCH, "schemaEncoding": "ros2msg"}
    advertise = "t" + json.dumps({"op": "advertise", "channels": [channel, cdr_channel]})
    body = b'{"header":{"stamp":{"sec":5,"nanosec":7}},"wrench":{"force":{"x":1,"y":2,"z":3},"torque":{"x":1,"y":2,"z":3}}}'
    put("foxglove", "session", advertise.encode() + b"\x1eb\1" + struct.pack("<IQ", 1, 10**18) + body + b"\x1eb\1"
        + struct.pack("<IQ", 2, 2**63) + cdr([1, 2, 3, 4, 5, 6]))
    put("rosbridge", "session", '\x1e'.join([
        't{"op":"service_response","values":{"topics":["/ft","/js"],"types":["geometry_msgs/WrenchStamped","sensor_msgs/JointState"]},"result":true}',
        't{"op":"publish","topic":"/ft","msg":' + body.decode() + "}",
        't{"op":"publish","topic":"/js","msg":{"header":{"stamp":{"secs":-9e18,"nsecs":1}},"name":["a","b"],"position":[1,NaN],"velocity":[null,2]}}']))
    put("rtde", "session", rtde(types="DOUBLE,VECTOR6D,VECTOR6D,VECTOR6D,DOUBLE,VECTOR3D,VECTOR6D", numbers=29))
    put("rtde", "old_controller", rtde(types="DOUBLE,VECTOR6D,VECTOR6D,NOT_FOUND,NOT_FOUND,NOT_FOUND,NOT_FOUND", numbers=13))
    page = "<netft><scfgfu>N</scfgfu><scfgtu>N-m</scfgtu><cfgcpf>{}</cfgcpf><cfgcpt>{}</cfgcpt></netft>"
    records = [struct.pack(">3I6i", n, 7 * n % 2**32, n == 4, 10**6, -(10**6), 3, 2**31 - 1, -(2**31), 0) for n in (1, 2, 4, 3, 2**31, 9)]
    datagrams = [records[0], records[1] + records[2], records[3], records[4][:35], records[4], records[5] * 3]
    packed = b"".join(struct.pack(">H", len(d)) + d for d in datagrams)
    put("rdt", "session", page.format(10**6, 10**6).encode() + b"\0" + packed)
    put("rdt", "odd_counts", page.format("1e-320", "inf").encode() + b"\0" + packed)
    put("room", "full.json", json.dumps({"schema": "heft.room/1", "margin_m": 0.02, "obstacles": [
        {"name": "table", "plane": {"point_m": [0, 0, -0.1], "normal": [0, 0, 2]}},
        {"name": "rack", "box": {"size_m": [0.4, 0.3, 1], "xyz_m": [0.6, 0, 0.5], "rpy_rad": [0, 0, 0.3]}},
        {"name": "cell", "mesh": {"file": "cell.stl", "unit": "mm", "xyz_m": [0, 0, 0], "rpy_rad": [0, 0, 0]}}]}))
    put("room", "boxes.json", json.dumps({"schema": "heft.room/1", "obstacles": [
        {"box": {"size_m": [0.4, 0.3, 1]}}, {"name": "wall 2", "plane": {"point_m": [1, 0, 0], "normal": [-1, 0, 0]}}]}))
    put("room", "odd.json", '{"schema":"heft.room/1","margin_m":1e400,"obstacles":[{"name":3,"plane":{"normal":[0,0,0]}},{"box":{"size_m":[1e308,0,-1]}}]}')
    rows = [{"t": 0.01 * k, "q": [math.sin(k + j) for j in range(7)], "f": {"x": k, "y": None, "z": 1}} for k in range(12)]
    put("json_lines", "array_of_objects", json.dumps(rows))
    put("json_lines", "object_of_arrays", json.dumps({"t": [r["t"] for r in rows], "arm": {"q": [r["q"] for r in rows]}}, indent=1))
    put("udp", "lines", '{"time":1,"q1":0,"q2":0,"q3":0,"q4":0,"q5":0,"q6":0,"q7":0,"fx":1,"fy":2,"fz":3,"tx":4,"ty":5,"tz":6}\n{"a":{"b":[1,[2,{"c":3}]]}}\n[1]\n')
    put("udp", "units", '{"time_ms":1,"Fx (N)":1,"fy_kgf":2,"torque_kgf_cm[0]":4,"q1_deg":1e308,"_":1,"n_m_":2,"kgf":1}\n')
    facets = "".join(f"facet normal 0 0 1\nouter loop\nvertex 0 0 {k}\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n" for k in range(2))
    put("mesh", "ascii", "stl\nsolid x\n" + facets + "endsolid x\n")
    put("mesh", "binary", b"stl\n" + b"\0" * 80 + struct.pack("<I", 1) + struct.pack("<12f", *[0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0]) + b"\0\0")
    put("mesh", "obj", "obj\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nf 1//1 2//1 3//1\n")
    put("mesh", "ply", "ply\nply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
        "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")
    put("mesh", "off", "off\nOFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")


if __name__ == "__main__":
    main()
