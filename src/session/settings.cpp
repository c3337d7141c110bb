// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/settings.h"

#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QMetaType>
#include <QStandardPaths>
#include <QUrl>

#include <array>
#include <cmath>
#include <limits>

namespace session {
namespace {
constexpr int formatVersion = 1;
constexpr qint64 largestFile = 1024 * 1024;
constexpr int lowestRate = 300;
constexpr int highestRate = 10'000'000;
constexpr int longestPatienceMs = 10'000;
constexpr int longestSilenceUs = 1'000'000;
constexpr int mostRetries = 20;

const QString versionKey = QStringLiteral("version");
constexpr std::array themes{"system", "light", "dark"};
constexpr std::array parities{"none", "even", "odd"};

QString defaultPath()
{
    return QStandardPaths::writableLocation(QStandardPaths::AppConfigLocation) +
           QStringLiteral("/servodesk.ini");
}

/// QSettings takes nearly anything for an ini file. Serialised objects are never written here, and
/// are nothing to be loaded from a file that anybody may have edited.
bool isIniLine(const QByteArray& line)
{
    return line.isEmpty() || line.startsWith(';') || line.startsWith('#') ||
           (line.startsWith('[') ? line.endsWith(']')
                                 : line.contains('=') && !line.contains("@Variant("));
}

/// A file that cannot be opened is left alone: there is nothing in it that could be used or lost.
bool isBroken(const QString& path)
{
    QFile file(path);
    if (!QFileInfo(path).isFile() || !file.open(QIODevice::ReadOnly))
        return false;
    const QByteArray content = file.read(largestFile + 1);
    if (content.size() > largestFile || content.contains('\0'))
        return true;
    for (const QByteArray& line : content.split('\n')) {
        if (!isIniLine(line.trimmed()))
            return true;
    }
    return QSettings(path, QSettings::IniFormat).status() == QSettings::FormatError;
}

/// Its new name; empty when all is well. What was remembered may be dear to somebody, so it is
/// never overwritten.
QString putAside(const QString& path)
{
    if (!isBroken(path))
        return {};
    const QString stamp =
        QDateTime::currentDateTimeUtc().toString(QStringLiteral("yyyyMMdd-HHmmss-zzz"));
    const QString copy = QStringLiteral("%1.broken-%2").arg(path, stamp);
    return QFile::rename(path, copy) ? copy : QString();
}

/// Keys of adapters hold slashes and colons, which mean something in an ini file.
QString adapterGroup(const QString& adapterKey)
{
    return QStringLiteral("adapters/") +
           QString::fromLatin1(QUrl::toPercentEncoding(adapterKey)).replace(u'%', u'=') +
           QLatin1Char('/');
}

template <typename Names>
std::optional<std::size_t> indexOf(const Names& names, const QString& word)
{
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (word == QLatin1String(names[i]))
            return i;
    }
    return std::nullopt;
}

/// An ini file knows text only; what was meant is what the default is.
std::optional<QVariant> readAs(const QVariant& stored, int type)
{
    if (stored.userType() == type)
        return stored;
    const QString text = stored.userType() == QMetaType::QString ? stored.toString() : QString();
    bool good = false;
    switch (type) {
    case QMetaType::Bool:
        if (text == QLatin1String("true") || text == QLatin1String("false"))
            return QVariant(text == QLatin1String("true"));
        return std::nullopt;
    case QMetaType::Int: {
        const int value = text.toInt(&good);
        return good ? std::optional(QVariant(value)) : std::nullopt;
    }
    case QMetaType::Double: {
        const double value = text.toDouble(&good);
        return good && std::isfinite(value) ? std::optional(QVariant(value)) : std::nullopt;
    }
    case QMetaType::QStringList:
        // A list of one is written like a text, an empty one like nothing at all.
        if (!stored.isValid())
            return QVariant(QStringList());
        return text.isNull() ? std::nullopt : std::optional(QVariant(QStringList(text)));
    default:
        return std::nullopt;
    }
}

/// Nobody else's business, whatever is in it. A file system that knows no owners is no trouble.
void keepPrivate(const QString& path)
{
    constexpr QFileDevice::Permissions owner = QFileDevice::ReadOwner | QFileDevice::WriteOwner;
    constexpr QFileDevice::Permissions others = QFileDevice::ReadGroup | QFileDevice::WriteGroup |
                                                QFileDevice::ExeGroup | QFileDevice::ReadOther |
                                                QFileDevice::WriteOther | QFileDevice::ExeOther;
    if (QFileInfo(path).isFile() && (QFile::permissions(path) & others) != 0)
        QFile::setPermissions(path, owner);
}

/// QSettings keeps the permissions of a file that is there, and makes a new one for all to read.
void makePrivate(const QString& path)
{
    if (QFileInfo::exists(path) || !QDir().mkpath(QFileInfo(path).path()))
        return;
    QFile(path).open(QIODevice::WriteOnly | QIODevice::NewOnly,
                     QFileDevice::ReadOwner | QFileDevice::WriteOwner);
}

/// Before anything is read from it, or put aside.
QString privateFile(const QString& path)
{
    const QString file = path.isEmpty() ? defaultPath() : path;
    keepPrivate(file);
    return file;
}
} // namespace

Settings::Settings(const QString& path)
    : m_brokenCopy(putAside(privateFile(path)))
    , m_file(path.isEmpty() ? defaultPath() : path, QSettings::IniFormat)
{}

void Settings::put(const QString& key, const QVariant& value)
{
    makePrivate(m_file.fileName());
    // A newer version's number stays: what it knows is still in the file.
    if (!number(versionKey, formatVersion, std::numeric_limits<int>::max()))
        m_file.setValue(versionKey, formatVersion);
    if (!m_file.contains(key) || m_file.value(key) != value)
        m_file.setValue(key, value);
}

QString Settings::word(const QString& key) const
{
    const QVariant value = m_file.value(key);
    return value.userType() == QMetaType::QString ? value.toString() : QString();
}

std::optional<int> Settings::number(const QString& key, int min, int max) const
{
    const auto value = readAs(m_file.value(key), QMetaType::Int);
    if (!value || value->toInt() < min || value->toInt() > max)
        return std::nullopt;
    return value->toInt();
}

QString Settings::language() const
{
    const QString name = word(QStringLiteral("interface/language"));
    return name == QLatin1String("en") || name == QLatin1String("zh_CN") ? name : QString();
}

void Settings::setLanguage(const QString& language)
{
    put(QStringLiteral("interface/language"), language);
}

Theme Settings::theme() const
{
    return Theme(indexOf(themes, word(QStringLiteral("interface/theme"))).value_or(0));
}

void Settings::setTheme(Theme theme)
{
    put(QStringLiteral("interface/theme"), QLatin1String(themes[std::size_t(theme)]));
}

QString Settings::lastPort() const
{
    return word(QStringLiteral("port/last"));
}

QString Settings::lastAdapter() const
{
    return word(QStringLiteral("port/adapter"));
}

PortRequest Settings::usedWith(const QString& adapterKey) const
{
    const QString group = adapterGroup(adapterKey);
    PortRequest request;
    request.name = word(group + QStringLiteral("port"));
    request.baud = number(group + QStringLiteral("baud"), lowestRate, highestRate);
    request.parity = Parity(indexOf(parities, word(group + QStringLiteral("parity"))).value_or(0));
    request.protocol = base::protocolFromName(word(group + QStringLiteral("protocol")));
    if (const auto ms = number(group + QStringLiteral("patience_ms"), 1, longestPatienceMs))
        request.patience = std::chrono::milliseconds(*ms);
    if (const auto us = number(group + QStringLiteral("silence_us"), 1, longestSilenceUs))
        request.silence = base::Duration(*us);
    request.retries = number(group + QStringLiteral("retries"), 0, mostRetries);
    return request;
}

void Settings::remember(const QString& adapterKey, const PortRequest& request)
{
    const QString group = adapterGroup(adapterKey);
    const auto keep = [&](const QString& name, const std::optional<QVariant>& value) {
        if (value)
            put(group + name, *value);
        else
            m_file.remove(group + name);
    };
    keep(QStringLiteral("port"), request.name);
    keep(QStringLiteral("baud"), request.baud);
    keep(QStringLiteral("parity"), QLatin1String(parities[std::size_t(request.parity)]));
    keep(QStringLiteral("protocol"),
         request.protocol ? std::optional(base::protocolName(*request.protocol)) : std::nullopt);
    const auto ms = [](base::Duration span) { return int(span.count() / 1000); };
    keep(QStringLiteral("patience_ms"),
         request.patience ? std::optional(ms(*request.patience)) : std::nullopt);
    keep(QStringLiteral("silence_us"),
         request.silence ? std::optional(int(request.silence->count())) : std::nullopt);
    keep(QStringLiteral("retries"), request.retries);
    put(QStringLiteral("port/last"), request.name);
    put(QStringLiteral("port/adapter"), adapterKey);
}

QByteArray Settings::windowGeometry() const
{
    return choice(QStringLiteral("window/geometry"), QByteArray()).toByteArray();
}

QByteArray Settings::windowState() const
{
    return choice(QStringLiteral("window/state"), QByteArray()).toByteArray();
}

void Settings::setWindow(const QByteArray& geometry, const QByteArray& state)
{
    put(QStringLiteral("window/geometry"), geometry);
    put(QStringLiteral("window/state"), state);
}

QVariant Settings::choice(const QString& key, const QVariant& byDefault) const
{
    if (!m_file.contains(key))
        return byDefault;
    return readAs(m_file.value(key), byDefault.userType()).value_or(byDefault);
}

void Settings::setChoice(const QString& key, const QVariant& value)
{
    put(key, value);
}
} // namespace session
