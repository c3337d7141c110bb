// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/trends/trend_curves.h"

#include "catalog/units.h"
#include "text/language.h"
#include "text/translate.h"
#include "ui/common/palette.h"
#include "ui/widgets/feedback.h"

#include <algorithm>
#include <array>

namespace ui {
using catalog::Role;
using text::translate;

namespace {
struct BuiltInCurve {
    const char* key;
    Role role; ///< None: goal and error, which are asked for otherwise
    const char* name;
};
constexpr std::array builtInCurves{
    BuiltInCurve{"@goal", Role::None, QT_TRANSLATE_NOOP("Trend", "Goal")},
    BuiltInCurve{"@position", Role::PresentPosition, QT_TRANSLATE_NOOP("Trend", "Position")},
    BuiltInCurve{"@error", Role::None, QT_TRANSLATE_NOOP("Trend", "Error (goal − position)")},
    BuiltInCurve{"@speed", Role::PresentSpeed, QT_TRANSLATE_NOOP("Trend", "Speed")},
    BuiltInCurve{"@load", Role::PresentLoad, QT_TRANSLATE_NOOP("Trend", "Load")},
    BuiltInCurve{"@current", Role::PresentCurrent, QT_TRANSLATE_NOOP("Trend", "Current")},
    BuiltInCurve{"@voltage", Role::PresentVoltage, QT_TRANSLATE_NOOP("Trend", "Voltage")},
    BuiltInCurve{"@temperature", Role::PresentTemperature,
                 QT_TRANSLATE_NOOP("Trend", "Temperature")},
    BuiltInCurve{"@moving", Role::Moving, QT_TRANSLATE_NOOP("Trend", "Moving flag")},
};

const BuiltInCurve* findBuiltIn(const QString& key)
{
    const auto found =
        std::find_if(builtInCurves.begin(), builtInCurves.end(),
                     [&](const BuiltInCurve& one) { return key == QLatin1StringView(one.key); });
    return found != builtInCurves.end() ? &*found : nullptr;
}

QString nameOf(const catalog::Profile& profile, const QString& key)
{
    if (const BuiltInCurve* made = findBuiltIn(key))
        return translate("Trend", made->name);
    if (key == session::errorKey)
        return translate("Trend", "Error (goal − position)");
    return text::registerName(&profile, key);
}

bool holdsItsValue(const catalog::Register* reg)
{
    return reg != nullptr &&
           (reg->area != catalog::Area::Feedback || reg->encoding == catalog::Encoding::Enum ||
            reg->encoding == catalog::Encoding::Bits || reg->role == Role::ActiveGoal);
}
} // namespace

TrendCurve TrendCurve::fromId(const QString& id)
{
    TrendCurve curve;
    curve.servo = id.section(QLatin1Char('/'), 0, 0);
    curve.key = id.section(QLatin1Char('/'), 1);
    return curve;
}

QString registerOf(const catalog::Profile& profile, const QString& key)
{
    const BuiltInCurve* made = findBuiltIn(key);
    if (made == nullptr)
        return key;
    if (key == QLatin1String("@goal"))
        return session::goalKey(profile);
    if (key == QLatin1String("@error"))
        return session::errorKey;
    const catalog::Register* reg = profile.byRole(made->role);
    return reg != nullptr ? reg->key : QString();
}

QStringList builtInKeys()
{
    QStringList keys;
    for (const BuiltInCurve& one : builtInCurves)
        keys << QString::fromLatin1(one.key);
    return keys;
}

QString builtInName(const QString& key)
{
    const BuiltInCurve* made = findBuiltIn(key);
    return made != nullptr ? translate("Trend", made->name) : key;
}

std::vector<TrendCurve> defaultCurves()
{
    std::vector<TrendCurve> curves;
    for (const char* key : {"@goal", "@position", "@speed", "@current", "@load"}) {
        TrendCurve curve;
        curve.key = QString::fromLatin1(key);
        curve.visible = curve.key != QLatin1String("@load");
        curves.push_back(curve);
    }
    return curves;
}

namespace {
/// "temperature", or "temperature (derived)" where the servo reports no faults itself.
QString faultsText(const QString& text)
{
    const QString word = faultText(text.section(QLatin1Char(' '), 0, 0));
    return text.contains(QLatin1String("(derived)")) ? translate("Trend", "%1 (derived)").arg(word)
                                                     : word;
}

/// The register's key at the beginning becomes its name.
QString writtenName(const session::ServoRegistry& registry, const QString& text)
{
    const QString key = text.section(QLatin1Char(' '), 0, 0);
    for (const session::ServoRef ref : registry.order()) {
        const catalog::ProfilePtr& profile = registry.servo(ref)->servo.profile;
        if (profile && profile->find(key) != nullptr)
            return nameOf(*profile, key) + text.mid(key.size());
    }
    return text;
}
} // namespace

QString recordedChannelName(const session::ServoRegistry& registry,
                            const recording::RecordingChannel& column)
{
    QString name = column.key;
    if (column.key == session::errorKey)
        name = builtInName(QStringLiteral("@error"));
    for (const session::ServoRef ref : registry.order()) {
        const catalog::ProfilePtr& profile = registry.servo(ref)->servo.profile;
        if (profile && profile->find(column.key) != nullptr)
            name = nameOf(*profile, column.key);
    }
    return translate("Trend", "ID %1 · %2").arg(column.servoId).arg(name);
}

QString markText(const session::ServoRegistry& registry, const recording::Mark& mark)
{
    using recording::MarkKind;
    QString words = mark.text;
    if (mark.kind == MarkKind::Fault)
        words = faultsText(mark.text);
    else if (mark.kind == MarkKind::FaultCleared)
        words = translate("Trend", "cleared: %1").arg(faultsText(mark.text));
    else if (mark.kind == MarkKind::LinkError)
        words = translate("Trend", "no reply");
    else if (mark.kind == MarkKind::LinkRestored)
        words = translate("Trend", "replies again");
    else if (mark.kind == MarkKind::Stop)
        words = translate("Trend", "emergency stop");
    else if (mark.kind == MarkKind::Write) // "position_p 32 → 40"
        words = writtenName(registry, mark.text);
    const bool alone = registry.order().size() < 2;
    return mark.servoId >= 0 && !alone
               ? translate("Trend", "ID %1 · %2").arg(mark.servoId).arg(words)
               : words;
}

session::ServoRef TrendResolver::servoOf(const TrendCurve& curve) const
{
    if (curve.servo == QLatin1String("*"))
        return m_registry.servo(m_selected) != nullptr ? m_selected : 0;
    const int id = curve.servo.toInt();
    for (const session::ServoRef ref : m_registry.order()) {
        if (m_registry.servo(ref)->servo.id == id)
            return ref;
    }
    return 0;
}

std::optional<TrendChannel> TrendResolver::channel(const TrendCurve& curve,
                                                   const QColor& color) const
{
    const session::ServoRef ref = servoOf(curve);
    const session::ServoEntry* entry = m_registry.servo(ref);
    if (entry == nullptr || !entry->servo.profile)
        return std::nullopt;
    const catalog::Profile& profile = *entry->servo.profile;
    const QString key = registerOf(profile, curve.key);
    const catalog::Register* reg = profile.find(key);
    if (key.isEmpty() || (reg != nullptr && !entry->servo.measures(*reg)) ||
        (reg == nullptr && key != session::errorKey))
        return std::nullopt;
    TrendChannel channel;
    channel.key = curve.id();
    channel.name = nameOf(profile, curve.key);
    if (curve.servo != QLatin1String("*"))
        channel.name = translate("Trend", "ID %1 · %2").arg(entry->servo.id).arg(channel.name);
    channel.color = curve.color.isValid() ? curve.color : color;
    channel.visible = curve.visible;
    channel.steps = holdsItsValue(reg);
    channel.dashed = isGoalKey(curve.key);
    channel.scale = curve.scale;
    channel.offset = curve.offset;
    if (const session::LiveChannel* samples = m_liveData.find(ref, key)) {
        channel.id = samples->id;
        channel.unit = catalog::unitSuffix(samples->unit).trimmed();
    }
    return channel;
}

session::Subscription TrendResolver::subscription(const std::vector<TrendCurve>& curves) const
{
    session::Subscription subscription;
    for (const TrendCurve& curve : curves) {
        const session::ServoRef ref = servoOf(curve);
        const session::ServoEntry* entry = m_registry.servo(ref);
        if (entry == nullptr || !entry->servo.profile || !curve.visible)
            continue;
        const catalog::Profile& profile = *entry->servo.profile;
        const QString key = registerOf(profile, curve.key);
        QStringList keys{key};
        if (key == session::errorKey) {
            const catalog::Register* present = profile.byRole(Role::PresentPosition);
            keys = {session::goalKey(profile), present != nullptr ? present->key : QString()};
        }
        keys.removeAll(QString());
        if (!keys.isEmpty())
            subscription.parts.push_back({ref, keys, {}});
    }
    return subscription;
}
} // namespace ui
