// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/server_text.h"

#include "text/text_table.h"

#include <array>

namespace text {
namespace {
constexpr std::array serverKinds{
    RefusalText{"away", QT_TRANSLATE_NOOP("text", "the history server cannot be reached"),
                QT_TRANSLATE_NOOP("text", "The server is turned off or restarting, the network is "
                                          "down, or the host name or port is wrong."),
                QT_TRANSLATE_NOOP("text",
                                  "No data is lost: pending data is sent when the server is back. "
                                  "Check the host and port in the connection string.")},
    RefusalText{"hung", QT_TRANSLATE_NOOP("text", "the history server does not respond"),
                QT_TRANSLATE_NOOP("text",
                                  "The server accepts connections but does not reply: it has hung, "
                                  "a firewall is blocking it, or it is not a PostgreSQL server."),
                QT_TRANSLATE_NOOP("text", "No data is lost: pending data is sent when the "
                                          "server responds again. Check the server, host and "
                                          "port.")},
    RefusalText{"password", QT_TRANSLATE_NOOP("text", "the history server rejects this password"),
                QT_TRANSLATE_NOOP("text", "The password is wrong or missing, or there is no "
                                          "such user."),
                QT_TRANSLATE_NOOP("text", "Check the user in the connection string, and the "
                                          "password in ~/.pgpass (a line "
                                          "HOST:PORT:DATABASE:USER:PASSWORD, file mode 0600).")},
    RefusalText{
        "database", QT_TRANSLATE_NOOP("text", "the history server has no such database"),
        QT_TRANSLATE_NOOP(
            "text", "The database name is misspelled, or the database has not been created yet."),
        QT_TRANSLATE_NOOP(
            "text", "Create the database on the server: \"createdb -E UTF8 -O USER DATABASE\".")},
    RefusalText{"rights", QT_TRANSLATE_NOOP("text", "the history server does not allow this"),
                QT_TRANSLATE_NOOP("text", "This user cannot log in from here, has only read "
                                          "permission, or cannot create tables in this database."),
                QT_TRANSLATE_NOOP("text", "Ask the owner of the database for permission (GRANT, "
                                          "pg_hba.conf), or use another user.")},
    RefusalText{
        "tls",
        QT_TRANSLATE_NOOP("text", "the history server and this computer cannot agree on "
                                  "encryption"),
        QT_TRANSLATE_NOOP("text",
                          "One side requires TLS and the other does not offer it. By default, "
                          "servers on other computers must use TLS (sslmode=verify-full)."),
        QT_TRANSLATE_NOOP("text", "Enable TLS on the server (ssl = on). On a trusted network, you "
                                  "can use sslmode=disable in the connection string instead; all "
                                  "data is then sent unencrypted.")},
    RefusalText{
        "certificate",
        QT_TRANSLATE_NOOP("text", "the certificate of the history server cannot be "
                                  "verified"),
        QT_TRANSLATE_NOOP("text", "The certificate has expired, this computer does not trust its "
                                  "issuer, or another computer is posing as the server."),
        QT_TRANSLATE_NOOP(
            "text", "Save the certificate of the issuing authority as ~/.postgresql/root.crt, or "
                    "specify the certificate file with sslrootcert=FILE in the connection string. "
                    "sslmode=require encrypts without verification.")},
    RefusalText{"host-name",
                QT_TRANSLATE_NOOP("text", "the certificate of the history server is for another "
                                          "host name"),
                QT_TRANSLATE_NOOP("text",
                                  "The server name in the connection string does not match the "
                                  "certificate, or another computer is posing as the server."),
                QT_TRANSLATE_NOOP("text", "Use the host name in the certificate, or get a "
                                          "certificate for this host name. sslmode=verify-ca "
                                          "checks only the issuer.")},
    RefusalText{
        "secret", QT_TRANSLATE_NOOP("text", "the connection string contains a password"),
        QT_TRANSLATE_NOOP("text", "Other users could read the password in the settings and in the "
                                  "process list, so it is neither used nor saved."),
        QT_TRANSLATE_NOOP("text", "Remove the password from the string and store it in ~/.pgpass: "
                                  "a line HOST:PORT:DATABASE:USER:PASSWORD, file mode 0600.")},
    RefusalText{
        "parameter",
        QT_TRANSLATE_NOOP("text", "the connection string contains a parameter that is "
                                  "not accepted"),
        QT_TRANSLATE_NOOP("text", "The parameter is misspelled, or it might contain a password."),
        QT_TRANSLATE_NOOP("text", "Use only host, hostaddr, port, dbname, user, service, "
                                  "connect_timeout, application_name, target_session_attrs and "
                                  "parameters that begin with ssl, gss or keepalives.")},
    RefusalText{
        "refused", QT_TRANSLATE_NOOP("text", "the history server rejects the login"),
        QT_TRANSLATE_NOOP(
            "text", "The server's message gives the reason, in the language set on the server."),
        QT_TRANSLATE_NOOP("text", "Check the user, password and database in the connection "
                                  "string, and check the server's log.")},
    RefusalText{"driver",
                QT_TRANSLATE_NOOP("text", "this computer cannot connect to PostgreSQL servers"),
                QT_TRANSLATE_NOOP("text", "Qt's PostgreSQL driver is not installed."),
                QT_TRANSLATE_NOOP("text", "Install the driver (Debian: \"sudo apt install "
                                          "libqt6sql6-psql\"), then restart the program.")},
    RefusalText{
        "newer",
        QT_TRANSLATE_NOOP(
            "text", "the database on the history server is from a newer version of this program"),
        QT_TRANSLATE_NOOP("text", "Another bench uses a newer version of this program, which has "
                                  "updated the tables on the server."),
        QT_TRANSLATE_NOOP("text", "Update this program as well. Until then, all data is "
                                  "kept on this computer.")},
    RefusalText{
        "older",
        QT_TRANSLATE_NOOP(
            "text", "the database on the history server is from an older version of this program"),
        QT_TRANSLATE_NOOP("text", "The tables are updated when a bench with this version of the "
                                  "program sends data for the first time."),
        QT_TRANSLATE_NOOP("text", "Send data from a bench that uses this version.")},
    RefusalText{
        "empty", QT_TRANSLATE_NOOP("text", "no data has been sent to this history server yet"),
        QT_TRANSLATE_NOOP(
            "text",
            "No bench uses this database yet, or the connection string names the wrong one."),
        QT_TRANSLATE_NOOP("text",
                          "Set the connection string on each bench computer, then try again.")},
    RefusalText{
        "encoding",
        QT_TRANSLATE_NOOP("text", "this database cannot store text in all "
                                  "languages"),
        QT_TRANSLATE_NOOP("text", "The encoding of the database is not UTF8."),
        QT_TRANSLATE_NOOP("text",
                          "Create another database: \"createdb -E UTF8 -T template0 DATABASE\".")},
    RefusalText{
        "busy", QT_TRANSLATE_NOOP("text", "the history server is too busy"),
        QT_TRANSLATE_NOOP(
            "text",
            "The server has reached its maximum number of connections, or the tables are locked."),
        QT_TRANSLATE_NOOP("text", "No data is lost; the program tries again automatically. If the "
                                  "problem continues, check the server.")},
    RefusalText{"full", QT_TRANSLATE_NOOP("text", "the disk of the history server is full"),
                QT_TRANSLATE_NOOP("text", "There is no space left for the database tables."),
                QT_TRANSLATE_NOOP("text", "Free up some space on the server. Until then, data is "
                                          "kept on this computer; it will be sent later.")},
    RefusalText{
        "string", QT_TRANSLATE_NOOP("text", "this is not a valid PostgreSQL connection string"),
        QT_TRANSLATE_NOOP(
            "text", "The string has neither the form postgresql://USER@HOST/DATABASE nor the form "
                    "host=HOST dbname=DATABASE user=USER, or part of it is not recognized."),
        QT_TRANSLATE_NOOP("text", "Correct the string; the PostgreSQL manual describes its format "
                                  "under \"Connection Strings\".")},
    RefusalText{"server", QT_TRANSLATE_NOOP("text", "the history server reports an error"),
                QT_TRANSLATE_NOOP("text", "The server is not in the state this program expects."),
                QT_TRANSLATE_NOOP("text", "No data is lost; the program tries again automatically. "
                                          "If the problem continues, check the server's log.")},
};

const QLatin1StringView between(": ");
} // namespace

const RefusalText* serverText(const base::Error& error)
{
    if (error.operation != QLatin1String("history-server"))
        return nullptr;
    const QString kind = error.detail.left(error.detail.indexOf(between));
    return entryFor(serverKinds, kind);
}

QString serverMessage(const base::Error& error)
{
    const qsizetype at = error.detail.indexOf(between);
    return at < 0 ? QString() : error.detail.mid(at + between.size());
}
} // namespace text
