// SPDX-License-Identifier: GPL-3.0-or-later
#include "record/server_address.h"

#include <QUrl>

namespace record {
namespace {
const QString passwordWord = QStringLiteral("password");

tl::unexpected<base::Error> wrong(const QString& what)
{
    return base::fail(base::ErrorCode::BadArgument, QStringLiteral("history-server"),
                      QStringLiteral("string: ") + what);
}

QString decoded(const QString& text)
{
    return QUrl::fromPercentEncoding(text.toUtf8());
}

/// From `at` on: the value, quoted or up to the next blank; nullopt: a quote is not closed.
std::optional<QString> takeValue(const QString& text, qsizetype& at)
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
    ServerAddress address;
    const QString trimmed = text.trimmed();
    if (trimmed.isEmpty())
        return wrong(QStringLiteral("empty"));
    const bool uri = trimmed.contains(QLatin1String("://"));
    const auto done = uri ? address.parseUri(trimmed) : address.parseWords(trimmed);
    if (!done)
        return tl::unexpected(done.error());
    for (const auto& [keyword, value] : address.m_values) {
        // Qt's driver parts options at semicolons.
        if (value.contains(u';') && keyword != passwordWord && keyword != QLatin1String("user") &&
            keyword != QLatin1String("dbname"))
            return wrong(QStringLiteral("; in %1").arg(keyword));
    }
    return address;
}

/// The last one counts, as with libpq.
void ServerAddress::add(const QString& keyword, const QString& value)
{
    for (auto& known : m_values) {
        if (known.first == keyword) {
            known.second = value;
            return;
        }
    }
    m_values.emplace_back(keyword, value);
}

/// "host:port,[::1]:port"; what has no port leaves its place in the list empty, as libpq expects.
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
                return wrong(QStringLiteral("[ without ]"));
            name = one.mid(1, close - 1);
            colon = close + 1 < one.size() && one[close + 1] == u':' ? close + 1 : -1;
        } else if (colon >= 0) {
            name = one.left(colon);
        }
        names.append(decoded(name));
        ports.append(colon < 0 ? QString() : one.mid(colon + 1));
    }
    if (!names.join(QString()).isEmpty())
        add(QStringLiteral("host"), names.join(u','));
    if (!ports.join(QString()).isEmpty())
        add(QStringLiteral("port"), ports.join(u','));
    return {};
}

base::Result<void> ServerAddress::parseUri(const QString& text)
{
    const qsizetype scheme = text.indexOf(QLatin1String("://"));
    const QString name = text.left(scheme);
    if (name != QLatin1String("postgresql") && name != QLatin1String("postgres"))
        return wrong(QStringLiteral("postgresql:// expected"));
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
        add(QStringLiteral("user"), decoded(colon < 0 ? who : who.left(colon)));
        if (colon >= 0)
            add(passwordWord, decoded(who.mid(colon + 1)));
    }
    if (const auto hosts = parseHosts(server); !hosts)
        return hosts;
    if (slash >= 0 && slash + 1 < rest.size())
        add(QStringLiteral("dbname"), decoded(rest.mid(slash + 1)));
    for (const QString& one : parameters.split(u'&', Qt::SkipEmptyParts)) {
        const qsizetype equals = one.indexOf(u'=');
        if (equals < 1)
            return wrong(QStringLiteral("a parameter without ="));
        add(decoded(one.left(equals)), decoded(one.mid(equals + 1)));
    }
    return {};
}

base::Result<void> ServerAddress::parseWords(const QString& text)
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
        // What is wrong may be a part of the password, so it is not repeated.
        if (keyword.isEmpty() || at >= text.size() || text[at] != u'=')
            return wrong(QStringLiteral("a word without ="));
        ++at;
        skipBlanks();
        const auto value = takeValue(text, at);
        if (!value)
            return wrong(QStringLiteral("a quote is not closed"));
        add(keyword, *value);
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
        add(keyword, value);
}

QString ServerAddress::shown() const
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
        if (keyword != passwordWord && keyword != QLatin1String("user") &&
            keyword != QLatin1String("dbname"))
            words.append(keyword + u'=' + quoted(value));
    }
    return words.join(u' ');
}

QString ServerAddress::withoutPassword(QString message) const
{
    const QString password = value(passwordWord);
    // One that is a name as well, or a syllable, gives nothing away and would only spoil the text.
    if (password.size() < 4 || shown().contains(password))
        return message;
    return message.replace(password, QStringLiteral("•••"));
}
} // namespace record
