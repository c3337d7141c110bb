// SPDX-License-Identifier: GPL-3.0-or-later
#include "history/server/server_address.h"

#include <QRegularExpression>
#include <QUrl>

#include <algorithm>
#include <array>

namespace history {
namespace {
const QString passwordKeyword = QStringLiteral("password");

/// The parameters of libpq that hold no secret. All others are refused: a later libpq may have a
/// secret in it, and what `options` sets on the server is this program's business.
constexpr std::array allowedKeywords{
    "host",
    "hostaddr",
    "port",
    "dbname",
    "user",
    "passfile",
    "service",
    "servicefile",
    "connect_timeout",
    "tcp_user_timeout",
    "keepalives",
    "keepalives_idle",
    "keepalives_interval",
    "keepalives_count",
    "application_name",
    "fallback_application_name",
    "client_encoding",
    "target_session_attrs",
    "load_balance_hosts",
    "require_auth",
    "requirepeer",
    "channel_binding",
    "sslmode",
    "sslnegotiation",
    "sslcompression",
    "sslcert",
    "sslkey",
    "sslcertmode",
    "sslrootcert",
    "sslcrl",
    "sslcrldir",
    "sslsni",
    "ssl_min_protocol_version",
    "ssl_max_protocol_version",
    "gssencmode",
    "gssdelegation",
    "gsslib",
    "krbsrvname",
};

bool isAllowed(const QString& keyword)
{
    return std::any_of(allowedKeywords.begin(), allowedKeywords.end(),
                       [&](const char* word) { return keyword == QLatin1String(word); });
}

/// Secrets of libpq, also with common misspellings, and inside `options`.
bool isSecret(const QString& keyword, const QString& value)
{
    static const QRegularExpression secret(
        QStringLiteral("(password|passwd|passphrase|pass|pwd|secret|token)$"),
        QRegularExpression::CaseInsensitiveOption);
    static const QRegularExpression inside(
        QStringLiteral("(password|passwd|passphrase|pass|pwd|secret|token)\\s*="),
        QRegularExpression::CaseInsensitiveOption);
    return secret.match(keyword).hasMatch() ||
           (!isAllowed(keyword) && inside.match(value).hasMatch());
}

/// Sockets in the file system and names of this computer that no name server can change.
bool isLoopback(const QString& host)
{
    static const QRegularExpression loopback(
        QStringLiteral(R"(^(127(\.\d{1,3}){3}|localhost|::1)$)"),
        QRegularExpression::CaseInsensitiveOption);
    return host.isEmpty() || host.startsWith(u'/') || host.startsWith(u'@') ||
           loopback.match(host).hasMatch();
}

tl::unexpected<base::Error> parseError(const QString& what)
{
    return base::fail(base::ErrorCode::BadArgument, QStringLiteral("history-server"),
                      QStringLiteral("string: ") + what);
}

QString decoded(const QString& text)
{
    return QUrl::fromPercentEncoding(text.toUtf8());
}

/// From `at` on: the value, quoted or up to the next blank; nullopt: a quote is not closed.
std::optional<QString> parseValue(const QString& text, qsizetype& at)
{
    QString value;
    const bool quoted = at < text.size() && text[at] == u'\'';
    if (quoted)
        ++at;
    for (; at < text.size(); ++at) {
        QChar c = text[at];
        if (quoted ? c == u'\'' : c.isSpace())
            break;
        if (c == u'\\' && at + 1 < text.size())
            c = text[++at];
        value += c;
    }
    if (!quoted)
        return value;
    if (at >= text.size())
        return std::nullopt;
    ++at;
    return value;
}

QString quoted(QString value)
{
    value.replace(u'\\', QStringLiteral("\\\\")).replace(u'\'', QStringLiteral("\\'"));
    return u'\'' + value + u'\'';
}
} // namespace

base::Result<ServerAddress> ServerAddress::parse(const QString& text)
{
    auto address = parseAll(text);
    if (!address)
        return address;
    for (const auto& [keyword, value] : address->m_values) {
        if (isSecret(keyword, value) && !value.isEmpty())
            return base::fail(base::ErrorCode::BadArgument, QStringLiteral("history-server"),
                              QStringLiteral("secret"));
    }
    for (const auto& [keyword, value] : address->m_values) {
        // The error does not repeat the word: it may be part of a password.
        if (!isAllowed(keyword) && !isSecret(keyword, value))
            return base::fail(base::ErrorCode::BadArgument, QStringLiteral("history-server"),
                              QStringLiteral("parameter"));
    }
    return address;
}

base::Result<ServerAddress> ServerAddress::parseAll(const QString& text)
{
    ServerAddress address;
    const QString trimmed = text.trimmed();
    if (trimmed.isEmpty())
        return parseError(QStringLiteral("empty"));
    const bool uri = trimmed.contains(QLatin1String("://"));
    const auto done = uri ? address.parseUri(trimmed) : address.parseKeywords(trimmed);
    if (!done)
        return tl::unexpected(done.error());
    for (const auto& [keyword, value] : address.m_values) {
        // Qt's driver splits options at semicolons.
        if (value.contains(u';') && !isSecret(keyword, value) && keyword != QLatin1String("user") &&
            keyword != QLatin1String("dbname"))
            return parseError(QStringLiteral("; in %1").arg(keyword));
    }
    return address;
}

/// The last one counts, as with libpq.
void ServerAddress::set(const QString& keyword, const QString& value)
{
    for (auto& known : m_values) {
        if (known.first == keyword) {
            known.second = value;
            return;
        }
    }
    m_values.emplace_back(keyword, value);
}

/// "host:port,[::1]:port"; a host without a port has an empty entry in the list, as libpq expects.
base::Result<void> ServerAddress::parseHosts(const QString& hosts)
{
    QStringList names;
    QStringList ports;
    for (const QString& one : hosts.split(u',')) {
        qsizetype colon = one.lastIndexOf(u':');
        QString name = one;
        if (one.startsWith(u'[')) {
            const qsizetype close = one.indexOf(u']');
            if (close < 0)
                return parseError(QStringLiteral("[ without ]"));
            name = one.mid(1, close - 1);
            colon = close + 1 < one.size() && one[close + 1] == u':' ? close + 1 : -1;
        } else if (colon >= 0) {
            name = one.left(colon);
        }
        names.append(decoded(name));
        const QString port = colon < 0 ? QString() : one.mid(colon + 1);
        if (std::any_of(port.begin(), port.end(), [](QChar c) { return !c.isDigit(); }))
            return parseError(QStringLiteral("the port is not a number"));
        ports.append(port);
    }
    if (!names.join(QString()).isEmpty())
        set(QStringLiteral("host"), names.join(u','));
    if (!ports.join(QString()).isEmpty())
        set(QStringLiteral("port"), ports.join(u','));
    return {};
}

base::Result<void> ServerAddress::parseUri(const QString& text)
{
    const qsizetype scheme = text.indexOf(QLatin1String("://"));
    const QString name = text.left(scheme);
    if (name != QLatin1String("postgresql") && name != QLatin1String("postgres"))
        return parseError(QStringLiteral("postgresql:// expected"));
    QString rest = text.mid(scheme + 3);
    const qsizetype question = rest.indexOf(u'?');
    const QString parameters = question < 0 ? QString() : rest.mid(question + 1);
    rest = question < 0 ? rest : rest.left(question);
    const qsizetype slash = rest.indexOf(u'/');
    QString server = slash < 0 ? rest : rest.left(slash);
    if (const qsizetype at = server.lastIndexOf(u'@'); at >= 0) {
        const QString who = server.left(at);
        server = server.mid(at + 1);
        const qsizetype colon = who.indexOf(u':');
        set(QStringLiteral("user"), decoded(colon < 0 ? who : who.left(colon)));
        if (colon >= 0)
            set(passwordKeyword, decoded(who.mid(colon + 1)));
    }
    if (const auto hosts = parseHosts(server); !hosts)
        return hosts;
    // An @ after the slash comes from a password with a slash in it.
    if (slash >= 0 && rest.indexOf(u'@', slash) >= 0)
        return parseError(QStringLiteral("@ in the name of the database; write %40"));
    if (slash >= 0 && slash + 1 < rest.size())
        set(QStringLiteral("dbname"), decoded(rest.mid(slash + 1)));
    for (const QString& one : parameters.split(u'&', Qt::SkipEmptyParts)) {
        const qsizetype equals = one.indexOf(u'=');
        if (equals < 1)
            return parseError(QStringLiteral("a parameter without ="));
        set(decoded(one.left(equals)), decoded(one.mid(equals + 1)));
    }
    return {};
}

base::Result<void> ServerAddress::parseKeywords(const QString& text)
{
    qsizetype at = 0;
    const auto skipBlanks = [&] {
        while (at < text.size() && text[at].isSpace())
            ++at;
    };
    for (skipBlanks(); at < text.size(); skipBlanks()) {
        const qsizetype from = at;
        while (at < text.size() && text[at] != u'=' && !text[at].isSpace())
            ++at;
        const QString keyword = text.mid(from, at - from);
        skipBlanks();
        // The faulty part may belong to the password, so the error does not repeat it.
        if (keyword.isEmpty() || at >= text.size() || text[at] != u'=')
            return parseError(QStringLiteral("a word without ="));
        ++at;
        skipBlanks();
        const auto value = parseValue(text, at);
        if (!value)
            return parseError(QStringLiteral("a quote is not closed"));
        set(keyword, *value);
    }
    return {};
}

QString ServerAddress::value(const QString& keyword) const
{
    for (const auto& known : m_values) {
        if (known.first == keyword)
            return known.second;
    }
    return {};
}

void ServerAddress::setDefault(const QString& keyword, const QString& value)
{
    if (this->value(keyword).isEmpty())
        set(keyword, value);
}

QString ServerAddress::displayText() const
{
    QString text = value(QStringLiteral("host"));
    if (text.isEmpty())
        text = value(QStringLiteral("hostaddr"));
    if (text.isEmpty())
        text = value(QStringLiteral("service"));
    if (const QString user = value(QStringLiteral("user")); !user.isEmpty())
        text.prepend(user + u'@');
    if (const QString port = value(QStringLiteral("port")); !port.isEmpty())
        text += u':' + port;
    if (const QString name = value(QStringLiteral("dbname")); !name.isEmpty())
        text += u'/' + name;
    return text;
}

QString ServerAddress::options() const
{
    QStringList words;
    for (const auto& [keyword, value] : m_values) {
        if (!isSecret(keyword, value) && keyword != QLatin1String("user") &&
            keyword != QLatin1String("dbname"))
            words.append(keyword + u'=' + quoted(value));
    }
    return words.join(u' ');
}

bool ServerAddress::isLocal() const
{
    const QStringList hosts =
        value(QStringLiteral("host")).split(u',') + value(QStringLiteral("hostaddr")).split(u',');
    return std::all_of(hosts.begin(), hosts.end(), isLoopback);
}

QString ServerAddress::masked(QString text)
{
    static const QString maskText = QStringLiteral("•••");
    static const QRegularExpression inUri(QStringLiteral(R"((://[^:/?@\s]*:)\S*(@))"));
    static const QRegularExpression inKeywords(
        QStringLiteral(
            R"(((?:password|passwd|passphrase|\bpass|pwd|secret|token)\s*(?:=|%3D)\s*)(?:'(?:[^'\\]|\\.)*'?|(?:\\.|\S)+))"),
        QRegularExpression::CaseInsensitiveOption);
    text.replace(inUri, QStringLiteral("\\1") + maskText + QStringLiteral("\\2"));
    return text.replace(inKeywords, QStringLiteral("\\1") + maskText);
}
} // namespace history
