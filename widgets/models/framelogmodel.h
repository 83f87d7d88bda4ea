// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/client/deviceclient.h"
#include "protocol/client/framelog.h"
#include "protocol/device/abilities.h"
#include "widgets/models/tablemodel.h"

#include <deque>

/// Frames in and out as rows, decoded when they are looked at, and with the board that they were of. A row of
/// its own tells where a link begins and ends. Follows all links from the beginning; keeps the newest
/// kCapacity.
class FrameLogModel final : public TableModel
{
    Q_OBJECT
public:
    enum Column { TimeColumn, DirectionColumn, NameColumn, FieldsColumn, BytesColumn, ColumnCount };
    enum Role { FromBoardRole = Qt::UserRole, SearchRole };
    static constexpr std::size_t kCapacity = 20000;

    explicit FrameLogModel(DeviceClient &client, QObject *parent = nullptr);

    /// Takes over what is new; call at most 10 times a second. Live data is left out unless wanted.
    void refresh();
    /// Nothing new comes while paused, except where a link ends: its frames are taken over before.
    void setPaused(bool paused) { m_paused = paused; }
    void setShowsStreams(bool on) { m_showsStreams = on; }
    void clear();
    /// All rows as text, one line each.
    [[nodiscard]] QString text() const;

    [[nodiscard]] QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;

private:
    [[nodiscard]] int rows() const override { return int(m_rows.size()); }
    struct Row
    {
        LoggedFrame frame;  // number 0: no frame but a mark, whose words the text is
        mutable std::optional<FrameText> text;
    };
    void onState(DeviceClient::State state);
    void settle();
    void addRows(std::vector<Row> fresh);
    void addMark(const QString &what, const QString &more = {});
    [[nodiscard]] static bool isMark(const Row &row) { return row.frame.number == 0; }
    [[nodiscard]] const FrameText &textOf(const Row &row) const;
    [[nodiscard]] QString timeText(const Row &row) const;

    DeviceClient &m_client;
    std::deque<Row> m_rows;
    quint64 m_seen = 0;
    std::optional<TimePoint> m_origin;  // of the first frame that was seen
    bool m_showsStreams = false;
    bool m_paused = false;
    bool m_isKnown = false;  // which board the frames of this link are of
};
