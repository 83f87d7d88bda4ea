// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// The simulated board's memory as a whole, its files, profile sets and scripts (errata 3.21 and 3.23). Which
// address holds what no document tells; here the blocks lie one after the other.
#include "protocol/simplebgc/messages.h"
#include "protocol/simulator/simplebgc/board.h"

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace simplebgc {

namespace {

constexpr int kUnit = 64;
constexpr int kLargestPart = 192;
constexpr int kProfileRegion = 1024;
constexpr std::array<int, 4> kBlockOffsets{0, 192, 320, 512};
constexpr int kSlotsAt = 5 * kProfileRegion;
constexpr int kNamesAt = kSlotsAt + 192;
constexpr int kExternalAt = 6 * kProfileRegion;
constexpr int kExternalSize = 128;
constexpr int kFlash = 65536;  // bytes of all files
constexpr int kNotFound = 2;  // file errors (errata 3.18)
constexpr int kNoSpace = 4;
constexpr int kWrongFileSize = 6;
constexpr int kBackupSlot = 6;
constexpr double kLineTime = 0.1;  // seconds of a script's command
constexpr int kCalibrationFile = 3;
constexpr double kCalibrationUnit = 1e-6;

void place(QByteArray &memory, int at, const QByteArray &bytes)
{
    memory.replace(at, bytes.size(), bytes);
}

int fileKey(ByteReader &reader)
{
    const int type = reader.u8();
    return type + (reader.u8() << 8);
}

}  // namespace

QByteArray SimulatedBoard::memory() const
{
    QByteArray bytes = m_restOfMemory;
    for (int profile = 0; profile < kProfileCount; ++profile) {
        for (const int block : {Params3, ParamsExt, ParamsExt2, ParamsExt3})
            place(bytes, profile * kProfileRegion + kBlockOffsets[std::size_t(block)],
                  m_eeprom[std::size_t(profile)][std::size_t(block)]);
    }
    place(bytes, kSlotsAt, m_eeprom[0][AdjVarsCfg]);
    place(bytes, kNamesAt, encodeProfileNames(m_names));
    place(bytes, kExternalAt, m_external);
    return bytes;
}

// In use it is after the next start.
void SimulatedBoard::setMemory(const QByteArray &bytes)
{
    m_restOfMemory = bytes;
    for (int profile = 0; profile < kProfileCount; ++profile) {
        Block &blocks = m_eeprom[std::size_t(profile)];
        for (const int block : {Params3, ParamsExt, ParamsExt2, ParamsExt3})
            blocks[std::size_t(block)] = bytes.mid(
                profile * kProfileRegion + kBlockOffsets[std::size_t(block)], kBlocks[block].size);
        blocks[AdjVarsCfg] = bytes.mid(kSlotsAt, kAdjVarsCfgSize);
    }
    const QByteArray names = bytes.mid(kNamesAt, kProfileCount * kProfileNameSize);
    if (const auto read = decodeProfileNames(asBytes(names)))
        m_names = *read;
    m_external = bytes.mid(kExternalAt, kExternalSize);
}

bool SimulatedBoard::handleMemory(const Frame &frame)
{
    ByteReader reader(frame.payload);
    switch (static_cast<CommandId>(frame.id)) {
    case CommandId::EepromRead: {
        const quint32 address = reader.u32();
        const int size = reader.u16();
        const bool fits = reader.ok() && address % kUnit == 0 && size % kUnit == 0 && size >= kUnit
            && size <= kLargestPart && address + quint32(size) <= kMemorySize;
        if (fits)
            reply(frame, CommandId::EepromRead,
                  ByteWriter().u32(address).take() + memory().mid(qsizetype(address), size));
        else
            refuse(frame, kWrongParameters);
        return true;
    }
    case CommandId::EepromWrite: {
        const quint32 address = reader.u32();
        const QByteArray bytes = frame.payload.mid(4);
        const bool fits = reader.ok() && !bytes.isEmpty() && address % kUnit == 0 && bytes.size() % kUnit == 0
            && address + quint32(bytes.size()) <= kMemorySize;
        if (!fits) {
            refuse(frame, kWrongParameters);
            return true;
        }
        QByteArray all = memory();
        place(all, int(address), bytes);
        setMemory(all);
        confirm(frame, ByteWriter().u32(address).take());
        return true;
    }
    case CommandId::ReadExternalData: reply(frame, CommandId::ReadExternalData, m_external); return true;
    case CommandId::WriteExternalData:
        if (hasSize(frame, kExternalSize)) {
            m_external = frame.payload;
            confirm(frame);
        }
        return true;
    case CommandId::ReadFile: sendFile(frame); return true;
    case CommandId::WriteFile: takeFile(frame); return true;
    case CommandId::FsClearAll:
        m_files.clear();
        useRipple();
        m_replies.push_back(
            {m_now + 5.0, encodeFrame(number(CommandId::Confirm), QByteArray("\x37\x00", 2), frame.version)});
        return true;
    case CommandId::ProfileSet:
        if (m_options.firmware < kLater)
            return false;
        profileSet(frame);
        return true;
    case CommandId::RunScript: {
        if (!hasSize(frame, 34))
            return true;
        const int mode = reader.u8();
        const int slot = reader.u8();
        if (mode == 0) {
            m_script = {};
        } else if (mode > 2 || slot >= scriptSlots() || m_files.value(kScriptFile + (slot << 8)).isEmpty()) {
            refuse(frame, kWrongParameters);
            return true;
        } else {
            runScript(slot, mode == 2, frame.version);
        }
        confirm(frame);
        return true;
    }
    default: return false;
    }
}

void SimulatedBoard::sendFile(const Frame &frame)
{
    if (!hasSize(frame, 20))
        return;
    ByteReader reader(frame.payload);
    const int key = fileKey(reader);
    const int page = reader.u16();
    const int size = reader.u16();
    if (!m_files.contains(key)) {
        reply(frame, CommandId::ReadFile, QByteArray(1, char(kNotFound)));
        return;
    }
    const QByteArray &file = m_files[key];
    reply(frame, CommandId::ReadFile,
          ByteWriter()
              .u16(int(file.size()))
              .u16(page)
              .bytes(file.mid(page * kUnit, std::min(size, kLargestPart)))
              .take());
}

// The file has its new size with the first part, whatever becomes of the others; no data erase it.
void SimulatedBoard::takeFile(const Frame &frame)
{
    ByteReader reader(frame.payload);
    const int key = fileKey(reader);
    const int size = reader.u16();
    const int at = reader.u16() * kUnit;
    const QByteArray part = toByteArray(reader.take(reader.remaining()));
    if (!reader.ok()) {
        refuse(frame, kWrongSize);
        return;
    }
    int used = 0;
    for (auto it = m_files.cbegin(); it != m_files.cend(); ++it)
        used += it.key() == key ? 0 : int(it->size());
    int code = 0;
    if (part.isEmpty()) {
        code = m_files.remove(key) > 0 ? 0 : kNotFound;
    } else if (used + size > kFlash) {
        code = kNoSpace;
    } else if (at + part.size() > size) {
        code = kWrongFileSize;
    } else {
        QByteArray &file = m_files[key];
        file.resize(size, '\0');
        file.replace(at, part.size(), part);
    }
    useRipple();
    confirm(frame, QByteArray(1, char(code)));
}

void SimulatedBoard::profileSet(const Frame &frame)
{
    if (!hasSize(frame, 10))
        return;
    const int slot = quint8(frame.payload[0]);
    const int action = quint8(frame.payload[1]);
    if (slot < 1 || slot > kBackupSlot || action < 1 || action > 3) {
        refuse(frame, kWrongParameters);
        return;
    }
    std::vector<Block> &set = m_sets[std::size_t(slot - 1)];
    int refusal = 0;
    if (action == 1)
        set.assign(m_eeprom.begin(), m_eeprom.end());
    else if (action == 2)
        set.clear();
    else
        refusal = loadProfileSet(slot - 1);
    if (refusal)
        refuse(frame, refusal);
    else
        confirm(frame);
}

/// The code with which it is refused, 0 = it is in use.
int SimulatedBoard::loadProfileSet(int index)
{
    const std::vector<Block> &set = m_sets[std::size_t(index)];
    if (set.empty())
        return kWrongState;
    std::copy(set.begin(), set.end(), m_eeprom.begin());
    loadProfile(m_active);
    return 0;
}

int SimulatedBoard::scriptSlots() const
{
    return m_options.firmware < kLater ? 5 : 10;
}

// Only one runs: it takes the place of the one before.
void SimulatedBoard::runScript(int slot, bool isDebugged, int version)
{
    m_script = {slot, isDebugged, m_now + kLineTime, 0, version};
}

// Each sensor's calibration is a file of its own, which counts from the next start on. What is in it no
// document tells; here these are the figures.
void SimulatedBoard::keepCalibration(int imu)
{
    const SimulatedImu &from = sensor(imu);
    ByteWriter writer;
    for (const auto &figures : {from.gyroCorrection, from.accCorrection, from.accScale}) {
        for (const double figure : figures)
            writer.i32(qint32(std::lround(figure / kCalibrationUnit)));
    }
    m_files[kCalibrationFile + ((imu - 1) << 8)] = writer.take();
}

void SimulatedBoard::bootCalibrations()
{
    for (const int imu : {kMainImu, kFrameImu}) {
        const QByteArray file = m_files.value(kCalibrationFile + ((imu - 1) << 8));
        if (file.isEmpty())
            continue;
        ByteReader reader(file);
        SimulatedImu &to = sensor(imu);
        for (auto *figures : {&to.gyroCorrection, &to.accCorrection, &to.accScale}) {
            for (double &figure : *figures)
                figure = reader.i32() * kCalibrationUnit;
        }
    }
}

// What is compiled nobody outside can read, so it runs from the first to the last byte and does nothing. What
// is taken away under it ends it with the code of a file that is not there.
void SimulatedBoard::updateScript()
{
    if (m_script.slot < 0 || m_now < m_script.next)
        return;
    m_script.next += kLineTime;
    ++m_script.line;
    const qsizetype length = m_files.value(kScriptFile + (m_script.slot << 8)).size();
    if (m_script.isDebugged)
        send(CommandId::ScriptDebug, ByteWriter().u16(m_script.line).u8(length > 0 ? 0 : kNotFound).take(),
             m_script.version);
    if (m_script.line >= length)
        m_script = {};
}

}  // namespace simplebgc
