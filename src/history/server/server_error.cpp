// SPDX-License-Identifier: GPL-3.0-or-later
#include "history/server/server_error.h"

#include <QStringList>

namespace history {
const QString serverOperation = QStringLiteral("history-server");

namespace {
using base::ErrorCode;

constexpr qsizetype maxMessageLength = 300; ///< of a message of the server

struct Kind {
    ErrorCode code;
    const char* name;
};

Kind kindOf(ServerErrorKind errorKind)
{
    switch (errorKind) {
    case ServerErrorKind::Unreachable:
        return {ErrorCode::LinkLost, "away"};
    case ServerErrorKind::TimedOut:
        return {ErrorCode::LinkLost, "hung"};
    case ServerErrorKind::Password:
        return {ErrorCode::PortPermission, "password"};
    case ServerErrorKind::Database:
        return {ErrorCode::PortMissing, "database"};
    case ServerErrorKind::Permission:
        return {ErrorCode::PortPermission, "rights"};
    case ServerErrorKind::Refused:
        return {ErrorCode::PortFailed, "refused"};
    case ServerErrorKind::Tls:
        return {ErrorCode::PortFailed, "tls"};
    case ServerErrorKind::Certificate:
        return {ErrorCode::PortFailed, "certificate"};
    case ServerErrorKind::HostName:
        return {ErrorCode::PortFailed, "host-name"};
    case ServerErrorKind::Driver:
        return {ErrorCode::NotSupported, "driver"};
    case ServerErrorKind::Newer:
        return {ErrorCode::FileFormat, "newer"};
    case ServerErrorKind::Older:
        return {ErrorCode::FileFormat, "older"};
    case ServerErrorKind::Empty:
        return {ErrorCode::FileMissing, "empty"};
    case ServerErrorKind::Encoding:
        return {ErrorCode::FileFormat, "encoding"};
    case ServerErrorKind::Busy:
        return {ErrorCode::PortBusy, "busy"};
    case ServerErrorKind::Full:
        return {ErrorCode::DiskFull, "full"};
    case ServerErrorKind::ConnectionString:
        return {ErrorCode::BadArgument, "string"};
    case ServerErrorKind::Other:
        break;
    }
    return {ErrorCode::PortFailed, "server"};
}

struct ErrorPattern {
    const char* text;
    ServerErrorKind errorKind;
};

template <std::size_t N>
std::optional<ServerErrorKind> findKind(const ErrorPattern (&patterns)[N], const QString& message,
                                        bool begins)
{
    for (const ErrorPattern& pattern : patterns) {
        const QLatin1String text(pattern.text);
        if (begins ? message.startsWith(text) : message.contains(text))
            return pattern.errorKind;
    }
    return std::nullopt;
}

/// By SQLSTATE, or a class of them; see appendix A of PostgreSQL's manual.
constexpr ErrorPattern sqlStates[] = {
    {"28P01", ServerErrorKind::Password},    {"28", ServerErrorKind::Permission},
    {"42501", ServerErrorKind::Permission},  {"3D000", ServerErrorKind::Database},
    {"25006", ServerErrorKind::Permission},  {"53100", ServerErrorKind::Full},
    {"53", ServerErrorKind::Busy},           {"40", ServerErrorKind::Busy},
    {"55P03", ServerErrorKind::Busy},        {"57014", ServerErrorKind::Busy},
    {"57", ServerErrorKind::Unreachable},    {"08", ServerErrorKind::Unreachable},
    {"25P03", ServerErrorKind::Unreachable},
};

/// A failed connection has no SQLSTATE, only words: libpq's own first, then the server's.
constexpr ErrorPattern messagePatterns[] = {
    {"timeout expired", ServerErrorKind::TimedOut},
    {"invalid connection option", ServerErrorKind::ConnectionString},
    {"invalid integer value", ServerErrorKind::ConnectionString},
    {"invalid port number", ServerErrorKind::ConnectionString},
    {"value: \"", ServerErrorKind::ConnectionString}, // invalid sslmode value: "…"
    {"does not match host name", ServerErrorKind::HostName},
    {"host name must be specified", ServerErrorKind::HostName},
    {"server's host name from server certificate", ServerErrorKind::HostName},
    {"certificate verify failed", ServerErrorKind::Certificate},
    {"root certificate", ServerErrorKind::Certificate},
    {"support SSL", ServerErrorKind::Tls},
    {"SSL SYSCALL error", ServerErrorKind::Unreachable},
    {"SSL connection has been closed", ServerErrorKind::Unreachable},
    {"SSL error", ServerErrorKind::Tls},
    {"SSL negotiation", ServerErrorKind::Tls},
    {"certificate", ServerErrorKind::Tls},
    {"no encryption", ServerErrorKind::Tls},
    {"no password supplied", ServerErrorKind::Password},
    {"password authentication failed", ServerErrorKind::Password},
    {"too many clients", ServerErrorKind::Busy},
    {"remaining connection slots", ServerErrorKind::Busy},
    {"starting up", ServerErrorKind::Unreachable},
    {"shutting down", ServerErrorKind::Unreachable},
    {"recovery mode", ServerErrorKind::Unreachable},
    {"pg_hba.conf", ServerErrorKind::Permission},
    {"authentication failed", ServerErrorKind::Permission},
    {"is not permitted to log in", ServerErrorKind::Permission},
    {"permission denied for database", ServerErrorKind::Permission},
    {"Connection refused", ServerErrorKind::Unreachable},
    {"could not translate host name", ServerErrorKind::Unreachable},
    {"could not connect", ServerErrorKind::Unreachable},
    {"could not receive", ServerErrorKind::Unreachable},
    {"could not send", ServerErrorKind::Unreachable},
    {"closed the connection", ServerErrorKind::Unreachable},
    {"No route to host", ServerErrorKind::Unreachable},
    {"unreachable", ServerErrorKind::Unreachable},
    {"No such file or directory", ServerErrorKind::Unreachable},
    {"timed out", ServerErrorKind::Unreachable},
    {"reset by peer", ServerErrorKind::Unreachable},
};

ServerErrorKind classifyConnectionError(const QString& message)
{
    const auto found = findKind(messagePatterns, message, false);
    const bool role = message.contains(QLatin1String("role \""));
    if (!found && message.contains(QLatin1String("does not exist")))
        return role ? ServerErrorKind::Permission : ServerErrorKind::Database;
    return found.value_or(ServerErrorKind::Refused);
}
} // namespace

base::Error serverError(ServerErrorKind errorKind, const QString& message)
{
    const Kind kind = kindOf(errorKind);
    return {kind.code, serverOperation,
            QString::fromLatin1(kind.name) + QStringLiteral(": ") +
                message.simplified().left(maxMessageLength)};
}

base::Error serverError(const QString& message, const QString& state, bool connecting)
{
    if (connecting) {
        static const QString guess = QStringLiteral("Is the server running");
        return serverError(classifyConnectionError(message), message.left(message.indexOf(guess)));
    }
    if (state.isEmpty())
        return serverError(ServerErrorKind::Unreachable, message);
    return serverError(findKind(sqlStates, state, true).value_or(ServerErrorKind::Other), message);
}

#ifdef __linux__
EnglishMessages::EnglishMessages()
    : m_englishLocale(newlocale(LC_MESSAGES_MASK, "C", duplocale(uselocale(locale_t{}))))
    , m_before(m_englishLocale == locale_t{} ? locale_t{} : uselocale(m_englishLocale))
{}

EnglishMessages::~EnglishMessages()
{
    if (m_englishLocale == locale_t{})
        return;
    uselocale(m_before);
    freelocale(m_englishLocale);
}
#else
EnglishMessages::EnglishMessages() = default;
EnglishMessages::~EnglishMessages() = default;
#endif
} // namespace history
