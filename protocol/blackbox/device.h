// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/device/family.h"

namespace blackbox {

struct Table;

/// The black box of a drone (errata 10): what its program wrote down, to be looked at. Each of its names is a
/// channel, or as many as its lists have numbers. There is no board: nothing can be asked, set or moved.
class Device final : public ::Device
{
public:
    Result<bool> probe(Channel &channel) override;
    Result<BoardIdentity> identify(Channel &channel) override;
    [[nodiscard]] const BoardIdentity &identity() const override { return m_identity; }
    void setReadOnly() override { }
    [[nodiscard]] std::shared_ptr<const ParameterSet> parameters() const override;
    Result<Configuration> readConfiguration(Channel &channel) override;
    Result<QByteArray> readBlock(Channel &channel, BlockKey key) override;
    Result<void> writeBlock(Channel &channel, BlockKey key, const QByteArray &bytes) override;
    [[nodiscard]] std::span<const ActionSpec> actions() const override { return {}; }
    Result<ActionReply> perform(Channel &channel, const QString &key, const QVariantMap &arguments) override;
    [[nodiscard]] ChannelTable channels() const override;
    Result<TelemetryPlan> subscribe(Channel &channel, const Subscription &subscription,
                                    std::optional<LineSettings> line) override;
    [[nodiscard]] std::shared_ptr<TelemetryDecoder> replayDecoder() const override;
    [[nodiscard]] StopPlan stopPlan() const override;

private:
    BoardIdentity m_identity;
    const Table *m_table = nullptr;  // of all programs' life, as tables are
};

/// The row of this family. It lives on no link: only in files.
[[nodiscard]] Family family();

}  // namespace blackbox
