// SPDX-License-Identifier: GPL-3.0-or-later
// What a PostgreSQL server or libpq says, as an Error of record/history_server.h. Internal to
// record/history_server*. Pure, but EnglishMessages: that is for the thread it lives on.
#pragma once

#include "base/error.h"

#ifdef __linux__
#include <clocale>
#endif

namespace record {
extern const QString serverOperation; ///< "history-server"

enum class ServerErrorKind : std::uint8_t {
    Unreachable, ///< nobody there, or the line broke
    TimedOut,    ///< somebody is there and says nothing
    Password,    ///< wrong or missing
    Database,    ///< there is none of this name
    Permission,  ///< the account may not
    Refused, ///< it let nobody in, for a reason in words we cannot read (its language is its own)
    Tls,     ///< no encryption as asked for
    Certificate, ///< it is not trusted, or there is nothing to check it against
    HostName,    ///< the certificate is for another one
    Driver,
    Newer, ///< its schema
    Older, ///< and this connection may not change it
    Empty,
    Encoding,
    Busy,
    Full,
    ConnectionString,
    Other, ///< anything else
};

base::Error serverError(ServerErrorKind errorKind, const QString& message);
/// `state`: SQLSTATE; empty where the connection itself failed.
base::Error serverError(const QString& message, const QString& state, bool connecting);

/// While it lives, libpq's own messages on this thread are the English ones, which can be told
/// apart; without any effect where the system cannot.
class EnglishMessages {
public:
    EnglishMessages();
    ~EnglishMessages();
    EnglishMessages(const EnglishMessages&) = delete;
    EnglishMessages& operator=(const EnglishMessages&) = delete;

#ifdef __linux__
private:
    locale_t m_englishLocale{};
    locale_t m_before{};
#endif
};
} // namespace record
