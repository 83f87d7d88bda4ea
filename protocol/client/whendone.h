// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QFuture>
#include <QPointer>

#include <utility>

/// Calls the function with the result on the main thread, unless the context is gone by then: pages may end
/// before what they asked for. (QFuture::then() with such a context fails an assertion in Qt 6.4.)
template <typename T, typename Function> void whenDone(QFuture<T> future, QObject *context, Function function)
{
    future.then(QCoreApplication::instance(),
                [guard = QPointer(context), function = std::move(function)](const T &result) mutable {
                    if (guard)
                        function(result);
                });
}
