// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/tls_files.h"

#include <QProcess>

namespace support {
bool TlsAuthority::openssl(const QStringList& arguments)
{
    QProcess process;
    process.setProcessChannelMode(QProcess::MergedChannels);
    process.start(QStringLiteral("openssl"), arguments);
    if (process.waitForFinished() && process.exitCode() == 0)
        return true;
    m_errorString = process.errorString() + QString::fromLocal8Bit(process.readAll());
    return false;
}

namespace {
QStringList request(const QString& name, const QString& key, const QString& certificate)
{
    return {QStringLiteral("req"),
            QStringLiteral("-x509"),
            QStringLiteral("-newkey"),
            QStringLiteral("ec"),
            QStringLiteral("-pkeyopt"),
            QStringLiteral("ec_paramgen_curve:prime256v1"),
            QStringLiteral("-nodes"),
            QStringLiteral("-days"),
            QStringLiteral("30"),
            QStringLiteral("-subj"),
            QStringLiteral("/CN=") + name,
            QStringLiteral("-keyout"),
            key,
            QStringLiteral("-out"),
            certificate};
}
} // namespace

bool TlsAuthority::make()
{
    return openssl(request(QStringLiteral("Authority of a test"), file("ca.key"), root()));
}

bool TlsAuthority::issue(const QString& host)
{
    return openssl(request(host, key(), certificate())
                   << QStringLiteral("-CA") << root() << QStringLiteral("-CAkey") << file("ca.key")
                   << QStringLiteral("-addext") << QStringLiteral("subjectAltName=DNS:") + host
                   << QStringLiteral("-addext") << QStringLiteral("basicConstraints=CA:FALSE"));
}
} // namespace support
