// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/workspace/page.h"
#include "protocol/analysis/holdingquality.h"
#include "protocol/analysis/spectrum.h"
#include "widgets/plot/spectrumchart.h"

#include <QMessageBox>
#include <QPointer>
#include <QTimer>

class ElidedLabel;
class QComboBox;
class QLabel;
class QPushButton;
class QTableWidget;
class QMenu;
class QStackedWidget;
class WaterfallView;

/// Vibration and what remains of it: spectra of the last seconds, their peaks, and the error in three bands.
class SpectrumPage final : public Page
{
    Q_OBJECT
public:
    explicit SpectrumPage(Workspace &workspace, QWidget *parent = nullptr);

    [[nodiscard]] SpectrumChart *chart() const { return m_chart; }
    [[nodiscard]] QTableWidget *peaks() const { return m_peaks; }
    [[nodiscard]] QTableWidget *bands() const { return m_bands; }
    [[nodiscard]] WaterfallView *waterfall() const { return m_waterfall; }
    [[nodiscard]] QMenu *viewMenu() const { return m_viewMenu; }
    [[nodiscard]] QPushButton *pauseButton() const { return m_pause; }
    [[nodiscard]] QPushButton *notchButton() const { return m_notch; }
    [[nodiscard]] std::any keep() override;
    void resume(const std::any &kept) override;
    /// What is advised about the chosen peak, or how the last trial went.
    [[nodiscard]] QLabel *advice() const { return m_advice; }

protected:
    void showEvent(QShowEvent *event) override;
    void hideEvent(QHideEvent *event) override;

private:
    enum class Signal { Gyro, Error };
    struct Line
    {
        Axis axis = Axis::None;
        SpectrumPeak peak;
        double wholeRms = 0;  // of the axis, vibration of all frequencies
        double commandedRms = 0;  // what the target makes of the line
    };
    /// RMS of one axis in one band, and what it was when the operator pressed Compare.
    struct Left
    {
        double rms = 0;
        double peak = 0;
        bool known = false;
    };
    using Bands = std::array<std::array<Left, 3>, 3>;  // axis, band
    /// What the operator compares with, and what is looked at.
    struct Kept
    {
        std::vector<SpectrumCurve> earlier;
        std::optional<Bands> before;
        int signal = 0;
        int span = 0;
    };

    void makeViewMenu();
    void offerHeldSpan();
    void refresh();
    void addOwn(std::size_t axis, const TelemetryStore &store);
    void drawCurves();
    void addWaterfall();
    /// One column of the second that ends then.
    void addColumn(double end);
    void fillWaterfall();
    [[nodiscard]] int waterfallChannel() const;
    [[nodiscard]] std::pair<double, double> spanOf(const TelemetryStore &store, int channel) const;
    void showPeaks(const QString &unit);
    void updateNotch();
    void askNotch();
    [[nodiscard]] const Line *chosenLine() const;
    [[nodiscard]] double commandedRms(Axis axis, const SpectrumPeak &peak, double from, double to) const;
    void nameBands(const std::vector<BandQuality> &measured);
    void showBands();
    [[nodiscard]] Signal signal() const;

    QComboBox *m_signal;
    QComboBox *m_span;
    QPushButton *m_view;
    QMenu *m_viewMenu;
    QPushButton *m_pause;
    QPushButton *m_compare;
    QPushButton *m_notch;
    QLabel *m_advice;
    ElidedLabel *m_note;
    QStackedWidget *m_pictures;
    SpectrumChart *m_chart;
    WaterfallView *m_waterfall;
    QTableWidget *m_peaks;
    QTableWidget *m_bands;
    QPointer<QMessageBox> m_question;
    QTimer m_timer;
    SpectrumScale m_scale;
    WindowShape m_window = WindowShape::Hann;
    Axis m_waterfallAxis = Axis::None;  // None: lines instead
    std::vector<SpectrumCurve> m_now;
    std::vector<SpectrumCurve> m_own;  // as the board computes them
    std::vector<SpectrumCurve> m_earlier;  // kept by Compare
    QString m_unit;
    std::vector<Line> m_lines;  // as the table shows them
    Bands m_left{};
    std::optional<Bands> m_before;
};
