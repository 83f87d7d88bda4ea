// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPushButton>

/// A field in which several choices can be ticked: looks like a choice, shows what is ticked as far as it
/// fits.
class FlagsButton final : public QPushButton
{
    Q_OBJECT
public:
    explicit FlagsButton(QWidget *parent = nullptr);

    /// What is ticked, all of it.
    void setWords(const QString &words);

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    QString m_words;
};
