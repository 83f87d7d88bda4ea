// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/frame.h"
#include "protocol/session/stopplan.h"

#include <array>
#include <mutex>

namespace storm32 {

/// What is known while a board's motors are being stopped. Standby is acknowledged but ignored while the
/// board starts (errata 13, row 1); then the motors are disabled in RAM instead, until standby is proven.
/// Used by the I/O thread, which carries the plan out, and by the worker.
class MotorStop
{
public:
    static constexpr int kFirstWord = 78;  ///< motor usage of pitch, roll and yaw (errata 11)
    static constexpr int kWords = 3;
    static constexpr int kDisabled = 3;

    using MakeRequest
        = std::function<Request(int word, std::optional<int> value)>;  ///< reads without a value

    /// Takes an answer to a status request or to reading a word.
    /// @param firmware 79, 90, 96 ...
    Proof learn(const Frame &frame, int firmware);
    /// Asks for the words that are not known yet.
    std::vector<Request> ask(const MakeRequest &make);
    /// Disables the motors, as soon as the words are known, and reads them back.
    std::vector<Request> disable(const MakeRequest &make);
    /// What puts the words back; empty once nothing remains. Until standby is proven, only what asks for it.
    std::vector<Request> restore(const MakeRequest &make, const std::vector<Request> &standby);

    /// The motors are disabled in RAM: what the board holds there is not the operator's.
    [[nodiscard]] bool isActive() const;
    /// Those values, word by word, while the board holds others; else empty.
    [[nodiscard]] std::vector<int> replaced() const;
    /// Puts the operator's values of those words into what was read: words, two bytes each, from 0 on.
    void correct(QByteArray &stream) const;

private:
    mutable std::mutex m_mutex;
    std::array<int, kWords> m_before{-1, -1, -1};  // -1 = unknown
    std::array<int, kWords> m_now{-1, -1, -1};
    bool m_active = false;
    bool m_standby = false;  // proven by the latest status
};

}  // namespace storm32
