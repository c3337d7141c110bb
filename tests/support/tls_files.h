// SPDX-License-Identifier: GPL-3.0-or-later
// Certificates of the test's own, made by the program openssl: an authority and what it issues.
// In a folder that goes with it. The test's thread.
#pragma once

#include <QTemporaryDir>

namespace support {
class TlsAuthority {
public:
    /// False: why() has the reason.
    bool make();
    /// For a server of this name; made again if it was made before.
    bool issue(const QString& host);
    QString errorString() const { return m_errorString; }

    QString root() const { return file("ca.crt"); }
    QString certificate() const { return file("server.crt"); }
    QString key() const { return file("server.key"); }

private:
    QString file(const char* name) const { return m_folder.filePath(QString::fromLatin1(name)); }
    bool openssl(const QStringList& arguments);

    QTemporaryDir m_folder;
    QString m_errorString;
};
} // namespace support
