// SPDX-License-Identifier: GPL-3.0-or-later
// A message of a PostgreSQL server or libpq as an Error of history/server/history_server.h.
// Internal to history/server. Pure, but EnglishMessages: that is for the thread it lives
// on.
#pragma once

#include "base/error.h"

#ifdef __linux__
#include <clocale>
#endif

namespace history {
extern const QString serverOperation; ///< "history-server"

enum class ServerErrorKind : std::uint8_t {
    Unreachable, ///< no server there, or the connection broke
    TimedOut,    ///< connected, but no reply
    Password,    ///< wrong or missing
    Database,    ///< no database of this name
    Permission,  ///< the account lacks the rights
    Refused,     ///< for a reason in the language of the server, which is not parsed
    Tls,         ///< no encryption as asked for
    Certificate, ///< not trusted, or no authority to check it
    HostName,    ///< the certificate is for another one
    Driver,
    Newer, ///< its schema
    Older, ///< and this connection is not allowed to change it
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

/// While it lives, libpq's own messages on this thread are the English ones, which can be
/// recognized; without any effect where the system cannot.
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
} // namespace history
