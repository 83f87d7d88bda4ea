// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/linkloss.h"
#include "protocol/device/device.h"
#include "protocol/procedure/nameswrite.h"
#include "protocol/procedure/wholewrite.h"
#include "protocol/procedure/writeoptions.h"
#include "protocol/session/channel.h"

#include <functional>
#include <set>

/// Nothing more can be asked over this link.
[[nodiscard]] inline bool isLinkGone(const Error &error)
{
    return isLinkLoss(error) || error.code == ErrorCode::Cancelled || error.code == ErrorCode::NotConnected;
}

/// One run of writeConfiguration(): sequential, step by step. What it begins with and what it writes is in
/// writeconfiguration.cpp, how it is proven, taken back and told in writeproof.cpp.
class Writer
{
public:
    Writer(Channel &channel, Device &device, const Configuration &base, const Configuration &edited,
           const WriteOptions &options)
        : m_channel(channel)
        , m_device(device)
        , m_base(base)
        , m_edited(edited)
        , m_options(options)
        , m_whole(device, channel, options.others)
        , m_names(channel, device, base, edited)
    {
    }

    Result<WriteReport> run();

private:
    Result<void> backUp();
    void collectBlocks();
    Result<void> readBoard();
    Result<void> checkConflicts() const;
    Result<void> checkProfile();
    [[nodiscard]] QByteArray boardNow(BlockKey key) const;
    [[nodiscard]] bool isKnownLive(const ParameterChange &change, double now) const;
    Result<void> writeBlocks();
    Result<void> writeBracketed();
    Result<void> writeWhole();
    Result<void> storeWhole(const std::function<Result<void>()> &put);
    Result<void> readWhole();
    Result<QByteArray> truthOf(BlockKey key);
    void addNamed();
    void leaveUntold();
    Result<void> writeRestarting();
    Result<void> writeLost();
    Result<void> put(BlockKey key, const QByteArray &bytes);
    Result<QByteArray> fetch(BlockKey key);
    Result<QByteArray> fetchStored(BlockKey key);
    Result<QByteArray> fetchSettled(BlockKey key);
    [[nodiscard]] bool holdsAsBefore(BlockKey key);
    [[nodiscard]] QByteArray asStored(BlockKey key, QByteArray bytes, const LiveValues &live) const;
    Result<void> verify();
    void readStarted();
    bool rollBack();
    bool readSent();
    void readTruth(bool isBack);
    void findStrays(const std::set<BlockKey> &read);
    void finishReport(const Error &error);
    void lookForRestart();
    void noteSilence(TimePoint since);
    void noteGone(const Error &error)
    {
        if (isLinkGone(error))
            m_gone = error;
    }
    void readOthers();
    void tellReplaced();
    // For boards with a WriteBracket.
    Result<void> begin();
    Result<void> end();
    Result<void> selectActive();
    void settleProfile();
    void markBlock(BlockKey key, WriteState state);
    void report(const QString &step, BlockKey key);
    [[nodiscard]] QByteArray patched(BlockKey key) const;
    [[nodiscard]] std::map<BlockKey, QByteArray> patchedBlocks() const;
    [[nodiscard]] const ParameterSpec *specAt(int block, qsizetype byte) const;
    [[nodiscard]] QString placeOf(BlockKey key, qsizetype byte) const;
    [[nodiscard]] std::vector<bool> uncheckedBytes(int block) const;
    [[nodiscard]] const BlockSpec &specOf(BlockKey key) const
    {
        return *m_base.parameters().block(key.block);
    }
    [[nodiscard]] bool restarts(BlockKey key) const { return specOf(key).effect == WriteEffect::Restarts; }
    [[nodiscard]] bool isLost(BlockKey key) const { return specOf(key).effect == WriteEffect::Volatile; }

    Channel &m_channel;
    Device &m_device;
    const Configuration &m_base;
    const Configuration &m_edited;
    const WriteOptions &m_options;

    WriteReport m_report;
    std::vector<ParameterChange> m_changes;
    std::vector<DataChange> m_data;
    std::map<BlockKey, QByteArray> m_answered;  // before anything was written
    // In writing order: the active profile last, then what restarts, then what that loses.
    std::vector<BlockKey> m_keys;
    WholeWrite m_whole;  // for boards that can only store everything in use
    NamesWrite m_names;
    std::map<BlockKey, QByteArray> m_board;  // as read from the board before anything was written
    std::map<BlockKey, QByteArray> m_started;  // what a restart loses, as it is after one
    std::set<BlockKey> m_written;
    std::optional<bool> m_ranBefore;  // its motors
    std::optional<Error> m_gone;  // what a block met that was put or fetched while the link went
    std::vector<OtherValue> m_others;  // in use without being stored, beside what is written
    bool m_bracketOpen = false;
    TimePoint m_backBy{};  // until then a restarting board may be silent
    int m_done = 0;
};
