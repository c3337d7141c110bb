// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/postgres.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QRandomGenerator>
#include <QStandardPaths>

#include <arpa/inet.h>
#include <csignal>
#include <grp.h>
#include <netinet/in.h>
#include <pwd.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <unistd.h>

namespace support {
namespace {
constexpr int timeoutMs = 120'000; ///< only a hung program ever needs it
const QString superuser = QStringLiteral("postgres");

/// Where initdb is; Debian keeps it out of the PATH.
QString binaries()
{
    const QDir versions(QStringLiteral("/usr/lib/postgresql"));
    for (const QString& version : versions.entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
        const QString folder = versions.filePath(version + QStringLiteral("/bin"));
        if (QFile::exists(folder + QStringLiteral("/initdb")))
            return folder;
    }
    const QString found = QStandardPaths::findExecutable(QStringLiteral("initdb"));
    return found.isEmpty() ? QString() : QFileInfo(found).absolutePath();
}

QString program(const char* name)
{
    return binaries() + QLatin1Char('/') + QLatin1String(name);
}

/// Whoever may run a server: the user of Debian's package, where we are root.
const passwd* serverUser()
{
    return geteuid() == 0 ? getpwnam("postgres") : getpwuid(geteuid());
}

/// A port without a listener, outside the range from which the system takes those of clients: a
/// server that starts again finds it free.
quint16 freePort()
{
    constexpr quint16 first = 10'000;
    constexpr quint16 count = 10'000;
    for (int tries = 0; tries < 100; ++tries) {
        const auto port = quint16(first + QRandomGenerator::system()->bounded(count));
        const int socket = ::socket(AF_INET, SOCK_STREAM, 0);
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        address.sin_port = htons(port);
        const bool free =
            ::bind(socket, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0;
        ::close(socket);
        if (free)
            return port;
    }
    return 0;
}

QList<int> childrenOf(qint64 process)
{
    QFile file(QStringLiteral("/proc/%1/task/%1/children").arg(process));
    QList<int> children;
    if (file.open(QIODevice::ReadOnly)) {
        for (const QByteArray& word : file.readAll().split(' ')) {
            if (word.toInt() > 0)
                children.append(word.toInt());
        }
    }
    return children;
}
} // namespace

Postgres::Postgres()
{
    if (const passwd* user = serverUser();
        user != nullptr && ::chown(qPrintable(m_folder.path()), user->pw_uid, user->pw_gid) != 0)
        m_errorString = QStringLiteral("chown failed");
}

Postgres::~Postgres()
{
    kill();
}

bool Postgres::installed()
{
    return !binaries().isEmpty() && serverUser() != nullptr;
}

void Postgres::prepare(QProcess& process) const
{
    const passwd* user = serverUser();
    const uid_t uid = user->pw_uid;
    const gid_t gid = user->pw_gid;
    process.setWorkingDirectory(m_folder.path());
    process.setChildProcessModifier([uid, gid] {
        if (geteuid() == 0 && (setgroups(0, nullptr) != 0 || setgid(gid) != 0 || setuid(uid) != 0))
            _exit(1);
        sigset_t none; // a test program may have blocked some
        sigemptyset(&none);
        sigprocmask(SIG_SETMASK, &none, nullptr);
        prctl(PR_SET_PDEATHSIG, SIGQUIT);
    });
}

bool Postgres::runAsServerUser(const QString& name, const QStringList& arguments)
{
    QProcess process;
    prepare(process);
    process.setProcessChannelMode(QProcess::MergedChannels);
    process.start(name, arguments);
    if (process.waitForFinished(timeoutMs) && process.exitCode() == 0)
        return true;
    m_errorString = QString::fromLocal8Bit(process.readAll());
    return false;
}

bool Postgres::makeCluster()
{
    const QString password = m_folder.filePath(QStringLiteral("password"));
    QFile file(password);
    if (!file.open(QIODevice::WriteOnly))
        return false;
    file.write(superuserPassword().toUtf8());
    file.close();
    file.setPermissions(QFile::ReadOwner | QFile::ReadGroup | QFile::ReadOther);
    return runAsServerUser(
        program("initdb"),
        {QStringLiteral("--pgdata"), m_folder.filePath(QStringLiteral("cluster")),
         QStringLiteral("--username"), superuser, QStringLiteral("--pwfile"), password,
         QStringLiteral("--auth=scram-sha-256"), QStringLiteral("--encoding=UTF8"),
         QStringLiteral("--locale=C"), QStringLiteral("--no-sync")});
}

bool Postgres::enableTls(const QString& certificate, const QString& key)
{
    const passwd* user = serverUser();
    for (const auto& [from, to] : {std::pair(certificate, QStringLiteral("server.crt")),
                                   std::pair(key, QStringLiteral("server.key"))}) {
        const QString path = m_folder.filePath(to);
        QFile::remove(path);
        if (!QFile::copy(from, path) ||
            !QFile::setPermissions(path, QFileDevice::ReadOwner | QFileDevice::WriteOwner) ||
            ::chown(qPrintable(path), user->pw_uid, user->pw_gid) != 0) {
            m_errorString = QStringLiteral("cannot copy ") + from;
            return false;
        }
    }
    m_tls = true;
    return true;
}

bool Postgres::start()
{
    if (!QFile::exists(m_folder.filePath(QStringLiteral("cluster/PG_VERSION"))) && !makeCluster())
        return false;
    if (m_port == 0)
        m_port = freePort();
    prepare(m_server);
    m_server.setStandardOutputFile(m_folder.filePath(QStringLiteral("log")), QIODevice::Append);
    m_server.setStandardErrorFile(m_folder.filePath(QStringLiteral("log")), QIODevice::Append);
    QStringList arguments{QStringLiteral("-D"), m_folder.filePath(QStringLiteral("cluster")),
                          QStringLiteral("-p"), QString::number(m_port),
                          QStringLiteral("-c"), QStringLiteral("listen_addresses=127.0.0.1"),
                          QStringLiteral("-c"), QStringLiteral("unix_socket_directories="),
                          QStringLiteral("-c"), QStringLiteral("fsync=off"),
                          QStringLiteral("-c"), QStringLiteral("shared_buffers=16MB"),
                          QStringLiteral("-c"), QStringLiteral("max_connections=20")};
    if (m_tls) {
        for (const char* setting :
             {"ssl=on", "ssl_cert_file=%1/server.crt", "ssl_key_file=%1/server.key"})
            arguments << QStringLiteral("-c")
                      << QString::fromLatin1(setting).replace(QStringLiteral("%1"),
                                                              m_folder.path());
    }
    m_server.start(program("postgres"), arguments);
    if (!m_server.waitForStarted(timeoutMs)) {
        m_errorString = m_server.errorString();
        return false;
    }
    while (m_server.state() == QProcess::Running) {
        QProcess ready;
        ready.start(program("pg_isready"),
                    {QStringLiteral("-q"), QStringLiteral("-h"), QStringLiteral("127.0.0.1"),
                     QStringLiteral("-p"), QString::number(m_port)});
        if (ready.waitForFinished(timeoutMs) && ready.exitCode() == 0)
            return true;
        m_server.waitForFinished(50); // that is how it goes wrong
    }
    QFile log(m_folder.filePath(QStringLiteral("log")));
    m_errorString = log.open(QIODevice::ReadOnly) ? QString::fromUtf8(log.readAll()) : QString();
    return false;
}

void Postgres::stop()
{
    if (m_server.state() == QProcess::NotRunning)
        return;
    ::kill(pid_t(m_server.processId()), SIGINT); // "fast shutdown"
    m_server.waitForFinished(timeoutMs);
}

void Postgres::signalAll(int number)
{
    if (m_server.state() == QProcess::NotRunning)
        return;
    const QList<int> children = childrenOf(m_server.processId());
    ::kill(pid_t(m_server.processId()), number);
    for (const int child : children)
        ::kill(pid_t(child), number);
}

void Postgres::kill()
{
    if (m_server.state() == QProcess::NotRunning)
        return;
    signalAll(SIGKILL);
    m_server.waitForFinished(timeoutMs);
}

void Postgres::suspend()
{
    signalAll(SIGSTOP);
}

void Postgres::resume()
{
    signalAll(SIGCONT);
}

QString Postgres::address(const QString& database) const
{
    return address(database, superuser, superuserPassword());
}

QString Postgres::address(const QString& database, const QString& user,
                          const QString& password) const
{
    return QStringLiteral("host=127.0.0.1 port=%1 dbname='%2' user='%3' passfile='%4'")
        .arg(m_port)
        .arg(database, user, passwordFile(user, password));
}

/// One for each, as libpq reads ~/.pgpass.
QString Postgres::passwordFile(const QString& user, const QString& password) const
{
    const auto escaped = [](QString word) {
        return word.replace(u'\\', QStringLiteral("\\\\")).replace(u':', QStringLiteral("\\:"));
    };
    const QByteArray line =
        QStringLiteral("*:*:*:%1:%2\n").arg(escaped(user), escaped(password)).toUtf8();
    const QString path = m_folder.filePath(
        QStringLiteral("pass-") +
        QString::fromLatin1(QCryptographicHash::hash(line, QCryptographicHash::Sha1).toHex()));
    QFile file(path);
    if (!file.exists() && file.open(QIODevice::WriteOnly | QIODevice::NewOnly,
                                    QFileDevice::ReadOwner | QFileDevice::WriteOwner))
        file.write(line);
    return path;
}

QString Postgres::query(const QString& database, const QString& sql)
{
    QProcess process;
    process.start(program("psql"), {QStringLiteral("-X"), QStringLiteral("-At"),
                                    QStringLiteral("-v"), QStringLiteral("ON_ERROR_STOP=1"),
                                    QStringLiteral("-c"), sql, address(database)});
    const bool fine = process.waitForFinished(timeoutMs) && process.exitCode() == 0;
    m_errorString = fine ? QString() : QString::fromUtf8(process.readAllStandardError());
    return QString::fromUtf8(process.readAllStandardOutput()).trimmed();
}
} // namespace support
