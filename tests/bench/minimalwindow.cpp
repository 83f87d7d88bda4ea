// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QApplication>
#include <QTimer>
#include <QWidget>

#include <cstdio>

namespace {

/// The least a Qt window can be: what the benchmark measures the program against.
class MinimalWindow final : public QWidget
{
protected:
    void paintEvent(QPaintEvent *) override
    {
        std::fputs("gimbal.start: first paint\n", stderr);
        QTimer::singleShot(0, qApp, &QCoreApplication::quit);
    }
};

}  // namespace

int main(int argc, char **argv)
{
    QApplication application(argc, argv);
    MinimalWindow window;
    window.show();
    return QApplication::exec();
}
