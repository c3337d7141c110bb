// SPDX-License-Identifier: GPL-3.0-or-later
// Pieces of a page that needs nothing but itself: no script, no other file, no network. Written so
// that it is XML as well. With Tongue::Both every text is there in both languages and two radio
// buttons choose by CSS; with one language there are no buttons, for paper. Markup is QString;
// whatever comes from a user goes through escaped(). Values; one thread.
#pragma once

#include "catalog/register.h"

#include <QStringList>

#include <optional>
#include <vector>

namespace report {
/// Safe as text and in attributes; characters that no XML may contain are left out.
QString escaped(const QString& text);

/// Two decimals at most, with a point: "3047.75", "8.1", "12".
QString figure(double value);

enum class Tongue : std::uint8_t { Both, English, Chinese };

class Scribe {
public:
    explicit Scribe(Tongue tongue)
        : m_tongue(tongue)
    {}
    Tongue tongue() const { return m_tongue; }

    QString say(const catalog::Text& text) const;         ///< escaped
    QString sayInSvg(const catalog::Text& text) const;    ///< for a <text> of SVG
    QString inAttribute(const catalog::Text& text) const; ///< both, one after the other
    QString heading(int level, const catalog::Text& text) const;
    QString paragraph(const catalog::Text& text) const;
    QString optional(std::optional<double> value, const catalog::Text& otherwise) const;

private:
    QString span(const char* element, const catalog::Text& text) const;

    Tongue m_tongue;
};

/// Rows of cells of markup. A cell that begins with a digit or a sign before one stands right.
/// `many`: columns, so that paper takes smaller letters.
QString table(const QStringList& headings, const std::vector<QStringList>& rows, bool many = false);
/// Two columns, names and values.
QString pairs(const std::vector<QStringList>& rows);

/// The whole page; `chinese` is the language it opens in. One language: for a QTextDocument.
QString page(const Scribe& scribe, const catalog::Text& title, const QString& body, bool chinese);
} // namespace report
