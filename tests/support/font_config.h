// SPDX-License-Identifier: GPL-3.0-or-later
// A machine with few fonts, for a test of its own: the name of a fontconfig file, to be put into
// the environment as FONTCONFIG_FILE before there is an application object.
#pragma once

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

namespace support {
/// Only the fonts of this folder are there.
inline QByteArray fontConfigWith(const QTemporaryDir& place, const char* fonts)
{
    QFile file(place.filePath(QStringLiteral("fonts.conf")));
    if (file.open(QIODevice::WriteOnly))
        file.write(QStringLiteral("<fontconfig><dir>%1</dir><cachedir>%2</cachedir></fontconfig>")
                       .arg(QString::fromUtf8(fonts), place.filePath(QStringLiteral("cache")))
                       .toUtf8());
    return QFile::encodeName(file.fileName());
}

/// Runs a test where only the fonts of this folder are there.
template <typename Application, typename Test>
int runWithFonts(int argc, char** argv, const char* fonts)
{
    const QTemporaryDir place;
    qputenv("FONTCONFIG_FILE", fontConfigWith(place, fonts));
    const Application application(argc, argv);
    Test test;
    return QTest::qExec(&test, argc, argv);
}
} // namespace support
