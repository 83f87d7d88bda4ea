// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/device/parameterspec.h"

#include <QWidget>

class QSlider;
class ValueEditor;

/// One live value: a slider and a number box that are one control. Drag, type, arrow keys; Shift with the
/// wheel or an arrow moves by single counts.
class LiveSlider final : public QWidget
{
    Q_OBJECT
public:
    /// @param range raw values that can be set live
    LiveSlider(const ParameterSpec &spec, std::pair<int, int> range, int firmware, QWidget *parent = nullptr);

    /// Shows the value in use and the stored one; empty = not known.
    void show(std::optional<int> value, std::optional<int> stored);
    [[nodiscard]] QSlider *slider() const { return m_slider; }
    [[nodiscard]] ValueEditor *editor() const { return m_editor; }

signals:
    void edited(int raw);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    const ParameterSpec &m_spec;
    ValueEditor *m_editor;
    QSlider *m_slider = nullptr;
    bool m_updating = false;
};
