// SPDX-License-Identifier: GPL-3.0-or-later
// Connection strings of PostgreSQL in both ways of writing; the examples of its manual among them
// (section 34.1.1). What is shown of one never has the password.
#include "history/server/server_address.h"
#include "support/test_main.h"
#include "support/text.h"

#include <QtTest>

using history::ServerAddress;
using support::utf8;

class TestServerAddress : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(utf8(".*"))); }

    void validAddresses_data()
    {
        QTest::addColumn<QString>("string");
        QTest::addColumn<QString>("shown");
        QTest::addColumn<QString>("user");
        QTest::addColumn<QString>("dbname");
        QTest::addColumn<QString>("options");
        QTest::newRow("words") << "host=localhost port=5432 dbname=mydb connect_timeout=10"
                               << "localhost:5432/mydb"
                               << ""
                               << "mydb"
                               << "host='localhost' port='5432' connect_timeout='10'";
        QTest::newRow("quotes") << R"(user = 'a b' passfile='it\'s \\ me' host=h)"
                                << "a b@h"
                                << "a b"
                                << ""
                                << R"(passfile='it\'s \\ me' host='h')";
        QTest::newRow("the last counts") << "host=a host=b"
                                         << "b"
                                         << ""
                                         << ""
                                         << "host='b'";
        QTest::newRow("a quote in an option") << R"(host=h application_name='the \'x\' bench')"
                                              << "h"
                                              << ""
                                              << ""
                                              << R"(host='h' application_name='the \'x\' bench')";
        QTest::newRow("uri") << "postgresql://other@localhost/otherdb?connect_timeout=10&"
                                "application_name=myapp"
                             << "other@localhost/otherdb"
                             << "other"
                             << "otherdb"
                             << "host='localhost' connect_timeout='10' application_name='myapp'";
        QTest::newRow("uri, nothing") << "postgresql://"
                                      << ""
                                      << ""
                                      << ""
                                      << "";
        QTest::newRow("uri, empty password") << "postgres://user:@localhost:5433"
                                             << "user@localhost:5433"
                                             << "user"
                                             << ""
                                             << "host='localhost' port='5433'";
        QTest::newRow("uri, several") << "postgresql://host1:123,host2:456/somedb"
                                      << "host1,host2:123,456/somedb"
                                      << ""
                                      << "somedb"
                                      << "host='host1,host2' port='123,456'";
        QTest::newRow("uri, IPv6") << "postgresql://[2001:db8::1234]:5433/database"
                                   << "2001:db8::1234:5433/database"
                                   << ""
                                   << "database"
                                   << "host='2001:db8::1234' port='5433'";
        QTest::newRow("uri, socket") << "postgresql://%2Fvar%2Flib%2Fpostgresql/dbname"
                                     << "/var/lib/postgresql/dbname"
                                     << ""
                                     << "dbname"
                                     << "host='/var/lib/postgresql'";
        QTest::newRow("uri, host below") << "postgresql:///mydb?host=localhost&port=5433"
                                         << "localhost:5433/mydb"
                                         << ""
                                         << "mydb"
                                         << "host='localhost' port='5433'";
        QTest::newRow("uri, signs in it") << "postgresql://a%40b@h/%E7%A3%A8"
                                          << "a@b@h/磨"
                                          << "a@b"
                                          << "磨"
                                          << "host='h'";
    }

    void validAddresses()
    {
        QFETCH(QString, string);
        const auto address = ServerAddress::parse(string);
        QVERIFY2(address, address ? "" : qPrintable(address.error().detail));
        QTEST(address->displayText(), "shown");
        QTEST(address->value(utf8("user")), "user");
        QTEST(address->value(utf8("dbname")), "dbname");
        QTEST(address->options(), "options");
    }

    void invalidAddresses_data()
    {
        QTest::addColumn<QString>("string");
        for (const char* string :
             {"", "   ", "secret", "host=h secret", "host='h", "=h", "mysql://u:secret@h/db",
              "postgresql://u:secret@[::1/db", "postgresql://h/db?secret", "host=a;b",
              "host ="
              "x y"})
            QTest::newRow(string) << utf8(string);
    }

    /// What is wrong may be the password itself, so it is not said again.
    void invalidAddresses()
    {
        QFETCH(QString, string);
        const auto address = ServerAddress::parse(string);
        QVERIFY(!address);
        QCOMPARE(address.error().code, base::ErrorCode::BadArgument);
        QVERIFY(address.error().detail.startsWith(utf8("string: ")));
        QVERIFY(!address.error().detail.contains(utf8("secret")));
    }

    void secretsAreRefused_data()
    {
        QTest::addColumn<QString>("string");
        QTest::newRow("uri") << "postgresql://u:swordfish@h:5433/db";
        QTest::newRow("signs in it") << "postgresql://u:p%3A%2F%40swordfish%3B@h/%E7%A3%A8";
        QTest::newRow("an @ in it") << "postgresql://u:p@swordfish@h/db";
        QTest::newRow("parameter") << "postgresql://u@h/db?password=swordfish&sslmode=require";
        QTest::newRow("words") << "host=h password=swordfish user='a b'";
        QTest::newRow("quotes") << R"(host=h password = 'sword fish \' swordfish')";
        QTest::newRow("blank escaped") << R"(host=h password=a\ swordfish)";
        QTest::newRow("of the key") << "host=h sslkey=/k sslpassword=swordfish";
        QTest::newRow("another word for it") << "host=h PWD=swordfish";
        QTest::newRow("of OAuth") << "host=h oauth_client_id=me oauth_client_secret=swordfish";
        QTest::newRow("in options") << "host=h options=-cpassword=swordfish";
        QTest::newRow("in options, uri") << "postgresql://h/db?options=-cpassword%3Dswordfish";
        QTest::newRow("a slash in it") << "postgresql://u:pa/swordfish@h/db";
        QTest::newRow("a slash after digits") << "postgresql://u:12/swordfish@h/db";
        QTest::newRow("an open quote") << "host=h password='swordfish";
        QTest::newRow("another scheme") << "mysql://u:swordfish@h/db";
    }

    void secretsAreRefused()
    {
        QFETCH(QString, string);
        const auto address = ServerAddress::parse(string);
        QVERIFY(!address);
        QVERIFY(!address.error().detail.contains(utf8("swordfish")));
        const QString displayText = ServerAddress::masked(string);
        QVERIFY2(!displayText.contains(utf8("swordfish")), qPrintable(displayText));
    }

    void onlyHarmlessParametersPass_data()
    {
        QTest::addColumn<bool>("accepted");
        for (const char* fine :
             {"host=h hostaddr=10.0.0.1 port=1 dbname=d user=u", "service=shop passfile=/p",
              "sslmode=verify-full sslrootcert=/r sslcert=/c sslkey=/k sslcrl=/l",
              "connect_timeout=3 keepalives=1 keepalives_idle=5 target_session_attrs=any",
              "postgresql://u@h/d?sslmode=require&application_name=x"})
            QTest::newRow(fine) << true;
        for (const char* other : {"bogus=1", "host=h options=-cgeqo=off", "host=h HOST=g",
                                  "postgresql://h/d?oauth_issuer=x", "host=h swordfish=1"})
            QTest::newRow(other) << false;
    }

    void onlyHarmlessParametersPass()
    {
        QFETCH(bool, accepted);
        const auto address = ServerAddress::parse(utf8(QTest::currentDataTag()));
        QCOMPARE(address.has_value(), accepted);
        if (!accepted)
            QCOMPARE(address.error().detail, utf8("parameter"));
    }

    /// Where there is nothing to hide, nothing changes.
    void otherParametersAreKept()
    {
        for (const char* string :
             {"postgresql://user@h:5433/db?sslmode=require", "host=h passfile=/home/u/.pgpass",
              "postgresql://u:@h/db", "tcp://10.0.0.2:9000", "--timeout 200", "host='h"}) {
            if (QByteArray(string) != "postgresql://u:@h/db")
                QCOMPARE(ServerAddress::masked(utf8(string)), utf8(string));
        }
    }

    void localHostIsDetected_data()
    {
        QTest::addColumn<bool>("isLocal");
        for (const char* here : {"dbname=db", "host=localhost", "host=127.0.0.1", "host=127.1.2.3",
                                 "host=/var/run/postgresql", "host=@abstract", "host=LOCALHOST,::1",
                                 "postgresql://[::1]/db", "hostaddr=127.0.0.1 host=localhost"})
            QTest::newRow(here) << true;
        for (const char* elsewhere :
             {"host=shop", "host=127.evil.example", "host=localhost.example", "host=10.0.0.1",
              "hostaddr=192.168.0.5", "host=localhost,shop", "host=shop hostaddr=127.0.0.1",
              "host=localhost hostaddr=192.168.0.5"})
            QTest::newRow(elsewhere) << false;
    }

    void localHostIsDetected()
    {
        QFETCH(bool, isLocal);
        QCOMPARE(ServerAddress::parse(utf8(QTest::currentDataTag())).value().isLocal(), isLocal);
    }

    void explicitValuesOverrideDefaults()
    {
        auto address = ServerAddress::parse(utf8("host=h connect_timeout=9")).value();
        address.setDefault(utf8("connect_timeout"), utf8("3"));
        address.setDefault(utf8("sslmode"), utf8("prefer"));
        QCOMPARE(address.options(), utf8("host='h' connect_timeout='9' sslmode='prefer'"));
    }
};

SERVODESK_GUILESS_TEST(TestServerAddress)
#include "tst_server_address.moc"
