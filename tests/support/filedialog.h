// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/support/patience.h"

#include <QApplication>
#include <QFileDialog>
#include <QTest>
#include <QWindow>

/// The dialog for files that stands, once it has the keyboard; null: there is none.
inline QFileDialog *fileDialog()
{
    const auto active = [] { return qobject_cast<QFileDialog *>(QApplication::activeWindow()); };
    return QTest::qWaitFor([active] { return active() != nullptr; }, kPatience) ? active() : nullptr;
}

/// Types a path into it. Keys go the way that they take from the window system, which ends at a widget that
/// is disabled.
inline void typePath(const QString &path)
{
    QWindow *window = QApplication::activeWindow()->windowHandle();
    QTest::keyClick(window, Qt::Key_A, Qt::ControlModifier);
    for (const QChar letter : path)
        QTest::keyClick(window, letter.toLatin1());
    QTest::keyClick(window, Qt::Key_Return);
}
