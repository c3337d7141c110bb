// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/json_duplicates.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QSet>

#include <vector>

namespace files {
namespace {
/// The end of the string that begins at `begin`, behind its closing quote.
qsizetype stringEnd(const QByteArray& text, qsizetype begin)
{
    qsizetype at = begin + 1;
    while (at < text.size() && text[at] != '"')
        at += text[at] == '\\' ? 2 : 1;
    return std::min(at + 1, text.size());
}

/// The name without quotes; a name with escapes equals the same name without.
QString nameOf(const QByteArray& quoted)
{
    if (!quoted.contains('\\'))
        return QString::fromUtf8(quoted.sliced(1, std::max<qsizetype>(0, quoted.size() - 2)));
    return QJsonDocument::fromJson('[' + quoted + ']').array().at(0).toString();
}

bool isName(const QByteArray& text, qsizetype behind)
{
    while (behind < text.size() && (text[behind] == ' ' || text[behind] == '\n' ||
                                    text[behind] == '\r' || text[behind] == '\t'))
        ++behind;
    return behind < text.size() && text[behind] == ':';
}
} // namespace

QString findDuplicateKey(const QByteArray& text)
{
    std::vector<QSet<QString>> objects; ///< the names of each open object; lists have none
    for (qsizetype at = 0; at < text.size();) {
        const char sign = text[at];
        if (sign == '{' || sign == '[') {
            objects.emplace_back();
        } else if ((sign == '}' || sign == ']') && !objects.empty()) {
            objects.pop_back();
        } else if (sign == '"') {
            const qsizetype end = stringEnd(text, at);
            if (isName(text, end) && !objects.empty()) {
                const QString name = nameOf(text.sliced(at, end - at));
                if (objects.back().contains(name))
                    return QStringLiteral("line %1: \"%2\" is there twice")
                        .arg(text.left(at).count('\n') + 1)
                        .arg(name);
                objects.back().insert(name);
            }
            at = end;
            continue;
        }
        ++at;
    }
    return {};
}
} // namespace files
