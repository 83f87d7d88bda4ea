// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/workspace/page.h"
#include "protocol/record/udpexport.h"
#include "widgets/models/channelmodel.h"
#include "widgets/plot/plotstack.h"

#include <QTimer>

class CurveChart;
class ElidedLabel;
class QComboBox;
class QMenu;
class QPushButton;
class QTreeView;
class SignsNote;
struct PlotLayout;

/// Chosen telemetry channels plotted live: by default one plot per unit, or as the operator arranges them.
class MonitorPage final : public Page
{
    Q_OBJECT
public:
    explicit MonitorPage(Workspace &workspace, QWidget *parent = nullptr);

    [[nodiscard]] ChannelModel &channels() { return m_channels; }
    [[nodiscard]] PlotStack *stack() const { return m_stack; }
    [[nodiscard]] QList<PlotView *> plots() const { return m_stack->plots(); }
    [[nodiscard]] QPushButton *pauseButton() const { return m_pause; }
    /// Seconds shown.
    [[nodiscard]] double window() const { return m_stack->seconds(); }
    [[nodiscard]] QPushButton *streamsButton() const { return m_streams; }
    /// Saves the visible span of the ticked channels. Errors: BadFile.
    Result<qint64> exportCsv(const QString &path);
    /// Saves the plots as they look, at twice the size. Errors: BadFile.
    Result<void> exportPicture(const QString &path) const;
    /// Forwards the ticked channels as JSON over UDP; an empty address stops it. Errors: InvalidArgument,
    /// NotConnected.
    Result<void> publish(const QString &hostAndPort);
    [[nodiscard]] const UdpExport *publication() const { return m_publication.get(); }
    [[nodiscard]] std::any keep() override;
    void resume(const std::any &kept) override;
    /// Saves the arrangement of plots under a name; restores a saved one.
    void saveLayout(const QString &name);
    void useLayout(const QString &name);

protected:
    void showEvent(QShowEvent *event) override;
    void hideEvent(QHideEvent *event) override;

private:
    /// What goes on in the page that takes this one's place.
    struct Kept
    {
        QByteArray plots;
        std::shared_ptr<UdpExport> publication;
        QString publishedTo;
    };
    void makeHeader();
    void makeBody();
    void connectAll();
    void watchPublication();
    void usePlots(const PlotLayout &layout);
    void onStore();
    void onTicks();
    void onPlotsEdited();
    void showPlots();
    void showChannelMenu(const QPoint &at);
    void updateNote();
    void showSeconds(double seconds);
    void fillLayoutMenu();
    void askLayoutName();
    void askExport();
    void askPicture();
    void askPublish();
    void askStreams();
    void updateRecord();
    void askRecording(const QString &title, Result<void> (LinkRecorder::*record)(const QString &));
    void refreshArrays();
    /// Ticked channels that are arrays, or that are none.
    [[nodiscard]] QList<int> ticked(bool arrays) const;
    [[nodiscard]] ChannelTable table() const;

    ChannelModel m_channels;
    QTreeView *m_tree;
    PlotStack *m_stack;
    CurveChart *m_arrayChart;  // the newest value of each ticked array, such as a spectrum
    QLabel *m_empty;
    QComboBox *m_window;
    QPushButton *m_layout;
    QMenu *m_layoutMenu;
    QPushButton *m_streams;
    QPushButton *m_pause;
    QPushButton *m_export;
    QPushButton *m_record;
    QMenu *m_recordMenu;
    ElidedLabel *m_note;
    SignsNote *m_signs;
    QTimer m_valueTimer;
    std::shared_ptr<UdpExport> m_publication;
    QString m_publishedTo;
    bool m_chosen = false;  // the operator (or the first board) has chosen channels
};
