// SPDX-License-Identifier: GPL-3.0-or-later
#include "record/journal_state.h"

#include "record/journal_line.h"

namespace record {
namespace {
QString keptKey(const base::ServoIdentity& servo, const QString& name)
{
    return QStringLiteral("%1/%2.%3/%4.%5/%6/%7")
        .arg(servo.map)
        .arg(servo.modelMajor)
        .arg(servo.modelMinor)
        .arg(servo.firmwareMajor)
        .arg(servo.firmwareMinor)
        .arg(servo.id)
        .arg(name);
}
} // namespace

void JournalState::clear()
{
    *this = JournalState();
}

void JournalState::feed(const QByteArray& bytes)
{
    m_bytesFed += bytes.size();
    m_unfinished += bytes;
    qsizetype start = 0;
    for (auto end = m_unfinished.indexOf('\n'); end >= 0; end = m_unfinished.indexOf('\n', start)) {
        takeLine(m_unfinished.mid(start, end - start));
        start = end + 1;
    }
    m_unfinished.remove(0, start);
}

void JournalState::takeLine(const QByteArray& text)
{
    ++m_lines;
    if (text.trimmed().isEmpty())
        return;
    const auto line = decodeJournalLine(text);
    if (!line) {
        warn(line.error().detail);
    } else if (const auto* begin = std::get_if<BeginLine>(&*line)) {
        m_entryByUuid.insert(begin->intent.uuid, m_entries.size());
        m_entries.push_back({begin->intent, std::nullopt});
    } else if (const auto* end = std::get_if<EndLine>(&*line)) {
        const auto entry = m_entryByUuid.constFind(end->uuid);
        if (entry != m_entryByUuid.cend())
            m_entries[*entry].end = end->end;
        else
            warn(QStringLiteral("uuid: ends an intent that is not there"));
    } else if (const auto* keep = std::get_if<KeepLine>(&*line)) {
        m_kept.insert(keptKey(keep->servo, keep->name), keep->values);
    }
}

std::optional<std::vector<std::int64_t>> JournalState::kept(const base::ServoIdentity& servo,
                                                            const QString& name) const
{
    const auto found = m_kept.constFind(keptKey(servo, name));
    if (found == m_kept.cend())
        return std::nullopt;
    return *found;
}

std::vector<JournalWarning> JournalState::warnings() const
{
    std::vector<JournalWarning> all = m_warnings;
    if (!m_unfinished.isEmpty())
        all.push_back({m_lines + 1, QStringLiteral("the last line is unfinished")});
    return all;
}

void JournalState::warn(const QString& detail)
{
    m_warnings.push_back({m_lines, detail});
}
} // namespace record
