// SPDX-License-Identifier: GPL-3.0-or-later
// The history server of a test: one PostgreSQL for all of it, a new database for each of its
// functions, and the copies in it as another computer sees them. The test's thread.
#pragma once

#include "history/history.h"
#include "history/server/history_server.h"
#include "support/postgres.h"

#include <QTest>

namespace support {
class HistoryServerFixture {
protected:
    /// For initTestCase().
    void startServer()
    {
        if (!Postgres::installed())
            QFAIL("PostgreSQL is not installed (packaging/test-packages.txt)");
        QVERIFY2(m_pg.start(), qPrintable(m_pg.errorString()));
    }

    /// For init().
    void newDatabase()
    {
        m_database = QStringLiteral("shop %1").arg(++m_databases);
        m_pg.query(QStringLiteral("postgres"),
                   QStringLiteral("CREATE DATABASE \"%1\"").arg(m_database));
        QVERIFY2(m_pg.errorString().isEmpty(), qPrintable(m_pg.errorString()));
    }

    QString address() const { return m_pg.address(m_database); }

    std::unique_ptr<history::History> browse() const
    {
        auto server =
            history::connectHistoryServer(address(), history::HistoryServer::Purpose::Browse);
        if (!server)
            qCritical("%s", qPrintable(server.error().detail));
        return std::make_unique<history::History>(std::move(*server));
    }

    Postgres m_pg;
    QString m_database;

private:
    int m_databases = 0;
};
} // namespace support
