// SPDX-License-Identifier: GPL-3.0-or-later
// Connection strings of PostgreSQL in both ways of writing; the examples of its manual among them
// (section 34.1.1). What is shown of one never has the password.
#include "record/server_address.h"

#include <QtTest>

using record::ServerAddress;

namespace {
QString text(const char* utf8)
{
    return QString::fromUtf8(utf8);
}
} // namespace

class TestServerAddress : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(text(".*"))); }

    void understood_data()
    {
        QTest::addColumn<QString>("string");
        QTest::addColumn<QString>("shown");
        QTest::addColumn<QString>("user");
        QTest::addColumn<QString>("password");
        QTest::addColumn<QString>("dbname");
        QTest::addColumn<QString>("options");
        QTest::newRow("words") << "host=localhost port=5432 dbname=mydb connect_timeout=10"
                               << "localhost:5432/mydb"
                               << ""
                               << ""
                               << "mydb"
                               << "host='localhost' port='5432' connect_timeout='10'";
        QTest::newRow("quotes") << R"(user = 'a b' password='it\'s \\ me' host=h)"
                                << "a b@h"
                                << "a b"
                                << R"(it's \ me)"
                                << ""
                                << "host='h'";
        QTest::newRow("the last counts") << "host=a host=b"
                                         << "b"
                                         << ""
                                         << ""
                                         << ""
                                         << "host='b'";
        QTest::newRow("a quote in an option") << R"(host=h options='-c search_path=\'x\'')"
                                              << "h"
                                              << ""
                                              << ""
                                              << ""
                                              << R"(host='h' options='-c search_path=\'x\'')";
        QTest::newRow("uri") << "postgresql://other@localhost/otherdb?connect_timeout=10&"
                                "application_name=myapp"
                             << "other@localhost/otherdb"
                             << "other"
                             << ""
                             << "otherdb"
                             << "host='localhost' connect_timeout='10' application_name='myapp'";
        QTest::newRow("uri, nothing") << "postgresql://"
                                      << ""
                                      << ""
                                      << ""
                                      << ""
                                      << "";
        QTest::newRow("uri, password") << "postgres://user:secret@localhost:5433"
                                       << "user@localhost:5433"
                                       << "user"
                                       << "secret"
                                       << ""
                                       << "host='localhost' port='5433'";
        QTest::newRow("uri, several") << "postgresql://host1:123,host2:456/somedb"
                                      << "host1,host2:123,456/somedb"
                                      << ""
                                      << ""
                                      << "somedb"
                                      << "host='host1,host2' port='123,456'";
        QTest::newRow("uri, IPv6") << "postgresql://[2001:db8::1234]:5433/database"
                                   << "2001:db8::1234:5433/database"
                                   << ""
                                   << ""
                                   << "database"
                                   << "host='2001:db8::1234' port='5433'";
        QTest::newRow("uri, socket") << "postgresql://%2Fvar%2Flib%2Fpostgresql/dbname"
                                     << "/var/lib/postgresql/dbname"
                                     << ""
                                     << ""
                                     << "dbname"
                                     << "host='/var/lib/postgresql'";
        QTest::newRow("uri, host below") << "postgresql:///mydb?host=localhost&port=5433"
                                         << "localhost:5433/mydb"
                                         << ""
                                         << ""
                                         << "mydb"
                                         << "host='localhost' port='5433'";
        QTest::newRow("uri, signs in it") << "postgresql://a%40b:p%3A%2F%40%3Bw@h/%E7%A3%A8"
                                          << "a@b@h/磨"
                                          << "a@b"
                                          << "p:/@;w"
                                          << "磨"
                                          << "host='h'";
    }

    void understood()
    {
        QFETCH(QString, string);
        const auto address = ServerAddress::parse(string);
        QVERIFY2(address, address ? "" : qPrintable(address.error().detail));
        QTEST(address->shown(), "shown");
        QTEST(address->value(text("user")), "user");
        QTEST(address->value(text("password")), "password");
        QTEST(address->value(text("dbname")), "dbname");
        QTEST(address->options(), "options");
    }

    void refused_data()
    {
        QTest::addColumn<QString>("string");
        for (const char* string :
             {"", "   ", "secret", "host=h secret", "host='h", "=h", "mysql://u:secret@h/db",
              "postgresql://u:secret@[::1/db", "postgresql://h/db?secret", "host=a;b",
              "host ="
              "x y"})
            QTest::newRow(string) << text(string);
    }

    /// What is wrong may be the password itself, so it is not said again.
    void refused()
    {
        QFETCH(QString, string);
        const auto address = ServerAddress::parse(string);
        QVERIFY(!address);
        QCOMPARE(address.error().code, base::ErrorCode::BadArgument);
        QVERIFY(address.error().detail.startsWith(text("string: ")));
        QVERIFY(!address.error().detail.contains(text("secret")));
    }

    void passwordsAreTakenOut()
    {
        const auto address = ServerAddress::parse(text("host=h password=swordfish")).value();
        QCOMPARE(address.withoutPassword(text("no \"swordfish\" here")), text("no \"•••\" here"));
        const auto name = ServerAddress::parse(text("host=h user=shop password=shop")).value();
        QCOMPARE(name.withoutPassword(text("user shop")), text("user shop"));
    }

    void defaultsYieldToWhatIsSaid()
    {
        auto address = ServerAddress::parse(text("host=h connect_timeout=9")).value();
        address.setDefault(text("connect_timeout"), text("3"));
        address.setDefault(text("sslmode"), text("prefer"));
        QCOMPARE(address.options(), text("host='h' connect_timeout='9' sslmode='prefer'"));
    }
};

QTEST_GUILESS_MAIN(TestServerAddress)
#include "tst_server_address.moc"
