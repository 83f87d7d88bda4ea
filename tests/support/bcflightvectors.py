#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Works out the bytes of every BCFlight message from the errata alone (sections 1 to 7), without the program's code:
tests/support/bcflightvectors.py > tests/unit/bcflightvectors.h"""
import struct


def crc32c(data):
    crc = 0xFFFFFFFF
    for byte in data:
        crc ^= byte
        for _ in range(8):
            crc = (crc >> 1) ^ (0x82F63B78 if crc & 1 else 0)
    return crc ^ 0xFFFFFFFF


assert crc32c(b"123456789") == 0xE3069283

SHORT = {0x81, 0x82, 0x83, 0x85, 0x80}  # what the ground writes as one byte
rows = []


def u8(v): return struct.pack(">B", v)
def s8(v): return struct.pack(">b", v)
def u16(v): return struct.pack(">H", v)
def u32(v): return struct.pack(">I", v)
def s32(v): return struct.pack(">i", v)
def f32(v): return struct.pack(">f", v)
def le16(v): return struct.pack("<H", v)
def text(v): return v.encode() + b"\0"


def single(v): return struct.unpack(">f", struct.pack(">f", v))[0]


def add(name, wire, direction, payload=b"", numbers=(), words="", generations="ABCDEFG"):
    two = wire > 0xFF or (wire < 0x80 if direction == "d" else wire not in SHORT)
    head = struct.pack(">H", wire) if two else struct.pack(">B", wire)
    for generation in generations:
        rows.append((name, direction, generation, (head + payload).hex(), list(numbers), words))


def both(name, wire, payload=b"", numbers=(), words="", generations="ABCDEFG"):
    add(name, wire, "g", payload, numbers, words, generations)
    add(name, wire, "d", payload, numbers, words, generations)


def ask(name, wire, reply, numbers=(), words="", generations="ABCDEFG"):
    add(name, wire, "g", generations=generations)
    add(name, wire, "d", reply, numbers, words, generations)


# 6.1
ask("STATUS", 0x85, u32(5), [5], generations="FG")
add("STATUS", 0x80, "d", u32(2), [2], generations="ABCDE")
both("PING", 0x81, u16(0x1234) + u16(7), [0x1234, 7])
telemetry = le16(1234) + le16(987) + u8(15) + s8(-3) + u8(42) + u8(61) + s8(99) + s8(-70)
add("TELEMETRY", 0x82, "g", generations="CDEFG")
add("TELEMETRY", 0x82, "d", telemetry, [1234, 987, 15, -3, 42, 61, 99, -70])
# 6.2
add("CALIBRATE", 0x60, "g", u32(1) + f32(0.0), [1, 0])
add("CALIBRATE", 0x60, "d", u32(3), [3])
add("CALIBRATING", 0x61, "d", u32(1), [1])
add("SET_TIMESTAMP", 0x62, "g", u32(1700000000), [1700000000])
add("SET_TIMESTAMP", 0x62, "d", u32(0), [0])
add("ARM", 0x63, "g")
add("DISARM", 0x64, "g")
add("RESET_BATTERY", 0x65, "g", u32(0), [0])
add("CALIBRATE_ESCS", 0x66, "g")
add("SET_FULL_TELEMETRY", 0x67, "g", u32(1), [1])
add("DEBUG_OUTPUT", 0x68, "d", text("hello"), words="hello")
ask("GET_BOARD_INFOS", 0x69, text("Type:generic"), words="Type:generic")
ask("GET_SENSORS_INFOS", 0x6A, text("{\n}"), words="{\n}")
ask("GET_CAMERAS_INFOS", 0x6B, text("nil"), words="nil", generations="BCDEFG")
lua = "pid_roll = PID( 36, 50, 8 )\n"
checked = u32(crc32c(lua.encode())) + text(lua)
for wire, generations in ((0x6B, "A"), (0x70, "BCDEFG")):
    ask("GET_CONFIG_FILE", wire, checked, [crc32c(lua.encode())], lua, generations)
for wire, generations in ((0x6C, "A"), (0x71, "BCDEFG")):
    add("SET_CONFIG_FILE", wire, "g", checked, [crc32c(lua.encode())], lua, generations)
    add("SET_CONFIG_FILE", wire, "d", u32(1), [1], generations=generations)
for wire, generations in ((0x6D, "A"), (0x72, "BCDEFG")):
    add("UPDATE_UPLOAD_INIT", wire, "g", generations=generations)
data = "0123456789"
chunk = u32(crc32c(data.encode())) + u32(1024) * 2 + u32(len(data)) * 2 + data.encode()
for wire, generations in ((0x6E, "A"), (0x73, "BCDEFG")):
    add("UPDATE_UPLOAD_DATA", wire, "g", chunk, [crc32c(data.encode()), 1024, 1024, len(data), len(data)], data, generations)
    add("UPDATE_UPLOAD_DATA", wire, "d", u32(2), [2], generations=generations)
for wire, generations in ((0x6F, "A"), (0x74, "BCDEFG")):
    add("UPDATE_UPLOAD_PROCESS", wire, "g", u32(0xCAFEBABE), [0xCAFEBABE], generations=generations)
for name, old, new in (("ENABLE_TUN_DEVICE", 0x70, 0x75), ("DISABLE_TUN_DEVICE", 0x71, 0x76)):
    add(name, old, "g", generations="A")
    add(name, new, "g", generations="BCDEFG")
ask("GET_USERNAME", 0x1001, text("[unknown]"), words="[unknown]", generations="ABCDE")
ask("GET_USERNAME", 0x3001, text("pilot"), words="pilot", generations="FG")
# 6.3
three = [1.5, -2.25, 0.1]
for name, wire, generations in (("ROLL_PITCH_YAW", 0x16, "ABCDEFG"), ("ACCEL", 0x17, "ABCDEFG"), ("GYRO", 0x18, "ABCDEFG"),
                                ("MAGN", 0x19, "ABCDEFG"), ("GYRO_DTERM", 0x1C, "ABCDEFG"), ("RATES", 0x1D, "DEFG")):
    add(name, wire, "d", b"".join(f32(v) for v in three), [single(v) for v in three], generations=generations)
for name, wire in (("ALTITUDE", 0x12), ("CURRENT_ACCELERATION", 0x1B), ("VBAT", 0x30), ("TOTAL_CURRENT", 0x31),
                   ("CURRENT_DRAW", 0x32), ("BATTERY_LEVEL", 0x34)):
    add(name, wire, "d", f32(11.7), [single(11.7)])
outputs = [0.25, 0.5, 0.75, 1.125]
add("MOTORS_SPEED", 0x1A, "d", u32(4) + b"".join(f32(v) for v in outputs), outputs)
bins = [0.5, 1.5, 2.5, 0.0, 3.5, 4.5, 5.5, 0.0]
add("RATE_DNF_DFT", 0x1E, "d", u16(4 * len(bins)) + b"".join(struct.pack("<f", v) for v in bins), bins, generations="EFG")
for name, wire in (("PID_OUTPUT", 0x21), ("OUTER_PID_OUTPUT", 0x22), ("ROLL_PID_FACTORS", 0x23), ("PITCH_PID_FACTORS", 0x24),
                   ("YAW_PID_FACTORS", 0x25), ("OUTER_PID_FACTORS", 0x26)):
    gains = [5.77e-4, 6.11e-3, 2.12e-6]
    ask(name, wire, b"".join(f32(v) for v in gains), [single(v) for v in gains])
ask("HORIZON_OFFSET", 0x27, f32(1.25) + f32(-0.5), [1.25, -0.5])
for name, wire in (("CPU_LOAD", 0x35), ("CPU_TEMP", 0x36), ("RX_QUALITY", 0x37), ("STABILIZER_FREQUENCY", 0x39)):
    add(name, wire, "d", u32(4000), [4000])
add("RX_LEVEL", 0x38, "d", s32(-70), [-70])
# 6.4
for name, wire in (("SET_ROLL", 0x40), ("SET_PITCH", 0x41), ("SET_YAW", 0x42), ("SET_THRUST", 0x43)):
    add(name, wire, "g", f32(0.5), [0.5])
add("SET_THRUST", 0x43, "d", f32(0.5), [0.5])
add("RESET_MOTORS", 0x47, "g")
both("SET_MODE", 0x48, u32(1), [1])
both("SET_ALTITUDE_HOLD", 0x49, u32(1), [1])
names = [f"SET_{axis}_PID_{term}" for axis in ("ROLL", "PITCH", "YAW", "OUTER") for term in "PID"]
for number, name in enumerate(names):
    both(name, 0x50 + number, f32(0.125), [0.125])
both("SET_HORIZON_OFFSET", 0x5C, f32(-1.5) + f32(2.0), [-1.5, 2.0])
# 6.5
for name, wire, code in (("VIDEO_PAUSE", 0xA0, 1), ("VIDEO_RESUME", 0xA1, 0), ("VIDEO_START_RECORD", 0xA3, 1),
                         ("VIDEO_STOP_RECORD", 0xA4, 0), ("VIDEO_SHUTTER_SPEED", 0xBC, 200)):
    ask(name, wire, u32(code), [code])
add("VIDEO_TAKE_PICTURE", 0xA2, "g")
both("VIDEO_NIGHT_MODE", 0xA5, u32(1), [1])
steps = ("BRIGHTNESS", 0xB0, 0xB2), ("CONTRAST", 0xB3, 0xB4), ("SATURATION", 0xB5, 0xB6), ("ISO", 0xB7, 0xB8), ("SHUTTER_SPEED", 0xB9, 0xBA)
for name, up, down in steps:
    add(f"VIDEO_{name}_INCR", up, "g")
    add(f"VIDEO_{name}_DECR", down, "g")
ask("VIDEO_ISO", 0xBB, s32(-1), [-1])
for name, wire, answer in (("VIDEO_WHITE_BALANCE", 0xC1, "daylight"), ("VIDEO_EXPOSURE_MODE", 0xC2, ""),
                           ("VIDEO_LOCK_WHITE_BALANCE", 0xC3, "R1.50B2.25")):
    ask(name, wire, text(answer), words=answer)
shader = [32, 5, -32, 33, 6, -31, 34, 7, -30]
shaded = b"".join(s8(v) if i % 3 == 2 else u8(v) for i, v in enumerate(shader))
ask("VIDEO_LENS_SHADER", 0xC5, shaded, shader)
add("VIDEO_SET_LENS_SHADER", 0xC6, "g", shaded, shader)
recordings = "a.h264:1234:::;"
ask("GET_RECORDINGS_LIST", 0xD0, u32(crc32c(recordings.encode())) + text(recordings), [crc32c(recordings.encode())], recordings)
# 6.6
add("MOTOR_TEST", 0xE0, "g", u32(3), [3])
add("MOTORS_BEEP", 0xE1, "g", u16(1), [1], generations="DEFG")
powers = [14, 20, 26]
ask("VTX_GET_SETTINGS", 0x2001, u8(37) + u16(5880) + u8(1) + u8(20) + u8(3) + bytes(powers), [37, 5880, 1, 20] + powers, generations="EFG")
add("VTX_SET_POWER", 0x2002, "g", u8(2), [2], generations="EFG")
add("VTX_SET_POWER", 0x2002, "d", u8(2) + u8(26), [2, 26], generations="EFG")
add("VTX_SET_CHANNEL", 0x2003, "g", u8(1), [1], generations="EFG")
add("VTX_SET_CHANNEL", 0x2003, "d", u8(1) + u16(5865), [1, 5865], generations="EFG")
for name, wire in (("ERROR_DANGEROUS_BATTERY", 0x7301), ("ERROR_CAMERA_MISSING", 0x7F01), ("ERROR_MICROPHONE_MISSING", 0x7F02)):
    add(name, wire, "d")


def controls(thrust, roll, pitch, yaw, arm, smoothing):
    word = 0
    for shift, value in ((0, thrust), (10, roll), (20, pitch), (30, yaw)):
        word |= (value & 0x3FF) << shift
    return (word | arm << 40 | smoothing << 44).to_bytes(6, "little")


# Shares of full deflection, what they count, and the bytes of 4.3.
sticks = [(1.0, 0, 0, 0, 0, 0), (0, 0, 0, 0, 1, 0), (0.5, -1.0, 1.0, -0.5, 1, 0)]
drives = []
for share in sticks:
    counts = [int(v * 511) for v in share[:4]]
    for generation in "DEFG":
        drives.append((generation, share, controls(*counts, share[4], 0).hex()))
    old = [int(v * 127) for v in share[:4]]
    for generation in "ABC":
        drives.append((generation, share, (b"".join(s8(v) for v in old) + u8(share[4])).hex()))
drives.append(("G", (0, 0, 0, 0, 1, 1), controls(0, 0, 0, 0, 1, 1).hex()))
drives.append(("F", (0, 0, 0, 0, 1, 1), controls(0, 0, 0, 0, 1, 0).hex()))
assert drives[0][2] == "ff0100000000"  # 4.3

merged = {}
for name, direction, generation, bytes_, numbers, words in rows:
    key = (name, direction, bytes_, tuple(numbers), words)
    merged[key] = merged.get(key, "") + generation

quoted = lambda words: '"' + words.replace("\\", "\\\\").replace('"', '\\"').replace("\n", "\\n") + '"'
number = lambda v: repr(float(v)) if v != int(v) else str(int(v))
print("""// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// Made by tests/support/bcflightvectors.py from the errata.
#pragma once

#include <vector>

struct BcflightVector
{
    const char *name;
    char from;  // g: ground, d: drone
    const char *generations;
    const char *hex;
    std::vector<double> numbers;
    const char *text;
};

struct BcflightSticks
{
    char generation;
    double thrust, roll, pitch, yaw;
    bool arm, smoothing;
    const char *hex;  // the payload
};

// clang-format off
inline const BcflightVector kBcflightVectors[] = {""")
for (name, direction, bytes_, numbers, words), generations in merged.items():
    print(f"    {{\"{name}\", '{direction}', \"{generations}\", \"{bytes_}\", {{{', '.join(map(number, numbers))}}}, {quoted(words)}}},")
print("};\n\ninline const BcflightSticks kBcflightSticks[] = {")
for generation, share, bytes_ in drives:
    print(f"    {{'{generation}', {', '.join(map(number, share[:4]))}, {str(bool(share[4])).lower()}, {str(bool(share[5])).lower()}, \"{bytes_}\"}},")
print("};\n// clang-format on")
