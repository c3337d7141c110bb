// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/trends/trend_preset.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <cmath>

namespace ui {
namespace {
const QString settingsKey = QStringLiteral("trend/presets"); // one text: { name: preset }
constexpr double longest = 30.0 * 24 * 3600 * 1e6;

QJsonObject all(const session::Settings& settings)
{
    return QJsonDocument::fromJson(settings.pageValue(settingsKey, QString()).toString().toUtf8())
        .object();
}

void keep(session::Settings& settings, const QJsonObject& presets)
{
    settings.setPageValue(settingsKey,
                          QString::fromUtf8(QJsonDocument(presets).toJson(QJsonDocument::Compact)));
}

QJsonObject written(const TrendPreset& preset)
{
    QJsonArray channels;
    for (const PresetChannel& channel : preset.channels) {
        channels << QJsonObject{
            {QStringLiteral("key"), channel.key},
            {QStringLiteral("visible"), channel.visible},
            {QStringLiteral("colour"), channel.color.isValid() ? channel.color.name() : QString()},
            {QStringLiteral("scale"), channel.scale},
            {QStringLiteral("offset"), channel.offset}};
    }
    return {{QStringLiteral("width_us"), double(preset.width.count())},
            {QStringLiteral("channels"), channels}};
}

PresetChannel readChannel(const QJsonObject& object)
{
    PresetChannel channel;
    channel.key = object[QStringLiteral("key")].toString();
    channel.visible = object[QStringLiteral("visible")].toBool(true);
    channel.color = QColor(object[QStringLiteral("colour")].toString());
    channel.scale = object[QStringLiteral("scale")].toDouble(1.0);
    channel.offset = object[QStringLiteral("offset")].toDouble(0.0);
    if (channel.scale == 0 || !std::isfinite(channel.scale))
        channel.scale = 1.0;
    return channel;
}

TrendPreset readPreset(const QJsonObject& object)
{
    TrendPreset preset;
    const double width = object[QStringLiteral("width_us")].toDouble();
    if (width >= 1000 && width <= longest)
        preset.width = base::Duration(std::int64_t(width));
    for (const QJsonValue& value : object[QStringLiteral("channels")].toArray()) {
        PresetChannel channel = readChannel(value.toObject());
        if (!channel.key.isEmpty())
            preset.channels.push_back(std::move(channel));
    }
    return preset;
}
} // namespace

QStringList presetNames(const session::Settings& settings)
{
    QStringList names = all(settings).keys();
    names.sort(Qt::CaseInsensitive);
    return names;
}

std::optional<TrendPreset> loadPreset(const session::Settings& settings, const QString& name)
{
    const QJsonObject presets = all(settings);
    const auto found = presets.find(name);
    if (found == presets.end() || !found->isObject())
        return {};
    return readPreset(found->toObject());
}

bool savePreset(session::Settings& settings, const QString& name, const TrendPreset& preset)
{
    const QString tidy = name.simplified();
    if (tidy.isEmpty())
        return false;
    QJsonObject presets = all(settings);
    presets[tidy] = written(preset);
    keep(settings, presets);
    return true;
}

void deletePreset(session::Settings& settings, const QString& name)
{
    QJsonObject presets = all(settings);
    presets.remove(name);
    keep(settings, presets);
}
} // namespace ui
