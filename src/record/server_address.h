// SPDX-License-Identifier: GPL-3.0-or-later
// A connection string of PostgreSQL as libpq knows it, taken apart:
// postgresql://user@host:5432/servodesk?sslmode=verify-full or host=… dbname=…. A plain value; any
// thread. What it does not say libpq takes from PGHOST, PGPASSWORD, .pgpass … by itself. A password
// is in here and in no text this gives out. Fails with BadArgument, detail "string: what".
#pragma once

#include "base/error.h"

#include <QStringList>

#include <utility>
#include <vector>

namespace record {
class ServerAddress {
public:
    static base::Result<ServerAddress> parse(const QString& text);

    /// "user@host:5432/servodesk", for people: no password, no options.
    QString shown() const;
    QString value(const QString& keyword) const; ///< empty: not given
    void setDefault(const QString& keyword, const QString& value);

    /// Everything but user, password and dbname, quoted for libpq.
    QString options() const;
    /// `message` with the password, should it be in there, taken out.
    QString withoutPassword(QString message) const;

private:
    base::Result<void> parseUri(const QString& text);
    base::Result<void> parseWords(const QString& text);
    base::Result<void> parseHosts(const QString& hosts);
    void add(const QString& keyword, const QString& value);

    std::vector<std::pair<QString, QString>> m_values; ///< keyword → value, each once
};
} // namespace record
