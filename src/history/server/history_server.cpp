// SPDX-License-Identifier: GPL-3.0-or-later
#include "history/server/history_server.h"

#include "history/server/history_server_schema.h"
#include "history/server/server_error.h"

#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QSqlDatabase>
#include <QSqlDriver>
#include <QSqlError>
#include <QSqlField>
#include <QSqlQuery>
#include <QSqlRecord>
#include <QUuid>

namespace history {
namespace {
const QString driverName = QStringLiteral("QPSQL");

using Clock = std::chrono::steady_clock;
constexpr auto watchdogInterval = std::chrono::milliseconds(50);
constexpr auto watchdogTimeout = std::chrono::seconds(30);
constexpr int defaultConnectSeconds = 3;
constexpr int maxConnectSeconds = 30; ///< nothing can end the wait for a connection

/// Only libpq knows the contents of a service file.
bool mayBeRemote(ServerAddress address)
{
    const QString host = QStringLiteral("host");
    const QString hostaddr = QStringLiteral("hostaddr");
    if (address.value(host).isEmpty() && address.value(hostaddr).isEmpty()) {
        if (!address.value(QStringLiteral("service")).isEmpty() ||
            qEnvironmentVariableIsSet("PGSERVICE"))
            return true;
        address.setDefault(host, qEnvironmentVariable("PGHOST"));
        address.setDefault(hostaddr, qEnvironmentVariable("PGHOSTADDR"));
    }
    return !address.isLocal();
}

/// The authorities that this computer trusts, where the user has named none. Only for verify-full:
/// with any weaker check the certificate of another host would be accepted.
void setDefaultRootCertificates(ServerAddress& address)
{
    static const QString systemRoots = QStringLiteral("/etc/ssl/certs/ca-certificates.crt");
    if (address.value(QStringLiteral("sslmode")) == QLatin1String("verify-full") &&
        !qEnvironmentVariableIsSet("PGSSLROOTCERT") &&
        !QFile::exists(QDir::home().filePath(QStringLiteral(".postgresql/root.crt"))) &&
        QFile::exists(systemRoots))
        address.setDefault(QStringLiteral("sslrootcert"), systemRoots);
}

/// Another computer must prove its identity, unless the user disables the check.
void setDefaultTls(ServerAddress& address)
{
    if (mayBeRemote(address) && !qEnvironmentVariableIsSet("PGSSLMODE"))
        address.setDefault(QStringLiteral("sslmode"), QStringLiteral("verify-full"));
    setDefaultRootCertificates(address);
}

/// Detects a dead connection, so that a bench that disappears does not block another one.
void setDefaults(ServerAddress& address)
{
    const std::pair<const char*, const char*> defaults[] = {
        {"keepalives_idle", "10"},
        {"keepalives_interval", "5"},
        {"keepalives_count", "3"},
        {"tcp_user_timeout", "15000"},
        {"fallback_application_name", "servodesk"},
    };
    for (const auto& [keyword, value] : defaults)
        address.setDefault(QString::fromLatin1(keyword), QString::fromLatin1(value));
    const QString connectTimeout = QStringLiteral("connect_timeout");
    address.setDefault(connectTimeout, QString::number(defaultConnectSeconds));
    bool isNumber = false;
    const int seconds = address.value(connectTimeout).toInt(&isNumber);
    if (isNumber && (seconds < 1 || seconds > maxConnectSeconds))
        address.set(connectTimeout, QString::number(maxConnectSeconds));
    setDefaultTls(address);
}

ServerAddress withDefaults(ServerAddress address)
{
    setDefaults(address);
    return address;
}

/// PostgreSQL keeps no NUL in a text.
QString literal(const QSqlDriver& driver, const QVariant& value)
{
    if (value.isNull())
        return QStringLiteral("NULL");
    switch (value.typeId()) {
    case QMetaType::Bool:
        return QString::number(int(value.toBool()));
    case QMetaType::Int:
    case QMetaType::LongLong:
    case QMetaType::UInt:
        return QString::number(value.toLongLong());
    case QMetaType::Double:
        return QString::number(value.toDouble(), 'g', 17);
    case QMetaType::QByteArray: {
        QSqlField field(QString{}, QMetaType(QMetaType::QByteArray));
        field.setValue(value);
        return driver.formatValue(field);
    }
    default: {
        QSqlField field(QString{}, QMetaType(QMetaType::QString));
        field.setValue(value.toString().replace(QChar(u'\0'), QChar(QChar::ReplacementCharacter)));
        return driver.formatValue(field);
    }
    }
}
} // namespace

HistoryServer::HistoryServer(ServerAddress address, Purpose purpose)
    : HistoryFile(address.displayText(), QString())
    , m_address(withDefaults(std::move(address)))
    , m_purpose(purpose)
    , m_name(QStringLiteral("history-server-") + QUuid::createUuid().toString(QUuid::WithoutBraces))
{}

HistoryServer::~HistoryServer()
{
    m_ending = true;
    if (m_watchdog.joinable())
        m_watchdog.join();
    m_socket.detach();
    QSqlDatabase::removeDatabase(m_name);
}

void HistoryServer::abort()
{
    m_socket.close();
}

void HistoryServer::startWatchdog(const base::StopToken& stop, std::chrono::milliseconds timeout)
{
    m_stop = &stop;
    m_watchdog = std::thread([this, timeout] {
        while (!m_ending) {
            const auto since = m_queryStartedAt.load();
            const auto silence = Clock::now().time_since_epoch() - Clock::duration(since);
            if (m_stop->isRequested() || (since != 0 && silence > timeout)) {
                abort();
                return;
            }
            std::this_thread::sleep_for(watchdogInterval);
        }
    });
}

base::Error HistoryServer::error(const QSqlError& error, bool connecting) const
{
    if (m_stop != nullptr && m_stop->isRequested())
        return {base::ErrorCode::Stopped, serverOperation};
    if (m_socket.isClosed())
        return serverError(ServerErrorKind::TimedOut, {});
    return serverError(error.databaseText(), error.nativeErrorCode(), connecting);
}

base::Result<void> HistoryServer::connect()
{
    if (!QSqlDatabase::isDriverAvailable(driverName))
        return tl::unexpected(serverError(ServerErrorKind::Driver, {}));
    const EnglishMessages plain;
    QSqlDatabase database = QSqlDatabase::addDatabase(driverName, m_name);
    if (!database.isValid())
        return tl::unexpected(serverError(ServerErrorKind::Driver, {}));
    database.setUserName(m_address.value(QStringLiteral("user")));
    database.setDatabaseName(m_address.value(QStringLiteral("dbname")));
    database.setConnectOptions(m_address.options());
    if (!database.open())
        return tl::unexpected(error(database.lastError(), true));
    m_socket.attach(*database.driver());
    return initializeSession();
}

/// Where tables are and how long the server waits for us; then the schema.
base::Result<void> HistoryServer::initializeSession() const
{
    const auto encoding = run(QStringLiteral("SHOW server_encoding"));
    if (!encoding)
        return tl::unexpected(encoding.error());
    const QString found =
        encoding->rows.empty() ? QString() : encoding->rows.front().value(0).toString();
    if (found != QLatin1String("UTF8"))
        return tl::unexpected(serverError(ServerErrorKind::Encoding, found));
    for (const char* setting :
         {"SET search_path = servodesk", "SET idle_in_transaction_session_timeout = '60s'",
          "SET lock_timeout = '30s'", "SET client_min_messages = error"}) {
        if (const auto set = run(QString::fromLatin1(setting)); !set)
            return tl::unexpected(set.error());
    }
    if (m_purpose == Purpose::Send)
        return migrateSchema(*this);
    if (const auto set = run(QStringLiteral("SET default_transaction_read_only = on")); !set)
        return tl::unexpected(set.error());
    return checkSchema(*this);
}

/// Without prepared statements: Qt's driver prints a warning when it cannot release one, which
/// happens after every failure in a transaction.
QString HistoryServer::statement(const QString& sql, const QVariantList& values) const
{
    if (values.isEmpty())
        return sql;
    const QSqlDatabase database = QSqlDatabase::database(m_name, false);
    QString text;
    QChar quote;
    qsizetype next = 0;
    for (const QChar c : sql) {
        if (!quote.isNull() ? c == quote : (c == u'\'' || c == u'"'))
            quote = quote.isNull() ? c : QChar();
        if (c == u'?' && quote.isNull())
            text += literal(*database.driver(), values.value(next++));
        else
            text += c;
    }
    return text;
}

base::Result<QueryResult> HistoryServer::run(const QString& sql, const QVariantList& values) const
{
    const EnglishMessages plain;
    const QSqlDatabase database = QSqlDatabase::database(m_name, false);
    if (!database.isOpen()) // any more
        return tl::unexpected(serverError(m_socket.isClosed() ? ServerErrorKind::TimedOut
                                                              : ServerErrorKind::Unreachable,
                                          QString()));
    QSqlQuery query(database);
    // Otherwise record() asks the server for the names of the tables, and Qt's driver prints a
    // warning when the connection breaks meanwhile.
    query.setForwardOnly(true);
    QueryResult answer;
    m_queryStartedAt = Clock::now().time_since_epoch().count();
    bool answered = query.exec(statement(sql, values));
    if (answered && query.isSelect()) {
        const int columns = query.record().count();
        while (query.next()) {
            QVariantList& row = answer.rows.emplace_back();
            for (int column = 0; column < columns; ++column)
                row.append(query.value(column));
        }
        answered = query.lastError().type() == QSqlError::NoError; // or it ended half-way
    } else if (answered) {
        answer.changed = query.numRowsAffected();
    }
    m_queryStartedAt = 0;
    if (!answered)
        return tl::unexpected(error(query.lastError(), false));
    return answer;
}

base::Result<void> HistoryServer::transaction(const std::function<base::Result<void>()>& work) const
{
    // The server would refuse as well, but its message depends on the first statement.
    if (m_purpose == Purpose::Browse)
        return tl::unexpected(serverError(ServerErrorKind::Permission,
                                          QStringLiteral("copies are changed at their own bench")));
    if (const auto begun = run(QStringLiteral("BEGIN")); !begun)
        return tl::unexpected(begun.error());
    auto done = work();
    if (done) {
        const auto kept = run(QStringLiteral("COMMIT"));
        if (kept)
            return {};
        done = tl::unexpected(kept.error());
    }
    (void)run(QStringLiteral("ROLLBACK")); // nothing is lost if the server is gone
    return done;
}

QString HistoryServer::sameBench(const QString& one, const QString& other) const
{
    return QStringLiteral(" AND %1.bench = %2.bench").arg(one, other);
}

base::Result<std::vector<HistoryBench>> HistoryServer::benches() const
{
    const auto found = run(QStringLiteral("SELECT number, uuid, name, sent, (SELECT count(*) FROM "
                                          "servodesk.writes WHERE bench = benches.number) "
                                          "FROM servodesk.benches ORDER BY lower(name), number"));
    if (!found)
        return tl::unexpected(found.error());
    std::vector<HistoryBench> all;
    for (const QVariantList& row : found->rows)
        all.push_back({row.value(0).toLongLong(), row.value(1).toString(), row.value(2).toString(),
                       QDateTime::fromMSecsSinceEpoch(row.value(3).toLongLong(), Qt::UTC),
                       row.value(4).toLongLong()});
    return all;
}

base::Result<void> HistoryServer::selectBench(std::optional<std::int64_t> bench) const
{
    const QString path =
        bench ? QStringLiteral("servodesk_bench, servodesk") : QStringLiteral("servodesk");
    if (const auto set = run(QStringLiteral("SET search_path = ") + path); !set)
        return tl::unexpected(set.error());
    const auto set = run(QStringLiteral("SET servodesk.bench = '%1'").arg(bench.value_or(0)));
    return set ? base::Result<void>() : tl::unexpected(set.error());
}

base::Result<QMap<qint64, QString>>
HistoryServer::benchNames(const QString& table, const std::vector<std::int64_t>& numbers) const
{
    QMap<qint64, QString> names;
    if (numbers.empty())
        return names;
    QStringList list;
    for (const std::int64_t number : numbers)
        list.append(QString::number(number));
    const auto found = run(QStringLiteral("SELECT r.number, b.name FROM servodesk.%1 r JOIN "
                                          "servodesk.benches b ON b.number = r.bench "
                                          "WHERE r.number IN (%2)")
                               .arg(table, list.join(u',')));
    if (!found)
        return tl::unexpected(found.error());
    for (const QVariantList& row : found->rows)
        names.insert(row.value(0).toLongLong(), row.value(1).toString());
    return names;
}

base::Result<std::unique_ptr<HistoryServer>> connectHistoryServer(const QString& text,
                                                                  HistoryServer::Purpose purpose,
                                                                  const base::StopToken* stop)
{
    const auto address = ServerAddress::parse(text);
    if (!address)
        return tl::unexpected(address.error());
    auto server = std::make_unique<HistoryServer>(*address, purpose);
    if (stop != nullptr)
        server->startWatchdog(*stop, watchdogTimeout);
    if (const auto connected = server->connect(); !connected)
        return tl::unexpected(connected.error());
    return server;
}
} // namespace history
