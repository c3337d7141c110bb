// SPDX-License-Identifier: GPL-3.0-or-later
// Warnings of Qt during a window test are faults of the window. Main thread.
#pragma once

#include <QRegularExpression>
#include <QtTest>

namespace gui {
/// For init(): any warning fails, except those of the offscreen platform about itself.
inline void failOnWarnings()
{
    QTest::failOnWarning(QRegularExpression(QStringLiteral("^(?!This plugin does not support )")));
}
} // namespace gui
