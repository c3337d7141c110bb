// SPDX-License-Identifier: GPL-3.0-or-later
#include "record/server_error.h"

#include <QStringList>

namespace record {
const QString serverOperation = QStringLiteral("history-server");

namespace {
using base::ErrorCode;

constexpr qsizetype longest = 300; ///< of what a server says

struct Kind {
    ErrorCode code;
    const char* name;
};

Kind kindOf(ServerTrouble trouble)
{
    switch (trouble) {
    case ServerTrouble::Away:
        return {ErrorCode::LinkLost, "away"};
    case ServerTrouble::Hung:
        return {ErrorCode::LinkLost, "hung"};
    case ServerTrouble::Password:
        return {ErrorCode::PortPermission, "password"};
    case ServerTrouble::Database:
        return {ErrorCode::PortMissing, "database"};
    case ServerTrouble::Rights:
        return {ErrorCode::PortPermission, "rights"};
    case ServerTrouble::Refused:
        return {ErrorCode::PortFailed, "refused"};
    case ServerTrouble::Tls:
        return {ErrorCode::PortFailed, "tls"};
    case ServerTrouble::Certificate:
        return {ErrorCode::PortFailed, "certificate"};
    case ServerTrouble::HostName:
        return {ErrorCode::PortFailed, "host-name"};
    case ServerTrouble::Driver:
        return {ErrorCode::NotSupported, "driver"};
    case ServerTrouble::Newer:
        return {ErrorCode::FileFormat, "newer"};
    case ServerTrouble::Older:
        return {ErrorCode::FileFormat, "older"};
    case ServerTrouble::Empty:
        return {ErrorCode::FileMissing, "empty"};
    case ServerTrouble::Encoding:
        return {ErrorCode::FileFormat, "encoding"};
    case ServerTrouble::Busy:
        return {ErrorCode::PortBusy, "busy"};
    case ServerTrouble::Full:
        return {ErrorCode::DiskFull, "full"};
    case ServerTrouble::String:
        return {ErrorCode::BadArgument, "string"};
    case ServerTrouble::Server:
        break;
    }
    return {ErrorCode::PortFailed, "server"};
}

struct Sign {
    const char* text;
    ServerTrouble trouble;
};

template <std::size_t N>
std::optional<ServerTrouble> find(const Sign (&signs)[N], const QString& words, bool begins)
{
    for (const Sign& sign : signs) {
        const QLatin1String text(sign.text);
        if (begins ? words.startsWith(text) : words.contains(text))
            return sign.trouble;
    }
    return std::nullopt;
}

/// By SQLSTATE, or a class of them; see appendix A of PostgreSQL's manual.
constexpr Sign states[] = {
    {"28P01", ServerTrouble::Password}, {"28", ServerTrouble::Rights},
    {"42501", ServerTrouble::Rights},   {"3D000", ServerTrouble::Database},
    {"25006", ServerTrouble::Rights},   {"53100", ServerTrouble::Full},
    {"53", ServerTrouble::Busy},        {"40", ServerTrouble::Busy},
    {"55P03", ServerTrouble::Busy},     {"57014", ServerTrouble::Busy},
    {"57", ServerTrouble::Away},        {"08", ServerTrouble::Away},
    {"25P03", ServerTrouble::Away},
};

/// A failed connection has no SQLSTATE, only words: libpq's own first, then the server's.
constexpr Sign sayings[] = {
    {"timeout expired", ServerTrouble::Hung},
    {"invalid connection option", ServerTrouble::String},
    {"invalid integer value", ServerTrouble::String},
    {"invalid port number", ServerTrouble::String},
    {"value: \"", ServerTrouble::String}, // invalid sslmode value: "…"
    {"does not match host name", ServerTrouble::HostName},
    {"host name must be specified", ServerTrouble::HostName},
    {"server's host name from server certificate", ServerTrouble::HostName},
    {"certificate verify failed", ServerTrouble::Certificate},
    {"root certificate", ServerTrouble::Certificate},
    {"support SSL", ServerTrouble::Tls},
    {"SSL SYSCALL error", ServerTrouble::Away},
    {"SSL connection has been closed", ServerTrouble::Away},
    {"SSL error", ServerTrouble::Tls},
    {"SSL negotiation", ServerTrouble::Tls},
    {"certificate", ServerTrouble::Tls},
    {"no encryption", ServerTrouble::Tls},
    {"no password supplied", ServerTrouble::Password},
    {"password authentication failed", ServerTrouble::Password},
    {"too many clients", ServerTrouble::Busy},
    {"remaining connection slots", ServerTrouble::Busy},
    {"starting up", ServerTrouble::Away},
    {"shutting down", ServerTrouble::Away},
    {"recovery mode", ServerTrouble::Away},
    {"pg_hba.conf", ServerTrouble::Rights},
    {"authentication failed", ServerTrouble::Rights},
    {"is not permitted to log in", ServerTrouble::Rights},
    {"permission denied for database", ServerTrouble::Rights},
    {"Connection refused", ServerTrouble::Away},
    {"could not translate host name", ServerTrouble::Away},
    {"could not connect", ServerTrouble::Away},
    {"could not receive", ServerTrouble::Away},
    {"could not send", ServerTrouble::Away},
    {"closed the connection", ServerTrouble::Away},
    {"No route to host", ServerTrouble::Away},
    {"unreachable", ServerTrouble::Away},
    {"No such file or directory", ServerTrouble::Away},
    {"timed out", ServerTrouble::Away},
    {"reset by peer", ServerTrouble::Away},
};

ServerTrouble ofConnecting(const QString& words)
{
    const auto found = find(sayings, words, false);
    const bool role = words.contains(QLatin1String("role \""));
    if (!found && words.contains(QLatin1String("does not exist")))
        return role ? ServerTrouble::Rights : ServerTrouble::Database;
    return found.value_or(ServerTrouble::Refused);
}
} // namespace

base::Error serverError(ServerTrouble trouble, const QString& words)
{
    const Kind kind = kindOf(trouble);
    return {kind.code, serverOperation,
            QString::fromLatin1(kind.name) + QStringLiteral(": ") +
                words.simplified().left(longest)};
}

base::Error serverError(const QString& words, const QString& state, bool connecting)
{
    if (connecting) {
        static const QString guess = QStringLiteral("Is the server running");
        return serverError(ofConnecting(words), words.left(words.indexOf(guess)));
    }
    if (state.isEmpty())
        return serverError(ServerTrouble::Away, words);
    return serverError(find(states, state, true).value_or(ServerTrouble::Server), words);
}

#ifdef __linux__
PlainMessages::PlainMessages()
    : m_plain(newlocale(LC_MESSAGES_MASK, "C", duplocale(uselocale(locale_t{}))))
    , m_before(m_plain == locale_t{} ? locale_t{} : uselocale(m_plain))
{}

PlainMessages::~PlainMessages()
{
    if (m_plain == locale_t{})
        return;
    uselocale(m_before);
    freelocale(m_plain);
}
#else
PlainMessages::PlainMessages() = default;
PlainMessages::~PlainMessages() = default;
#endif
} // namespace record
