// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/settings.h"

#include "base/enum_names.h"

#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QMetaType>
#include <QStandardPaths>
#include <QUrl>

#include <cmath>
#include <limits>

namespace session {
namespace {
constexpr int formatVersion = 1;
constexpr qint64 maxFileSize = 1024 * 1024;
constexpr int minRate = 300;
constexpr int maxRate = 10'000'000;
constexpr int maxTimeoutMs = 10'000;
constexpr int maxSilenceUs = 1'000'000;
constexpr int maxRetries = 20;

const QString versionKey = QStringLiteral("version");
constexpr base::EnumName<Theme> themeNames[]{
    {Theme::System, "system"}, {Theme::Light, "light"}, {Theme::Dark, "dark"}};
constexpr base::EnumName<Parity> parityNames[]{
    {Parity::None, "none"}, {Parity::Even, "even"}, {Parity::Odd, "odd"}};

QString defaultPath()
{
    return QStandardPaths::writableLocation(QStandardPaths::AppConfigLocation) +
           QStringLiteral("/servodesk.ini");
}

/// QSettings takes nearly anything for an ini file. Serialized objects are never written here, and
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
    const QByteArray content = file.read(maxFileSize + 1);
    if (content.size() > maxFileSize || content.contains('\0'))
        return true;
    for (const QByteArray& line : content.split('\n')) {
        if (!isIniLine(line.trimmed()))
            return true;
    }
    return QSettings(path, QSettings::IniFormat).status() == QSettings::FormatError;
}

/// Its new name; empty when all is well. What was remembered may be dear to somebody, so it is
/// never overwritten.
QString moveBrokenFile(const QString& path)
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

/// Readable by the user only. A file system without owners is no error.
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
    : m_brokenCopy(moveBrokenFile(privateFile(path)))
    , m_file(path.isEmpty() ? defaultPath() : path, QSettings::IniFormat)
{}

void Settings::write(const QString& key, const QVariant& value)
{
    makePrivate(m_file.fileName());
    // A newer version's number stays: what it knows is still in the file.
    if (!readNumber(versionKey, formatVersion, std::numeric_limits<int>::max()))
        m_file.setValue(versionKey, formatVersion);
    if (!m_file.contains(key) || m_file.value(key) != value)
        m_file.setValue(key, value);
}

QString Settings::readText(const QString& key) const
{
    const QVariant value = m_file.value(key);
    return value.userType() == QMetaType::QString ? value.toString() : QString();
}

std::optional<int> Settings::readNumber(const QString& key, int min, int max) const
{
    const auto value = readAs(m_file.value(key), QMetaType::Int);
    if (!value || value->toInt() < min || value->toInt() > max)
        return std::nullopt;
    return value->toInt();
}

QString Settings::language() const
{
    const QString name = readText(QStringLiteral("interface/language"));
    return name == QLatin1String("en") || name == QLatin1String("zh_CN") ? name : QString();
}

void Settings::setLanguage(const QString& language)
{
    write(QStringLiteral("interface/language"), language);
}

Theme Settings::theme() const
{
    return base::valueOf(themeNames, readText(QStringLiteral("interface/theme")))
        .value_or(Theme::System);
}

void Settings::setTheme(Theme theme)
{
    write(QStringLiteral("interface/theme"), base::nameOf(themeNames, theme));
}

QString Settings::lastPort() const
{
    return readText(QStringLiteral("port/last"));
}

QString Settings::lastAdapter() const
{
    return readText(QStringLiteral("port/adapter"));
}

PortRequest Settings::lastRequestFor(const QString& adapterKey) const
{
    const QString group = adapterGroup(adapterKey);
    PortRequest request;
    request.name = readText(group + QStringLiteral("port"));
    request.baud = readNumber(group + QStringLiteral("baud"), minRate, maxRate);
    request.parity = base::valueOf(parityNames, readText(group + QStringLiteral("parity")))
                         .value_or(Parity::None);
    request.protocol = base::protocolFromName(readText(group + QStringLiteral("protocol")));
    if (const auto ms = readNumber(group + QStringLiteral("patience_ms"), 1, maxTimeoutMs))
        request.maxReplyLateness = std::chrono::milliseconds(*ms);
    if (const auto us = readNumber(group + QStringLiteral("silence_us"), 1, maxSilenceUs))
        request.frameSilence = base::Duration(*us);
    request.retries = readNumber(group + QStringLiteral("retries"), 0, maxRetries);
    return request;
}

void Settings::saveRequest(const QString& adapterKey, const PortRequest& request)
{
    const QString group = adapterGroup(adapterKey);
    const auto keep = [&](const QString& name, const std::optional<QVariant>& value) {
        if (value)
            write(group + name, *value);
        else
            m_file.remove(group + name);
    };
    keep(QStringLiteral("port"), request.name);
    keep(QStringLiteral("baud"), request.baud);
    keep(QStringLiteral("parity"), base::nameOf(parityNames, request.parity));
    keep(QStringLiteral("protocol"),
         request.protocol ? std::optional(base::protocolName(*request.protocol)) : std::nullopt);
    const auto ms = [](base::Duration span) { return int(span.count() / 1000); };
    keep(QStringLiteral("patience_ms"),
         request.maxReplyLateness ? std::optional(ms(*request.maxReplyLateness)) : std::nullopt);
    keep(QStringLiteral("silence_us"),
         request.frameSilence ? std::optional(int(request.frameSilence->count())) : std::nullopt);
    keep(QStringLiteral("retries"), request.retries);
    write(QStringLiteral("port/last"), request.name);
    write(QStringLiteral("port/adapter"), adapterKey);
}

QByteArray Settings::windowGeometry() const
{
    return pageValue(QStringLiteral("window/geometry"), QByteArray()).toByteArray();
}

QByteArray Settings::windowState() const
{
    return pageValue(QStringLiteral("window/state"), QByteArray()).toByteArray();
}

void Settings::setWindow(const QByteArray& geometry, const QByteArray& state)
{
    write(QStringLiteral("window/geometry"), geometry);
    write(QStringLiteral("window/state"), state);
}

QVariant Settings::pageValue(const QString& key, const QVariant& byDefault) const
{
    if (!m_file.contains(key))
        return byDefault;
    return readAs(m_file.value(key), byDefault.userType()).value_or(byDefault);
}

void Settings::setPageValue(const QString& key, const QVariant& value)
{
    write(key, value);
}
} // namespace session
