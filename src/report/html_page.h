// SPDX-License-Identifier: GPL-3.0-or-later
// The elements of a self-contained HTML page: no script, no other file, no network; well-formed XML
// as well. With ReportLanguage::Both the page contains every text in both languages, and two radio
// buttons switch by CSS; with one language, for paper, it has no buttons. Markup is QString; every
// text from a user goes through escaped(). Pure; any thread.
#pragma once

#include "catalog/register.h"

#include <QDateTime>
#include <QStringList>

#include <optional>
#include <vector>

namespace report {
/// Safe as text and in attributes; characters that XML does not allow are left out.
QString escaped(const QString& text);
/// Text that a person entered, escaped and marked.
QString userText(const QString& text);

/// A measured value with the digits that mean something: "4193", "158.6", "54.6", "0.98".
QString figure(double value);
/// As exactly as it takes to see on which side of its limits it is.
QString figure(double value, std::initializer_list<std::optional<double>> limits);
/// A setting, as exactly as it was entered: "8", "12.5", "0.125".
QString exactNumber(double value);
/// Of this computer, with its zone: "2026-11-27 12:35:06 UTC+08:00".
QString localTime(const QDateTime& at);

enum class ReportLanguage : std::uint8_t { Both, English, Chinese };

class HtmlWriter {
public:
    explicit HtmlWriter(ReportLanguage language)
        : m_language(language)
    {}
    ReportLanguage language() const { return m_language; }

    QString htmlText(const catalog::Text& text) const;      ///< escaped
    QString htmlInSvg(const catalog::Text& text) const;     ///< for a <text> of SVG
    QString attributeText(const catalog::Text& text) const; ///< both, one after the other
    QString heading(int level, const catalog::Text& text) const;
    QString paragraph(const catalog::Text& text) const;
    QString optional(std::optional<double> value, const catalog::Text& otherwise) const;

private:
    QString span(const char* element, const catalog::Text& text) const;

    ReportLanguage m_language;
};

/// Rows of cells of markup. Cells that begin with a number are aligned right. `isWide`: many
/// columns, so paper uses smaller letters.
QString table(const QStringList& headings, const std::vector<QStringList>& rows,
              bool isWide = false);
/// Two parts beside each other, on a page where it is wide enough.
QString sideBySide(const HtmlWriter& htmlWriter, const QString& left, const QString& right);
/// Two columns, names and values.
QString keyValueTable(const std::vector<QStringList>& rows);

/// The whole page; `chinese` is the language it opens in. One language: for a QTextDocument.
QString page(const HtmlWriter& htmlWriter, const catalog::Text& title, const QString& body,
             bool chinese);
} // namespace report
