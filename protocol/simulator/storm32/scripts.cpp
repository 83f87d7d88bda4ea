// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// The simulated STorM32 board runs its scripts (errata 8, 13 row 18).
#include "protocol/simulator/storm32/board.h"

using namespace Qt::StringLiterals;

namespace storm32 {

namespace {

constexpr double kWaitUnit = 0.1;  // seconds
constexpr int kStepsPerCycle = 8;

int byteAt(const QByteArray &area, int at)
{
    return at < area.size() ? std::uint8_t(area[at]) : 0xFF;
}

int wordIn(const QByteArray &area, int at)
{
    return byteAt(area, at) | byteAt(area, at + 1) << 8;
}

}  // namespace

// Where a case begins; a script without cases is its own default.
int SimulatedBoard::caseOffset(int script, int chosen) const
{
    constexpr int kFirstCase = 0x03;
    const int start = byteAt(m_scriptArea, script);
    const auto &lines = m_scriptLines[std::size_t(script)];
    bool hasCases = false;
    for (const ScriptLine &line : lines) {
        const int op = byteAt(m_scriptArea, start + line.offset);
        if (op == kFirstCase + chosen)
            return line.offset + line.size;
        hasCases |= op >= kFirstCase && op < kFirstCase + 4;
    }
    return lines.empty() || hasCases || chosen != 0 ? -1 : 0;
}

// A script whose input is any source runs at once, even where nothing is connected to it.
void SimulatedBoard::runScripts()
{
    const QByteArrayView area = QByteArrayView(m_ram).sliced(2 * m_words);
    const bool isNew = area != QByteArrayView(m_scriptArea);
    if (isNew) {
        m_scriptArea = area.toByteArray();
        const ScriptContext context{{}, m_options.firmware};
        for (int script = 0; script < kScriptCount; ++script)
            m_scriptLines[std::size_t(script)] = disassemble(m_scriptArea, script, context);
    }
    for (int script = 0; script < kScriptCount; ++script) {
        ScriptRun &run = m_scriptRuns[std::size_t(script)];
        if (m_scriptLines[std::size_t(script)].empty())
            continue;
        const int input = inUse(m_layout >= 89 ? 120 + script : 119 + script);
        const int chosen = m_scriptCase[std::size_t(script)];
        if (input == 0) {
            run = {};
            continue;
        }
        if (isNew || run.input != input || run.chosen != chosen)
            run = {caseOffset(script, chosen), input, chosen, 0};
        for (int i = 0; i < kStepsPerCycle && run.at >= 0 && run.wakeAt <= m_now; ++i)
            step(script, run);
    }
}

void SimulatedBoard::step(int script, ScriptRun &run)
{
    const auto &lines = m_scriptLines[std::size_t(script)];
    const auto line = std::find_if(lines.begin(), lines.end(),
                                   [&run](const ScriptLine &each) { return each.offset == run.at; });
    if (line == lines.end()) {
        run.at = -1;
        return;
    }
    const int at = byteAt(m_scriptArea, script) + line->offset;
    run.at += line->size;
    switch (byteAt(m_scriptArea, at)) {
    case 0x01:
    case 0x02: run.at = caseOffset(script, run.chosen); return;
    case 0x08: std::ignore = rc(int(Rc::RestoreAllParameters), {}); return;
    case 0x09: run.wakeAt = m_now + byteAt(m_scriptArea, at + 1) * kWaitUnit; return;
    case 0x0A:
        if (byteAt(m_scriptArea, at + 1) < m_words)
            set(byteAt(m_scriptArea, at + 1), wordIn(m_scriptArea, at + 2));
        return;
    case 0x0C:
        std::ignore = rc(int(Rc::RestoreParameter), ByteWriter().u16(byteAt(m_scriptArea, at + 1)).take());
        return;
    case 0x15: std::ignore = rc(int(Rc::SetStandby), m_scriptArea.mid(at + 1, 1)); return;
    case 0x17: std::ignore = rc(int(Rc::SetPitchRollYaw), QByteArray(6, '\0')); return;
    case 0x18: std::ignore = rc(int(Rc::SetPwmOut), m_scriptArea.mid(at + 1, 2)); return;
    case 0x00:
    case 0x03:
    case 0x04:
    case 0x05:
    case 0x06: run.at = -1; return;  // the end of its case
    default: return;  // what it moves is not simulated
    }
}

}  // namespace storm32
