// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/family_text.h"

#include "catalog/family_facts.h"
#include "text/translate.h"

#include <QStringList>

namespace text {
using base::ErrorCode;
using catalog::FamilyFacts;

namespace {
QString withNote(const QString& value, const QString& note)
{
    return note.isEmpty()
               ? value
               : translate("text", "%1 (%2)", "sentence, technical detail").arg(value, note);
}

QString firmwareFact(const FamilyFacts& facts)
{
    return withNote(facts.firmware, facts.firmwareSeries);
}

QString modelFact(const FamilyFacts& facts)
{
    if (facts.modelName.isEmpty())
        return withNote(facts.modelId, translate("text", "not in the model list"));
    return withNote(
        facts.modelId,
        translate("text", "%1, byte order flag %2").arg(facts.modelName).arg(facts.modelFlag));
}

QString unclearFamily(const FamilyFacts& facts)
{
    if (facts.lockAddress < 0) {
        return translate("text", "the servo family is unclear: firmware %1, byte order flag %2 and "
                                 "model number %3 contradict each other")
            .arg(firmwareFact(facts))
            .arg(facts.byteOrderFlag)
            .arg(modelFact(facts));
    }
    return translate("text", "the servo family is unclear: according to firmware %1, byte order "
                             "flag %2 and model number %3, the EPROM lock is at address %4, but "
                             "the byte at that address is %5")
        .arg(firmwareFact(facts))
        .arg(facts.byteOrderFlag)
        .arg(modelFact(facts))
        .arg(facts.lockAddress)
        .arg(facts.lock);
}

/// "broken 6/8": 6 of 8 replies could not be decoded.
QString severalServos(const QString& detail)
{
    if (detail == QLatin1String("two-replies"))
        return translate("text", "two servos reply with this ID: one request got two replies");
    if (detail == QLatin1String("different-values"))
        return translate("text", "two servos reply with this ID: the replies to one request cannot "
                                 "come from a single servo");
    const QStringList counts = detail.section(QLatin1Char(' '), 1).split(QLatin1Char('/'));
    return translate("text",
                     "two servos seem to reply with this ID: %1 of %2 replies could not be decoded")
        .arg(counts.value(0), counts.value(1));
}
} // namespace

QString writeRefusedMessage(const base::Error& error)
{
    if (error.code == ErrorCode::DuplicateId)
        return severalServos(error.detail);
    const auto facts = error.code == ErrorCode::FamilyConflict
                           ? FamilyFacts::fromDetail(error.detail)
                           : std::nullopt;
    return facts ? unclearFamily(*facts) : QString();
}

QString writeRefusedCause(const base::Error& error)
{
    const bool broken = error.detail.startsWith(QLatin1String("broken"));
    if (error.code != ErrorCode::DuplicateId || !broken)
        return {};
    return translate(
        "text", "The replies of two servos collide; noise on the line can look the same. A write "
                "would change both servos, but only one of the old values would be recorded.");
}

QString writeRefusedRemedy(const base::Error& error)
{
    const auto facts = error.code == ErrorCode::FamilyConflict
                           ? FamilyFacts::fromDetail(error.detail)
                           : std::nullopt;
    if (!facts || facts->lockAddress < 0)
        return {};
    return translate("text", "Turn the servo off and on, and read it again. If the byte is "
                             "still neither 0 nor 1, do not write to this servo: ask the vendor "
                             "for its memory table.");
}
} // namespace text
