// SPDX-License-Identifier: GPL-3.0-or-later
// A connection string of PostgreSQL as libpq knows it, taken apart:
// postgresql://user@host:5432/servodesk?sslmode=verify-full or host=… dbname=…. A plain value; any
// thread. Missing parts are taken by libpq from PGHOST, PGPASSWORD, ~/.pgpass … by itself. A string
// with a password or another secret is refused: it would appear in settings, lists of processes and
// logs; so is any parameter that is not known to be harmless. Fails with BadArgument, detail
// "string: what", "secret" or "parameter".
#pragma once

#include "base/error.h"

#include <QStringList>

#include <optional>
#include <utility>
#include <vector>

namespace history {
class ServerAddress {
public:
    static base::Result<ServerAddress> parse(const QString& text);

    /// `text` with every password in it masked ("•••"), whether it can be parsed or not.
    static QString masked(QString text);

    /// "user@host:5432/servodesk", for people: no options.
    QString displayText() const;
    QString value(const QString& keyword) const; ///< empty: not given
    void set(const QString& keyword, const QString& value);
    void setDefault(const QString& keyword, const QString& value);

    /// Every host it names is this very computer; true if it names none.
    bool isLocal() const;

    /// Everything but user and dbname, quoted for libpq.
    QString options() const;

private:
    static base::Result<ServerAddress> parseAll(const QString& text);
    base::Result<void> parseUri(const QString& text);
    base::Result<void> parseKeywords(const QString& text);
    base::Result<void> parseHosts(const QString& hosts);

    std::vector<std::pair<QString, QString>> m_values; ///< keyword → value, each once
};
} // namespace history
