// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/trend_choice.h"

#include "catalog/units.h"
#include "text/language.h"
#include "text/translate.h"
#include "ui/charts/palette.h"
#include "ui/models/feedback.h"

#include <algorithm>
#include <array>

namespace ui {
using catalog::Role;
using text::translate;

namespace {
struct ReadyMade {
    const char* key;
    Role role; ///< None: goal and error, which are asked for otherwise
    const char* name;
};
constexpr std::array readyMade{
    ReadyMade{"@goal", Role::None, QT_TRANSLATE_NOOP("Trend", "Goal")},
    ReadyMade{"@position", Role::PresentPosition, QT_TRANSLATE_NOOP("Trend", "Position")},
    ReadyMade{"@error", Role::None, QT_TRANSLATE_NOOP("Trend", "Error (goal − position)")},
    ReadyMade{"@speed", Role::PresentSpeed, QT_TRANSLATE_NOOP("Trend", "Speed")},
    ReadyMade{"@load", Role::PresentLoad, QT_TRANSLATE_NOOP("Trend", "Load")},
    ReadyMade{"@current", Role::PresentCurrent, QT_TRANSLATE_NOOP("Trend", "Current")},
    ReadyMade{"@voltage", Role::PresentVoltage, QT_TRANSLATE_NOOP("Trend", "Voltage")},
    ReadyMade{"@temperature", Role::PresentTemperature, QT_TRANSLATE_NOOP("Trend", "Temperature")},
    ReadyMade{"@moving", Role::Moving, QT_TRANSLATE_NOOP("Trend", "Moving")},
};

const ReadyMade* readyMadeOf(const QString& key)
{
    const auto found = std::find_if(readyMade.begin(), readyMade.end(), [&](const ReadyMade& one) {
        return key == QLatin1StringView(one.key);
    });
    return found != readyMade.end() ? &*found : nullptr;
}

QString nameOf(const catalog::Profile& profile, const QString& key)
{
    if (const ReadyMade* made = readyMadeOf(key))
        return translate("Trend", made->name);
    if (key == session::errorKey)
        return translate("Trend", "Error (goal − position)");
    const catalog::Register* reg = profile.find(key);
    return reg != nullptr ? reg->name.in(text::inChinese()) : key;
}

/// The goal is company for the position: grey.
QColor colourOf(const TrendChoice& choice, std::size_t place, const QColor& ground)
{
    if (choice.key == QLatin1String("@goal"))
        return trendColour(trendColourCount - 1, ground);
    return trendColour(int(place % (trendColourCount - 1)), ground);
}

bool holdsItsValue(const catalog::Register* reg)
{
    return reg != nullptr &&
           (reg->area != catalog::Area::Feedback || reg->encoding == catalog::Encoding::Enum ||
            reg->encoding == catalog::Encoding::Bits || reg->role == Role::ActiveGoal);
}
} // namespace

TrendChoice TrendChoice::fromId(const QString& id)
{
    TrendChoice choice;
    choice.servo = id.section(QLatin1Char('/'), 0, 0);
    choice.key = id.section(QLatin1Char('/'), 1);
    return choice;
}

QString registerOf(const catalog::Profile& profile, const QString& key)
{
    const ReadyMade* made = readyMadeOf(key);
    if (made == nullptr)
        return key;
    if (key == QLatin1String("@goal"))
        return session::goalKey(profile);
    if (key == QLatin1String("@error"))
        return session::errorKey;
    const catalog::Register* reg = profile.byRole(made->role);
    return reg != nullptr ? reg->key : QString();
}

QStringList readyMadeKeys()
{
    QStringList keys;
    for (const ReadyMade& one : readyMade)
        keys << QString::fromLatin1(one.key);
    return keys;
}

QString readyMadeName(const QString& key)
{
    const ReadyMade* made = readyMadeOf(key);
    return made != nullptr ? translate("Trend", made->name) : key;
}

std::vector<TrendChoice> defaultChoices()
{
    std::vector<TrendChoice> choices;
    for (const char* key : {"@goal", "@position", "@speed", "@current", "@load"}) {
        TrendChoice choice;
        choice.key = QString::fromLatin1(key);
        choice.visible = choice.key != QLatin1String("@load");
        choices.push_back(choice);
    }
    return choices;
}

namespace {
/// "temperature", or "temperature (derived)" where the servo reports no faults itself.
QString faultWords(const QString& text)
{
    const QString word = faultWord(text.section(QLatin1Char(' '), 0, 0));
    return text.contains(QLatin1String("(derived)"))
               ? translate("Trend", "%1 (worked out)").arg(word)
               : word;
}

/// The register's key at the beginning becomes its name.
QString writtenName(const session::Desk& desk, const QString& text)
{
    const QString key = text.section(QLatin1Char(' '), 0, 0);
    for (const session::ServoRef ref : desk.servos()) {
        const catalog::ProfilePtr& profile = desk.servo(ref)->servo.profile;
        if (profile && profile->find(key) != nullptr)
            return nameOf(*profile, key) + text.mid(key.size());
    }
    return text;
}
} // namespace

QString recordedName(const session::Desk& desk, const record::RecordingChannel& column)
{
    QString name = column.key;
    if (column.key == session::errorKey)
        name = readyMadeName(QStringLiteral("@error"));
    for (const session::ServoRef ref : desk.servos()) {
        const catalog::ProfilePtr& profile = desk.servo(ref)->servo.profile;
        if (profile && profile->find(column.key) != nullptr)
            name = nameOf(*profile, column.key);
    }
    return translate("Trend", "ID %1 · %2").arg(column.servoId).arg(name);
}

QString markWords(const session::Desk& desk, const record::Mark& mark)
{
    using record::MarkKind;
    QString words = mark.text;
    if (mark.kind == MarkKind::Fault)
        words = faultWords(mark.text);
    else if (mark.kind == MarkKind::FaultOver)
        words = translate("Trend", "over: %1").arg(faultWords(mark.text));
    else if (mark.kind == MarkKind::LinkError)
        words = translate("Trend", "no answer");
    else if (mark.kind == MarkKind::LinkBack)
        words = translate("Trend", "answers again");
    else if (mark.kind == MarkKind::Stop)
        words = translate("Trend", "emergency stop");
    else if (mark.kind == MarkKind::Write) // "position_p 32 → 40"
        words = writtenName(desk, mark.text);
    const bool alone = desk.servos().size() < 2;
    return mark.servoId >= 0 && !alone
               ? translate("Trend", "ID %1 · %2").arg(mark.servoId).arg(words)
               : words;
}

session::ServoRef TrendResolver::servoOf(const TrendChoice& choice) const
{
    if (choice.servo == QLatin1String("*"))
        return m_desk.servo(m_selected) != nullptr ? m_selected : 0;
    const int id = choice.servo.toInt();
    for (const session::ServoRef ref : m_desk.servos()) {
        if (m_desk.servo(ref)->servo.id == id)
            return ref;
    }
    return 0;
}

std::optional<TrendChannel> TrendResolver::channel(const TrendChoice& choice, std::size_t place,
                                                   const QColor& ground) const
{
    const session::ServoRef ref = servoOf(choice);
    const session::ServoEntry* entry = m_desk.servo(ref);
    if (entry == nullptr || !entry->servo.profile)
        return std::nullopt;
    const catalog::Profile& profile = *entry->servo.profile;
    const QString key = registerOf(profile, choice.key);
    const catalog::Register* reg = profile.find(key);
    if (key.isEmpty() || (reg != nullptr && !entry->servo.measures(*reg)) ||
        (reg == nullptr && key != session::errorKey))
        return std::nullopt;
    TrendChannel channel;
    channel.key = choice.id();
    channel.name = nameOf(profile, choice.key);
    if (choice.servo != QLatin1String("*"))
        channel.name = translate("Trend", "ID %1 · %2").arg(entry->servo.id).arg(channel.name);
    channel.colour = choice.colour.isValid() ? choice.colour : colourOf(choice, place, ground);
    channel.visible = choice.visible;
    channel.steps = holdsItsValue(reg);
    channel.scale = choice.scale;
    channel.offset = choice.offset;
    if (const session::ScopeChannel* samples = m_scope.find(ref, key)) {
        channel.id = samples->id;
        channel.unit = catalog::unitSuffix(samples->unit).trimmed();
    }
    return channel;
}

session::FeedWish TrendResolver::wish(const std::vector<TrendChoice>& choices) const
{
    session::FeedWish wish;
    for (const TrendChoice& choice : choices) {
        const session::ServoRef ref = servoOf(choice);
        const session::ServoEntry* entry = m_desk.servo(ref);
        if (entry == nullptr || !entry->servo.profile || !choice.visible)
            continue;
        const catalog::Profile& profile = *entry->servo.profile;
        const QString key = registerOf(profile, choice.key);
        QStringList keys{key};
        if (key == session::errorKey) {
            const catalog::Register* present = profile.byRole(Role::PresentPosition);
            keys = {session::goalKey(profile), present != nullptr ? present->key : QString()};
        }
        keys.removeAll(QString());
        if (!keys.isEmpty())
            wish.parts.push_back({ref, keys, {}});
    }
    return wish;
}
} // namespace ui
