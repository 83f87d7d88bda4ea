#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes tests/unit/sbgcvectors.h: payloads of SimpleBGC's serial API, packed here by hand after the document
and the errata (sections 2 and 3), with what stands in them. It knows nothing of the program's table."""
import struct
import sys

ROWS = []


def p(layout, *values):
    return struct.pack('<' + layout, *values)


def row(name, way, payload, fields='', firmware=99999):
    """way: > towards the board, < from it; fields: "name=number", in the units of the program; firmware: as of"""
    ROWS.append((name, way, payload, fields, firmware))


def count(n):
    return bytes(range(n))


D = 360 / 16384  # 14-bit angle
RATE = 0.06103701895
SPEED = 0.1220740379

# --- parameters: profile, then values ---
for name, size in (('PARAMS_3', 134), ('PARAMS_EXT', 104), ('PARAMS_EXT2', 151), ('PARAMS_EXT3', 221)):
    row('READ_' + name, '>', b'\x02', 'profile=2')
    row('READ_' + name, '<', count(size), 'profile=0')
    row('WRITE_' + name, '>', b'\x04' + count(size - 1), 'profile=4')
row('READ_PARAMS', '>', b'\xff', 'profile=255')
row('READ_PARAMS', '<', count(134), 'profile=0')
row('WRITE_PARAMS', '>', b'\x01' + count(133), 'profile=1')

# --- board ---
row('BOARD_INFO', '>', b'', '')
row('BOARD_INFO', '>', p('H', 20), 'gap=20')
row('BOARD_INFO', '<', p('BHBHBIHBBBH', 36, 2738, 5, 0x41, 1, 7, 3, 4, 5, 6, 2700),
    'board=3.6 firmware=2738 state=5 features=65 connection=1 extra=7 features.ext=3 imu.main=4 imu.frame=5 build=6 base=2700')
row('BOARD_INFO_3', '>', b'', '')
row('BOARD_INFO_3', '<', b'DEVICE-ID' + b'MCU-ID-12345' + p('I5HBBBH5HHIBBB', 32768, 1, 2, 3, 4, 5, 0x21, 2, 8, 0, 6, 7, 8, 9, 10, 1, 5, 1, 0, 80) + bytes(10),
    'eeprom=32768 script1=1 script5=5 sets.used=33 set=2 flash=8 script.more1=6 script.more5=10 hardware=1 features.ext2=5 can.main=1 can.aux=0 variables=80')
row('RESET', '>', p('BH', 1, 1000), 'notice=1 delay=1000')
row('RESET', '<', b'', '')
row('BOOT_MODE_3', '>', p('BH', 1, 500), 'notice=1 delay=500')
row('CONFIRM', '<', p('BI', 47, 128), 'command=47')
row('ERROR', '<', p('BB4s', 200, 6, b''), 'command=200 code=6')
row('MOTORS_ON', '>', b'', '')
row('MOTORS_OFF', '>', b'', '')
row('MOTORS_OFF', '>', b'\x02', 'how=2')
row('MOTORS_OFF', '>', b'', '', 2686)
row('USE_DEFAULTS', '>', b'\xfd', 'scope=253')
row('EXECUTE_MENU', '>', b'\x12', 'action=18')
row('EXECUTE_MENU', '>', b'\x12\x03', 'action=18 flags=3')
row('EXECUTE_MENU', '>', b'\x12', 'action=18', 2737)
row('READ_PROFILE_NAMES', '>', b'', '')
names = b''.join(n.encode().ljust(48, b'\0') for n in ('One', 'Zwei', 'Käse', '', 'V'))
row('READ_PROFILE_NAMES', '<', names, '')
row('WRITE_PROFILE_NAMES', '>', names, '')
row('PROFILE_SET', '>', p('BB8x', 6, 3), 'slot=6 action=3')
row('WRITE_PARAMS_SET', '>', b'\x01', 'action=1')
row('GET_PARAMS_3', '>', b'', '')
row('SIGN_MESSAGE', '>', p('B32s', 1, b'text'), 'type=1')
row('SIGN_MESSAGE', '<', count(32), '')
row('EVENT', '<', p('BB2s', 3, 2, b'\x05\x00'), 'event=3 type=2')
row('SET_DEBUG_PORT', '>', p('BI11x', 1, 0x10), 'on=1 filter=16')
row('SET_DEBUG_PORT', '<', p('HBB', 100, 1, 67) + b'ab', 'time=100 port=1 command=67')

# --- live data ---
axes3 = sum(([512 * (a + 1), 100 * (a + 1)] for a in range(3)), [])
rt3 = p('6hHHB3x4h2h3h3h3hHHBHBBB3B', *axes3, 3, 4, 5, 1500, 1501, 1502, 1503, 1504, 1505, 910, -455, 0, 1, 2, 3,
        100, 200, 300, 800, 6, 7, 1234, 1, 2, 3, 11, 12, 13)
assert len(rt3) == 63
rt3told = ('roll.acc=1 pitch.acc=2 yaw.acc=3 serial.errors=3 system.error=4 sub.error=5 rc.roll=1500 rc.cmd=1503 fc.roll=1504 '
           f'imu.roll={910 * D} imu.pitch={-455 * D} frame.yaw={3 * D} target.yaw={300 * D} cycle=800 i2c.errors=6 error=7 battery=12.34 '
           f'flags=1 imu.used=2 profile=3 power.roll=11 power.yaw=13 roll.gyro={100 * RATE}')
row('REALTIME_DATA_3', '>', b'', '')
row('REALTIME_DATA_3', '<', rt3, rt3told)
row('REALTIME_DATA', '>', b'', '')
rt4 = rt3 + p('3hx3hH3hbbBB3hBB3hI18x', 64, 128, 192, 1, 2, 3, 1500, 7, 8, 9, 41, -5, 15, 25, 10000, -5000, 0, 5, 6, 16, 32, 48, 0x2000)
assert len(rt4) == 124
row('REALTIME_DATA_4', '>', b'', '')
row('REALTIME_DATA_4', '<', rt4, rt3told + f' motor.roll={64 * D} balance.yaw=3 current=1500 mag.roll=7 temperature=41 frame.temperature=-5 '
    f'gravity.error=1.5 heading.error=2.5 output.roll=100 output.pitch=-50 calibration=5 can.error=6 actual.yaw={48 * D} state.debug=0 state.started=0 state.tripod=1')
row('REALTIME_DATA_CUSTOM', '>', p('I6x', 0x119), 'flags=281')
row('REALTIME_DATA_CUSTOM', '<', p('H', 500) + count(24), 'time=500')
row('REALTIME_DATA_CUSTOM2', '>', p('I6x', 3), 'flags=3')
row('REALTIME_DATA_CUSTOM2', '<', p('H', 500) + count(12), 'time=500')
row('DATA_STREAM_INTERVAL', '>', p('BH8sB9x', 25, 20, b'\x07', 1), 'command=25 interval=20 sync=1')
row('GET_ANGLES', '>', b'', '')
row('GET_ANGLES', '<', p('9h', 455, 456, 10, -2048, -2048, 0, 1365, 1365, 82),
    f'roll.imu={455 * D} roll.target={456 * D} roll.speed={10 * SPEED} pitch.imu={-2048 * D} yaw.speed={82 * SPEED}')
row('GET_ANGLES_EXT', '>', b'', '')
row('GET_ANGLES_EXT', '<', b''.join(p('hhi10x', a, a + 1, 20000 * a) for a in range(3)),
    f'pitch.imu={D} pitch.target={2 * D} yaw.motor={40000 * D}')
row('DEBUG_VARS_INFO_3', '>', b'', '')
row('DEBUG_VARS_INFO_3', '>', b'\x20', 'first=32')
row('DEBUG_VARS_INFO_3', '>', b'', '', 2719)
row('DEBUG_VARS_INFO_3', '<', b'\x01\x03ABCx\x01\x00'.replace(b'x', b'\x17'), 'count=1 variable1.type=23 variable1.size=1')
row('DEBUG_VARS_3', '>', b'', '')
row('DEBUG_VARS_3', '>', p('II', 5, 1), 'mask1=5 mask2=1')
row('DEBUG_VARS_3', '>', b'', '', 2719)
row('DEBUG_VARS_3', '<', count(9), '')
row('READ_RC_INPUTS', '>', p('HBB', 1, 2, 65), 'flags=1 source1=2 source2=65')
row('READ_RC_INPUTS', '<', p('hh', -16384, -32768), 'input1=-16384 input2=-32768')
row('READ_STATE_VARS', '>', b'', '')
state = p('6BBBIHH4b4BIfIf152x', 1, 2, 3, 4, 5, 6, 7, 48, 3600, 12, 900, -10, 50, -20, 70, 1, 2, 3, 4, 60, 1.5, 120, 0.25)
assert len(state) == 192
told = 'step1=1 step6=6 sub.error=7 shock=3 work=3600 starts=12 current.max=900 temperature1=-10 shocks4=4 energy.time=60 energy=1.5 average.time=120 average=0.25'
row('READ_STATE_VARS', '<', state, told)
row('WRITE_STATE_VARS', '>', state, told)

# --- steering ---
row('CONTROL', '>', p('B6h', 2, 246, 910, 0, 0, 1, 2), f'mode=2 roll.speed=246 roll.angle={910 * D} yaw.speed=1 yaw.angle={2 * D}', 2554)
row('CONTROL', '>', p('3B6h', 2, 0, 7, 246, 910, 0, 0, 1, 2), f'mode.roll=2 mode.yaw=7 roll.speed=246 roll.angle={910 * D} yaw.speed=1 yaw.angle={2 * D}')
row('CONTROL_CONFIG', '>', p('H4BB', 500, 1, 2, 3, 4, 5) + b''.join(p('BBBHBx', 6, 7, 8, 900, 5) for _ in range(3)) + p('BHB9x', 50, 3, 2),
    'timeout=500 uart1=1 usb=4 here=5 roll.lpf.angle=6 pitch.lpf.speed=7 yaw.lpf.rc=8 yaw.acceleration=900 yaw.jerk=100 expo=50 flags=3 euler=2')
# roll: speed and a fine angle; pitch: nothing; yaw: a fine speed alone
row('CONTROL_EXT', '>', p('HBBhiBBi', 0b01001_00000_00111, 2, 1, 100, 200000, 0x81, 0, -5000),
    f'set.roll.speed=1 set.roll.angle=1 set.roll.fine_angle=1 set.roll.fine_speed=0 set.pitch.speed=0 set.yaw.speed=1 set.yaw.fine_speed=1 '
    f'roll.mode.kind=2 roll.mode.fine=0 roll.flags.uncorrected=1 roll.speed={100 * SPEED} roll.angle={200000 * 360 / 2**20} '
    f'yaw.mode.kind=1 yaw.mode.fine=1 yaw.speed=-5')
# pitch alone: a short angle, with a speed in fine units by its mode
row('CONTROL_EXT', '>', p('HBBhh', 0b00011_00000, 0x82, 0, 1500, -910),
    f'set.pitch.speed=1 set.pitch.angle=1 set.roll.angle=0 pitch.mode.kind=2 pitch.mode.fine=1 pitch.speed=1.5 pitch.angle={-910 * D}')
# a signal is no angle
row('CONTROL_EXT', '>', p('HBBhBBi', 0b00110_00010_00000, 4, 0, -500, 6, 0, 16384), 'pitch.mode.kind=4 pitch.signal=-500 yaw.mode.kind=6 yaw.signal=16384')
row('CONTROL_EXT', '>', p('H', 0), 'set.roll.speed=0')


def quaternion(*parts):
    """errata 3.24; each: w, x, y, z"""
    word = at = 0
    largest = max(range(4), key=lambda i: abs(parts[i]))
    for i, part in enumerate(parts):
        if i != largest:
            word |= (round(abs(part) * 741453.786) | (part < 0) << 19) << at
            at += 20
    return struct.pack('<Q', word | largest << 60 | (parts[largest] < 0) << 62)


def unpacked(name, word):
    """what is left of it"""
    value = struct.unpack('<Q', word)[0]
    largest = value >> 60 & 3
    parts = [(1 - 2 * (value >> at + 19 & 1)) * (value >> at & 0x7FFFF) / 741453.786 for at in (0, 20, 40)]
    parts.insert(largest, (1 - 2 * (value >> 62 & 1)) * (1 - sum(part * part for part in parts)) ** 0.5)
    return ' '.join(f'{name}.{axis}={part!r}' for axis, part in zip('wxyz', parts))


turn = quaternion(0.1, -0.2, 0.3, -(0.86 ** 0.5))
half = quaternion(0.5 ** 0.5, 0.5 ** 0.5 - 1e-9, 0, 0)
row('CONTROL_QUAT', '>', p('BB', 0, 1), 'mode=0 flags.confirm=1')
row('CONTROL_QUAT', '>', p('BB4f', 2, 0x45, 0.5, -0.5, 0.5, 0.5),
    'mode=2 flags.confirm=1 flags.packed=0 flags.limited=1 flags.task=1 attitude.w=0.5 attitude.x=-0.5 attitude.z=0.5')
row('CONTROL_QUAT', '>', p('BB', 2, 2) + turn, 'mode=2 flags.packed=1 ' + unpacked('attitude', turn))
row('CONTROL_QUAT', '>', p('BB', 5, 2) + half + p('3f', 0.25, -0.5, 1), 'mode=5 speed.x=0.25 speed.y=-0.5 speed.z=1 ' + unpacked('attitude', half))
row('CONTROL_QUAT', '>', p('BB3f', 9, 0, 1.5, 0, 0), 'mode=9 speed.x=1.5')
row('CONTROL_QUAT_STATUS', '>', p('I', 0x209), 'set.mode=1 set.actual=1 set.actual.packed=1 set.target=0')
row('CONTROL_QUAT_STATUS', '<', p('IBH4f', 0x209, 5, 2, 1, 0, 0, 0) + turn, 'mode=5 flags.packed=1 actual.w=1 actual.z=0 ' + unpacked('actual.packed', turn))
row('CONTROL_QUAT_STATUS', '<', p('I4f4f3h3h3h', 0x76, 0, 1, 0, 0, 0, 0, 1, 0, *range(9)) ,
    f'target.x=1 setpoint.y=1 target.speed.y={RATE} setpoint.speed.x={3 * RATE} actual.speed.z={8 * RATE}')
row('CONTROL_QUAT_CONFIG', '>', p('H3H', 1, 90, 80, 70), f'set.speed=1 set.jerk=0 speed.x={90 * SPEED} speed.z={70 * SPEED}')
row('CONTROL_QUAT_CONFIG', '>', p('H3H3HHBB', 0b111110, 900, 800, 700, 30, 20, 10, 1, 5, 6),
    'set.acceleration=1 acceleration.x=900 acceleration.z=700 jerk.y=20 flags.split_axes=1 attitude.lpf=5 speed.lpf=6')
row('API_VIRT_CH_CONTROL', '>', p('3h', 500, -500, -10000), 'channel1=500 channel2=-500 channel3=-10000')
row('API_VIRT_CH_HIGH_RES', '>', p('2h', 16384, -32768), 'channel1=16384 channel2=-32768')
row('AHRS_HELPER', '>', p('H', 0x102), 'mode=258')
row('AHRS_HELPER', '>', p('H6f', 0x405, 0, 0, 1, 0, 1, 0), 'mode=1029 z.z=1 h.y=1', 2695)
row('AHRS_HELPER', '>', b'\x02', 'mode=2', 2694)
row('AHRS_HELPER', '>', p('B6f', 5, 0, 0, 1, 0, 1, 0), 'mode=5 z.z=1 h.y=1', 2694)
row('AHRS_HELPER', '<', p('6f', 0, 0, 1, 0.5, 0, 0), 'z.z=1 h.x=0.5')
row('GYRO_CORRECTION', '>', p('B4h', 1, 1000, -500, 0, 20), 'imu=1 zero.x=1 zero.y=-0.5 heading=0.02')
row('HELPER_DATA', '>', p('5h', 512, 0, -256, 455, -455), f'acc.x=1 acc.z=-0.5 roll={455 * D} pitch={-455 * D}')
row('HELPER_DATA', '>', p('5h', 512, 0, -256, 455, -455), f'acc.x=1 acc.z=-0.5 roll={455 * D} pitch={-455 * D}', 2589)
row('HELPER_DATA', '>', p('5hB3hhx', 512, 0, 0, 0, 0, 3, 10, 20, 30, 910), f'acc.x=1 system=3 speed.x={10 * RATE} speed.z={30 * RATE} heading={910 * D}')
row('SYNC_MOTORS', '>', p('BBHH', 1, 100, 500, 910), f'axis=1 power=100 time=500 angle={910 * D}')

# --- variables ---
row('SET_ADJ_VARS_VAL', '>', p('BBiBi', 2, 19, 100, 20, -5), 'count=2 variable1.id=19 variable1.value=100 variable2.id=20 variable2.value=-5')
row('SET_ADJ_VARS_VAL', '<', p('BBi', 1, 42, 45), 'count=1 variable1.id=42 variable1.value=45')
row('GET_ADJ_VARS_VAL', '>', p('4B', 3, 42, 43, 44), 'count=3 id1=42 id3=44')
row('SET_ADJ_VARS_VAL_F', '>', p('BBf', 1, 19, 1.5), 'count=1 variable1.id=19 variable1.value=1.5')
row('SET_ADJ_VARS_VAL_F', '<', p('BBf', 1, 19, 2.5), 'count=1 variable1.value=2.5')
row('GET_ADJ_VARS_VAL_F', '>', p('2B', 1, 19), 'count=1 id1=19')
row('SAVE_PARAMS_3', '>', b'', '')
row('SAVE_PARAMS_3', '>', b'\x13\x14', 'id1=19 id2=20')
row('SAVE_PARAMS_3', '>', b'', '', 2688)
slots = b''.join(bytes((t, 1, 2, 3, 4, 5)) for t in range(10)) + b''.join(bytes((s, s + 1, 0, 255)) for s in range(15)) + bytes(8)
slottold = 'trigger1.source=0 trigger10.source=9 trigger10.action5=5 analog1.variable=1 analog15.source=14 analog15.variable=15 analog15.max=255'
row('READ_ADJ_VARS_CFG', '>', b'', '')
row('READ_ADJ_VARS_CFG', '<', slots, slottold)
row('WRITE_ADJ_VARS_CFG', '>', slots, slottold)
row('ADJ_VARS_STATE', '>', p('BB', 3, 14), 'trigger=3 analog=14', 2624)
row('ADJ_VARS_STATE', '<', p('hBhi', -500, 18, 250, -70000) + bytes(6), 'trigger=-500 action=18 analog=250 value=-70000', 2624)
row('ADJ_VARS_STATE', '>', p('BHBHB', 3, 65, 19, 66, 20), 'trigger=3 analog=65 variable=19 table=66 table.variable=20')
row('ADJ_VARS_STATE', '<', p('hBhfhf', -16384, 18, 8192, 1.5, 5, 2.5), 'trigger=-16384 action=18 analog=8192 value=1.5 table=5 table.value=2.5')
row('ADJ_VARS_INFO', '>', b'\x05', 'first=5')
row('ADJ_VARS_INFO', '<', b'\x02' + p('BB6shhi', 0, 6, b'P_ROLL', 0, 255, 60) + p('BB1shhi', 1, 1, b'X', -5, 5, 0),
    'total=2 variable1.id=0 variable1.max=255 variable1.value=60 variable2.min=-5')

# --- calibrations ---
for name in ('CALIB_ACC', 'CALIB_GYRO', 'CALIB_MAG'):
    row(name, '>', b'', '')
    row(name, '>', p('BBH8x', 2, 3, 4000), 'imu=2 action=3 time=4000')
    row(name, '>', p('BB10x', 2, 3), 'imu=2 action=3', 2599)
row('CALIB_BAT', '>', p('H', 1234), 'voltage=12.34')
for name in ('CALIB_EXT_GAIN', 'CALIB_MOTOR_MAG_LINK', 'CALIB_OFFSET', 'CALIB_POLES'):
    row(name, '>', b'', '')
row('ENCODERS_CALIB_OFFSET_4', '>', b'\xff', 'motor=255')
row('ENCODERS_CALIB_OFFSET_4', '>', b'', '', 2686)
row('ENCODERS_CALIB_FLD_OFFSET_4', '>', b'', '', 2600)
row('ENCODERS_CALIB_FLD_OFFSET_4', '>', p('3h', 1820, 0, -910), f'angle.roll={1820 * D} angle.yaw={-910 * D}', 2626)
row('ENCODERS_CALIB_FLD_OFFSET_4', '>', p('3h3hH', 1820, 0, 0, 100, 0, 0, 1), f'angle.roll={1820 * D} speed.roll={100 * RATE} flags=1')
row('SELECT_IMU_3', '>', b'\x02', 'imu=2')
row('SELECT_IMU_3', '>', b'\x01', 'imu=1', 2599)
row('SELECT_IMU_3', '>', p('BBH', 2, 1, 500) + bytes(8), 'imu=2 action=1 time=500')
row('CALIB_INFO', '>', p('B11x', 1), 'imu=1')
row('CALIB_INFO', '<', p('BB3hHBBbBbbB6BbbB7x', 50, 1, 512, 0, -512, 20, 2, 0x15, 30, 1, -10, 40, 0, 1, 2, 3, 4, 5, 6, -5, 45, 150),
    'progress=50 imu=1 acc.x=1 acc.z=-1 gyro=20 axis=2 limits=21 temperature=30 gyro.temp=1 gyro.min=-10 gyro.max=40 slots1=1 slots6=6 acc.min=-5 acc.max=45 heading.error=1.5')
row('CALIB_ORIENT_CORR', '>', bytes(16), '')
row('CALIB_COGGING', '>', p('BB', 1, 3) + b''.join(p('HBBH9x', 360, 50, 20, 30) for _ in range(3)) + p('B9x', 2),
    'action=1 axes=3 roll.angle=360 pitch.smooth=50 yaw.speed=20 yaw.period=30 iterations=2')
row('CALIB_ACC_EXT_REF', '>', p('3h14x', 0, 0, 512), 'acc.z=1')
row('AUTO_PID', '>', p('BBBBB14x', 1, 15, 128, 0, 0), 'profile=1 flags=15 gain=128')
row('AUTO_PID', '>', p('BBB16x', 1, 15, 128), 'profile=1 flags=15 gain=128', 2599)
row('AUTO_PID', '<', p('3B3B3B3HH', 1, 2, 3, 4, 5, 6, 7, 8, 9, 100, 200, 300, 12) + b''.join(p('f6x', 0.5 * (a + 1)) for a in range(3)) + bytes(10),
    'p.roll=1 i.pitch=5 d.yaw=9 lpf.yaw=300 iteration=12 roll.error=0.5 yaw.error=1.5')
tune2 = p('BH8x', 1, 1) + b'\x01' + b''.join(p('BBHBBB6x', 0b1011, 50, 300, 20, 30, 25) for _ in range(3)) + p('HxBBB4b12x', 0x8005, 10, 50, 3, -30, 0, 1, 10)
assert len(tune2) == 73
tune2told = ('action=1 command.send=1 version=1 roll.flags.enabled=1 roll.flags.lpf=1 roll.flags.notches=2 pitch.gain=50 yaw.stimulus=300 yaw.margin=2.5 '
             'flags.from_current=1 flags.all_profiles=0 flags.gain_only=1 flags.gain_at_start=1 from=1 to=50 positions.first=1 positions.second=1 '
             'positions.third=0 position1=-90 position4=30')
row('AUTO_PID2', '>', tune2, tune2told)
row('AUTO_PID2', '>', p('BH8x', 5, 0), 'action=5 command.send=0')
row('AUTO_PID2', '>', p('BH8x', 6, 1), 'action=6 command.send=1')
row('AUTO_PID2', '<', tune2, tune2told)
row('BODE_TEST_START_STOP', '>', p('BBHHBIBH16x', 1, 0, 100, 200, 2, 5000, 1, 3), 'axis=1 gain=100 end=200 system=2 samples=5000 mode=1 start=3')
row('BODE_TEST_START_STOP', '<', p('IHB15x', 5000, 8, 0), 'samples=5000 code=8 mode=0')
row('BODE_TEST_DATA', '<', p('B4f4H', 1, -1, -2, 3, 4, 0, 1, 65534, 2), 'counter=1 in.min=-1 out.max=4 sample1.in=0 sample2.in=65534 sample2.out=2')

# --- what actions send (tst_sbgclater) ---
row('CONTROL_CONFIG', '>', p('H5x', 500) + b''.join(p('3xH2x', a) for a in (50, 0, 900)) + bytes(13),
    'timeout=500 roll.acceleration=50 pitch.acceleration=0 yaw.acceleration=900 expo=0 flags=0')
row('CONTROL_QUAT_CONFIG', '>', p('H3H3H', 3, 246, 246, 246, 100, 100, 100), f'set.speed=1 set.acceleration=1 speed.y={246 * SPEED} acceleration.z=100')
row('CONTROL_QUAT', '>', p('BB4f', 2, 1, 0.75 ** 0.5, 0, 0.5, 0), 'mode=2 flags.confirm=1 attitude.y=0.5')
row('CONTROL_QUAT_STATUS', '>', p('I', 0x7f), 'set.mode=1 set.actual.speed=1 set.target.packed=0')
row('BODE_TEST_START_STOP', '>', p('BBHHBIBH16x', 2, 2, 1500, 150, 70, 5000, 0, 20), 'axis=2 type=2 gain=1500 end=150 system=70 samples=5000 start=20')
row('CALIB_ACC_EXT_REF', '>', p('3h14x', 256, -256, 358), f'acc.x=0.5 acc.y=-0.5 acc.z={358 / 512}')
row('CALIB_COGGING', '>', p('BB', 2, 4) + b''.join(p('HBBH9x', 40, 50, 0, 0) for _ in range(3)) + p('B9x', 3), 'action=2 axes=4 yaw.angle=40 iterations=3')
row('SERVO_OUT_EXT', '>', p('Ih', 1 << 17, 1200), 'mask=131072 servo1=1200')
row('GET_ADJ_VARS_VAL_F', '>', b'\x02\x00\x03', 'count=2 id1=0 id2=3')
row('CALIB_INFO', '>', p('B11x', 2), 'imu=2')
row('REALTIME_DATA_CUSTOM2', '>', p('I6x', 0x80000057), f'flags={0x80000057}')
row('AUTO_PID2', '>', p('BH8x', 6, 0), 'action=6 command.send=0')

# --- pins, sound, memory, files, scripts ---
row('TRIGGER_PIN', '>', b'\x10\x01', 'pin=16 state=1')
row('SERVO_OUT', '>', p('8h', 1500, -1, 0, 1000, 0, 0, 0, 0), 'servo1=1500 servo2=-1 servo4=1000')
row('SERVO_OUT_EXT', '>', p('Ihh', 3, 1500, 900), 'mask=3 servo1=1500 servo2=900')
row('BEEP_SOUND', '>', p('HBB8x2H', 32768, 5, 3, 987, 21000), 'sound=32768 length=40 decay=3 note1=987 note2=21000')
row('I2C_WRITE_REG_BUF', '>', b'\xd0\x6b\x01', 'address=208 register=107')
row('I2C_READ_REG_BUF', '>', b'\xd0\x75\x01', 'address=208 register=117 length=1')
row('I2C_READ_REG_BUF', '<', b'\x68', '')
row('WRITE_EXTERNAL_DATA', '>', count(128), '')
row('READ_EXTERNAL_DATA', '>', b'', '')
row('READ_EXTERNAL_DATA', '<', count(128), '')
row('EEPROM_WRITE', '>', p('I', 128) + count(64), 'address=128')
row('EEPROM_READ', '>', p('IH', 128, 64), 'address=128 size=64')
row('EEPROM_READ', '<', p('I', 128) + count(64), 'address=128')
row('READ_FILE', '>', p('BBHH14x', 1, 2, 3, 192), 'type=1 number=2 page=3 size=192')
row('READ_FILE', '<', p('HH', 500, 3) + count(64), 'size=500 page=3')
row('WRITE_FILE', '>', p('BBHH', 1, 2, 500, 3) + count(64), 'type=1 number=2 size=500 page=3')
row('FS_CLEAR_ALL', '>', b'', '')
row('RUN_SCRIPT', '>', p('BB32x', 2, 4), 'mode=2 slot=4')
row('RUN_SCRIPT', '>', p('BB32x', 1, 9), 'mode=1 slot=9')
row('RUN_SCRIPT', '>', p('BB32x', 0, 0), 'mode=0 slot=0')
row('SCRIPT_DEBUG', '<', p('HB', 17, 2), 'command=17 code=2')
row('SCRIPT_DEBUG', '<', p('HB', 300, 0), 'command=300 code=0')

# --- modules and motors outside ---
row('MODULE_LIST', '>', b'', '')
row('MODULE_LIST', '<', b'\x01' + p('BHHH6x', 3, 10, 20, 30), 'count=1 module1.id=3 module1.board=10 module1.firmware=30')
row('CAN_DEVICE_SCAN', '>', b'', '')
row('CAN_DEVICE_SCAN', '<', count(12) + b'\x07\x02', 'device1.id=7 device1.type=2')
row('EXT_IMU_DEBUG_INFO', '>', b'', '')
row('EXT_IMU_DEBUG_INFO', '<', p('BB4BBHHBB13x9f3f', 0b11_001_010, 0b01_011_000, 3, 4, 5, 6, 0b11_000_110, 800, 9, 10, 11, *([0.5] * 9), 1, 2, 3),
    'main.source.attitude=2 main.source.heading=1 main.source.present=1 main.source.processing=1 frame.source.attitude=0 frame.source.heading=3 '
    'frame.source.present=1 frame.source.processing=0 main.z.error=0.3 main.h.error=0.4 frame.z.error=0.5 frame.h.error=0.6 '
    'external.state=6 external.bad_magnetometer=1 external.no_gps=1 packets=800 parse.errors=9 heading.error=10 z.error=11 matrix9=0.5 acc.z=3')
row('EXT_IMU_CMD', '>', b'\x01ab', 'command=1')
row('EXT_IMU_CMD', '<', b'\x01cd', 'command=1')
row('EXT_SENS_CMD', '>', b'\x01\x02ab', 'sensor=1 command=2')
row('EXT_SENS_CMD', '<', b'\x02cd', 'command=2')
row('TRANSPARENT_SAPI', '>', b'\x01ab', 'target=1')
row('TRANSPARENT_SAPI', '<', b'abc', '')
row('CAN_DRV_TELEMETRY', '<', p('BH', 1, 500) + b'ab', 'driver=1 time=500')
# which bit says what, and the fields of the two states: the public rendering of the specification of 2025 that the errata cite
row('EXT_MOTORS_ACTION', '>', b'\x81\x04', 'motors.first=1 motors.confirm=1 motors.second=0 action=4')
row('EXT_MOTORS_CONTROL', '>', p('BBh', 1, 0, -5), 'motors.first=1 motors.confirm=0 set.wide_target=0 motor1.target=-5')
row('EXT_MOTORS_CONTROL', '>', p('BBihih', 0x83, 3, 70000, 7, -70000, 8),
    'motors.second=1 motors.confirm=1 set.wide_target=1 set.parameter=1 motor1.target=70000 motor1.parameter=7 motor2.target=-70000 motor2.parameter=8')
row('EXT_MOTORS_CONTROL', '>', p('BBhi', 4, 4, 5, 70000), 'motors.third=1 motor1.target=5 motor1.wide_parameter=70000')
row('EXT_MOTORS_CONTROL_CONFIG', '>', p('BHBHHHH', 1, 31, 2, 50, 100, 30, 40),
    'motors.first=1 set.mode=1 set.torque=1 mode=2 speed=100 acceleration=200 jerk=30 torque=40')
row('EXT_MOTORS_CONTROL_CONFIG', '>', p('BHHH', 2, 0b1010, 50, 30), 'motors.second=1 set.speed=1 set.mode=0 speed=100 jerk=30')
row('EXT_MOTORS_STATE', '>', p('BI', 1, 3), 'motors.first=1 set.mode=1 set.torque=1')
row('EXT_MOTORS_STATE', '<', p('BIBhhhhiihhiiHHHHHHHbb', 1, 0xFFFFF, 1, 10, -20, 100, -100, 1000000, -1000000, 910, -910, 2**18, -2**18,
                                5, 50, 60, 70, 80, 900, 12000, -3, 45),
    f'motor=1 mode=1 torque=10 torque.target=-20 speed={100 * SPEED} speed.target={-100 * SPEED} fine_speed={180 / 3.141592653589793} angle={910 * D} '
    'fine_angle=90 fine_angle.target=-90 state.motor=1 state.index_pin=1 speed.max=100 acceleration.max=120 jerk=70 torque.max=80 current=900 '
    'voltage=12000 temperature=-3 driver.temperature=45')
row('EXT_MOTORS_STATE', '<', p('BIHb', 2, 1 << 16 | 1 << 18, 250, 40), 'motor=2 set.current=1 current=250 temperature=40')


def main():
    out = ['// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors', '// SPDX-License-Identifier: GPL-3.0-or-later',
           '// Made by tests/support/sbgcvectors.py from the document and the errata.', '#pragma once', '',
           'struct SbgcVector', '{', '    const char *name;', "    char way;  // >: towards the board, <: from it", '    const char *hex;  // the payload',
           '    const char *fields;', '    int firmware;', '};', '', '// clang-format off', 'inline constexpr SbgcVector kSbgcVectors[] = {']
    for name, way, payload, fields, firmware in ROWS:
        assert len(payload) <= 255, name
        out.append(f'    {{"{name}", \'{way}\', "{payload.hex()}", "{fields}", {firmware}}},')
    out += ['};', '// clang-format on', '']
    with open(sys.argv[1], 'w') as file:
        file.write('\n'.join(out))


main()
