// SPDX-License-Identifier: GPL-3.0-or-later
// The file journal as versions up to 0.6 wrote it: what they appended, byte for byte, and under the
// same lock. For tests that take it over. Any thread.
#pragma once

#include "base/journal.h"
#include "files/file_handle.h"
#include "history/journal_line.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QUuid>

namespace support {
class LegacyJournal {
public:
    explicit LegacyJournal(QString path)
        : m_path(std::move(path))
    {}

    QString begin(const base::Intent& intent);
    void end(const QString& uuid, const QString& outcome, const QString& detail = {});
    void keep(const base::ServoIdentity& servo, const QString& name,
              const std::vector<std::int64_t>& values);
    /// A line as it is, with its line feed.
    void append(const QByteArray& line);

private:
    QString m_path;
};

namespace legacy_journal_detail {
constexpr int formatVersion = 1;

inline QJsonObject toJson(const base::ServoIdentity& servo)
{
    return {
        {QStringLiteral("id"), servo.id},
        {QStringLiteral("model_major"), servo.modelMajor},
        {QStringLiteral("model_minor"), servo.modelMinor},
        {QStringLiteral("firmware_major"), servo.firmwareMajor},
        {QStringLiteral("firmware_minor"), servo.firmwareMinor},
        {QStringLiteral("map"), servo.map},
        {QStringLiteral("port"), servo.port},
        {QStringLiteral("baud"), servo.baud},
        {QStringLiteral("protocol"), base::protocolName(servo.protocol)},
    };
}

inline void write(const history::BeginLine& line, QJsonObject& object)
{
    const base::Intent& intent = line.intent;
    QJsonArray items;
    for (const base::JournalItem& item : intent.items) {
        items.append(QJsonObject{
            {QStringLiteral("key"), item.key},
            {QStringLiteral("address"), item.address},
            {QStringLiteral("old"), qint64(item.oldRaw)},
            {QStringLiteral("new"), qint64(item.newRaw)},
        });
    }
    object.insert(QStringLiteral("type"), QStringLiteral("begin"));
    object.insert(QStringLiteral("uuid"), intent.uuid);
    object.insert(QStringLiteral("kind"), base::intentKindName(intent.kind));
    object.insert(QStringLiteral("temporary"), intent.temporary);
    object.insert(QStringLiteral("lock_opened"), intent.lockOpened);
    object.insert(QStringLiteral("servo"), toJson(intent.servo));
    object.insert(QStringLiteral("items"), items);
}

inline void write(const history::EndLine& line, QJsonObject& object)
{
    object.insert(QStringLiteral("type"), QStringLiteral("end"));
    object.insert(QStringLiteral("uuid"), line.uuid);
    object.insert(QStringLiteral("outcome"), line.end.outcome);
    object.insert(QStringLiteral("detail"), line.end.detail);
}

inline void write(const history::FactLine& line, QJsonObject& object)
{
    QJsonArray values;
    for (const std::int64_t value : line.values)
        values.append(qint64(value));
    object.insert(QStringLiteral("type"), QStringLiteral("keep"));
    object.insert(QStringLiteral("servo"), toJson(line.servo));
    object.insert(QStringLiteral("name"), line.name);
    object.insert(QStringLiteral("values"), values);
}

template <typename Line>
QByteArray encoded(const Line& line)
{
    QJsonObject object{
        {QStringLiteral("v"), formatVersion},
        {QStringLiteral("at"), QDateTime::currentDateTimeUtc().toString(Qt::ISODateWithMs)},
    };
    write(line, object);
    return QJsonDocument(object).toJson(QJsonDocument::Compact);
}
} // namespace legacy_journal_detail

inline QString LegacyJournal::begin(const base::Intent& intent)
{
    history::BeginLine line{intent};
    line.intent.uuid = QUuid::createUuid().toString(QUuid::WithoutBraces);
    append(legacy_journal_detail::encoded(line));
    return line.intent.uuid;
}

inline void LegacyJournal::end(const QString& uuid, const QString& outcome, const QString& detail)
{
    append(legacy_journal_detail::encoded(history::EndLine{uuid, {outcome, detail}, {}}));
}

inline void LegacyJournal::keep(const base::ServoIdentity& servo, const QString& name,
                                const std::vector<std::int64_t>& values)
{
    append(legacy_journal_detail::encoded(history::FactLine{servo, name, values, {}}));
}

inline void LegacyJournal::append(const QByteArray& line)
{
    files::FileHandle file(m_path, files::FileHandle::Mode::Append);
    if (!file.isOpen() || !file.lock(files::FileHandle::Lock::Exclusive) ||
        !file.write(line + '\n'))
        qFatal("the old journal cannot be written");
}
} // namespace support
