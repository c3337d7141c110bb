// SPDX-License-Identifier: GPL-3.0-or-later
// A PostgreSQL server of the test's own: a new cluster in a temporary folder, on 127.0.0.1 at a
// free port, as long as this lives, even if the test is killed. PostgreSQL refuses root, so there
// it runs as the user postgres. It can be stopped, killed, frozen and started again. The test's
// thread.
#pragma once

#include <QProcess>
#include <QTemporaryDir>

namespace support {
class Postgres {
public:
    Postgres();
    ~Postgres();
    Postgres(const Postgres&) = delete;
    Postgres& operator=(const Postgres&) = delete;

    static bool installed(); ///< Debian's postgresql, or what pg_config names

    /// Before start(): connections may use TLS, with these PEM files; copies are made.
    bool enableTls(const QString& certificate, const QString& key);
    /// The cluster is made the first time. False: why() has the reason.
    bool start();
    void stop();    ///< orderly, at once
    void kill();    ///< as if the power had failed
    void suspend(); ///< it accepts connections and does not answer
    void resume();
    QString errorString() const { return m_errorString; }

    quint16 port() const { return m_port; }
    QString superuserPassword() const { return QStringLiteral("root of all"); }
    /// A connection string of the superuser's. Passwords are in a file that it names.
    QString address(const QString& database) const;
    QString address(const QString& database, const QString& user, const QString& password) const;
    /// What psql prints, a line a row, cells parted by |; empty and why() if it failed.
    QString query(const QString& database, const QString& sql);

private:
    bool makeCluster();
    bool runAsServerUser(const QString& program, const QStringList& arguments);
    void prepare(QProcess& process) const;
    void signalAll(int number);
    QString passwordFile(const QString& user, const QString& password) const;

    QTemporaryDir m_folder;
    QProcess m_server;
    QString m_errorString;
    quint16 m_port = 0;
    bool m_tls = false;
};
} // namespace support
