// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/server_text.h"

#include "text/translate.h"

#include <array>

namespace text {
namespace {
constexpr std::array serverKinds{
    RefusalText{"away", QT_TRANSLATE_NOOP("text", "the history server cannot be reached"),
                QT_TRANSLATE_NOOP("text", "It is switched off or restarting, the network is "
                                          "down, or its name or port is misspelt."),
                QT_TRANSLATE_NOOP("text", "Nothing is lost: what it missed is sent when it is "
                                          "back. Check host and port of the connection string.")},
    RefusalText{"hung", QT_TRANSLATE_NOOP("text", "the history server does not answer"),
                QT_TRANSLATE_NOOP("text", "Something takes connections there and says nothing: "
                                          "a server that hangs, a firewall, or no PostgreSQL."),
                QT_TRANSLATE_NOOP("text", "Nothing is lost: what it missed is sent when it "
                                          "answers again. Check the server, host and port.")},
    RefusalText{"password",
                QT_TRANSLATE_NOOP("text", "the history server does not take this password"),
                QT_TRANSLATE_NOOP("text", "The password is wrong or missing, or there is no "
                                          "such user."),
                QT_TRANSLATE_NOOP("text", "Check the user in the connection string, and the "
                                          "password in ~/.pgpass (a line "
                                          "HOST:PORT:DATABASE:USER:PASSWORD, file mode 0600).")},
    RefusalText{"database", QT_TRANSLATE_NOOP("text", "the history server has no such database"),
                QT_TRANSLATE_NOOP("text", "Its name is misspelt, or nobody has made it yet."),
                QT_TRANSLATE_NOOP("text", "Have it made on the server: \"createdb -E UTF8 -O "
                                          "USER DATABASE\".")},
    RefusalText{"rights", QT_TRANSLATE_NOOP("text", "the history server does not permit this"),
                QT_TRANSLATE_NOOP("text", "This user may not log in from here, or may only read, "
                                          "or may not make tables in this database."),
                QT_TRANSLATE_NOOP("text", "Have the database's owner permit it (GRANT, "
                                          "pg_hba.conf), or use another user.")},
    RefusalText{"tls",
                QT_TRANSLATE_NOOP("text", "the history server and this computer cannot agree on "
                                          "encryption"),
                QT_TRANSLATE_NOOP("text", "One side requires TLS and the other does not offer "
                                          "it. Servers on other computers must use TLS "
                                          "(sslmode=verify-full) unless sslmode says otherwise."),
                QT_TRANSLATE_NOOP("text", "Enable TLS on the server (ssl = on). On a trusted "
                                          "network, sslmode=disable in the connection string "
                                          "sends everything unencrypted.")},
    RefusalText{"certificate",
                QT_TRANSLATE_NOOP("text", "the certificate of the history server cannot be "
                                          "verified"),
                QT_TRANSLATE_NOOP("text", "It is not issued by an authority this computer "
                                          "trusts, it has expired, or another computer is "
                                          "answering in the server's place."),
                QT_TRANSLATE_NOOP("text", "Save the authority's certificate as "
                                          "~/.postgresql/root.crt, or name its file with "
                                          "sslrootcert=FILE in the connection string. "
                                          "sslmode=require encrypts without verification.")},
    RefusalText{"host-name",
                QT_TRANSLATE_NOOP("text", "the certificate of the history server is for another "
                                          "host name"),
                QT_TRANSLATE_NOOP("text", "The connection string names the server differently, "
                                          "or another computer is answering in its place."),
                QT_TRANSLATE_NOOP("text", "Use the host name in the certificate, or have a "
                                          "certificate issued for this one. sslmode=verify-ca "
                                          "checks only who issued it.")},
    RefusalText{"secret", QT_TRANSLATE_NOOP("text", "the connection string contains a password"),
                QT_TRANSLATE_NOOP("text", "Others could read it in the settings and in the list "
                                          "of processes, so it is neither used nor saved."),
                QT_TRANSLATE_NOOP("text", "Remove it from the string and store it in ~/.pgpass: "
                                          "a line HOST:PORT:DATABASE:USER:PASSWORD, file mode "
                                          "0600.")},
    RefusalText{"parameter",
                QT_TRANSLATE_NOOP("text", "the connection string contains a parameter that is "
                                          "not accepted"),
                QT_TRANSLATE_NOOP("text", "It is misspelled, or it is none of the parameters "
                                          "that are known to hold no password."),
                QT_TRANSLATE_NOOP("text", "Use host, hostaddr, port, dbname, user, service, "
                                          "connect_timeout, application_name, "
                                          "target_session_attrs and the parameters that begin "
                                          "with ssl, gss or keepalives.")},
    RefusalText{"secret-removed",
                QT_TRANSLATE_NOOP("text", "the password of the history server was removed from "
                                          "the settings"),
                QT_TRANSLATE_NOOP("text", "An earlier version saved it there as plain text."),
                QT_TRANSLATE_NOOP("text", "Store it in ~/.pgpass: a line "
                                          "HOST:PORT:DATABASE:USER:PASSWORD, file mode 0600. "
                                          "Change it if others could read the settings.")},
    RefusalText{"refused", QT_TRANSLATE_NOOP("text", "the history server lets nobody in"),
                QT_TRANSLATE_NOOP("text", "It gives its reason in its own language."),
                QT_TRANSLATE_NOOP("text", "Check user, password and database of the connection "
                                          "string, and the server's log.")},
    RefusalText{"driver",
                QT_TRANSLATE_NOOP("text", "this computer cannot talk to PostgreSQL servers"),
                QT_TRANSLATE_NOOP("text", "Qt's driver for them is not installed."),
                QT_TRANSLATE_NOOP("text", "Install it, on Debian with \"sudo apt install "
                                          "libqt6sql6-psql\", then start the program again.")},
    RefusalText{"newer",
                QT_TRANSLATE_NOOP("text", "the history server belongs to a newer version of this "
                                          "program"),
                QT_TRANSLATE_NOOP("text", "Another bench has been brought up to date, and has "
                                          "changed the tables there."),
                QT_TRANSLATE_NOOP("text", "Bring this program up to date as well. Until then "
                                          "everything is kept on this computer.")},
    RefusalText{"older",
                QT_TRANSLATE_NOOP("text", "the history server belongs to an older version of "
                                          "this program"),
                QT_TRANSLATE_NOOP("text", "Its tables are brought up to date by the first bench "
                                          "of this version that sends something."),
                QT_TRANSLATE_NOOP("text", "Let a bench with this version send its history "
                                          "there.")},
    RefusalText{"empty",
                QT_TRANSLATE_NOOP("text", "nothing has ever been sent to this history server"),
                QT_TRANSLATE_NOOP("text", "No bench uses this database yet, or this is another "
                                          "one."),
                QT_TRANSLATE_NOOP("text", "Set the connection string at the benches, then look "
                                          "again.")},
    RefusalText{"encoding", QT_TRANSLATE_NOOP("text", "this database cannot keep every language"),
                QT_TRANSLATE_NOOP("text", "Its encoding is not UTF8."),
                QT_TRANSLATE_NOOP("text", "Make another one: \"createdb -E UTF8 -T template0 "
                                          "DATABASE\".")},
    RefusalText{"busy", QT_TRANSLATE_NOOP("text", "the history server is too busy"),
                QT_TRANSLATE_NOOP("text", "It has as many connections as it allows, or somebody "
                                          "holds the tables."),
                QT_TRANSLATE_NOOP("text", "Nothing is lost, and it is tried again by itself. If "
                                          "it stays so, look at the server.")},
    RefusalText{"full", QT_TRANSLATE_NOOP("text", "the disk of the history server is full"),
                QT_TRANSLATE_NOOP("text", "There is no room left for its tables."),
                QT_TRANSLATE_NOOP("text", "Make room there. Until then everything is kept on "
                                          "this computer, and sent afterwards.")},
    RefusalText{"string", QT_TRANSLATE_NOOP("text", "this is no connection string of PostgreSQL"),
                QT_TRANSLATE_NOOP("text", "It is neither postgresql://USER@HOST/DATABASE nor "
                                          "host=HOST dbname=DATABASE user=USER, or has a part "
                                          "that is not known."),
                QT_TRANSLATE_NOOP("text", "Correct it; PostgreSQL's manual describes it under "
                                          "\"Connection Strings\".")},
    RefusalText{"server", QT_TRANSLATE_NOOP("text", "the history server reports an error"),
                QT_TRANSLATE_NOOP("text", "Something there is not as this program expects it."),
                QT_TRANSLATE_NOOP("text", "Nothing is lost, and it is tried again by itself. If "
                                          "it stays so, look at the server's log.")},
};

const QLatin1StringView between(": ");
} // namespace

const RefusalText* serverText(const base::Error& error)
{
    if (error.operation != QLatin1String("history-server"))
        return nullptr;
    const QString kind = error.detail.left(error.detail.indexOf(between));
    for (const RefusalText& words : serverKinds) {
        if (kind == QLatin1String(words.detail))
            return &words;
    }
    return nullptr;
}

QString serverMessage(const base::Error& error)
{
    const qsizetype at = error.detail.indexOf(between);
    return at < 0 ? QString() : error.detail.mid(at + between.size());
}
} // namespace text
