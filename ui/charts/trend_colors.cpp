// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/trend_colors.h"

#include "ui/common/theme.h"

namespace ui {
namespace {
QColor between(const QColor& one, const QColor& other, double share)
{
    const auto mix = [&](int a, int b) { return int(a + (b - a) * share); };
    return {mix(one.red(), other.red()), mix(one.green(), other.green()),
            mix(one.blue(), other.blue())};
}
} // namespace

TrendColors TrendColors::of(const QPalette& palette)
{
    const QColor background = palette.color(QPalette::Base);
    const QColor text = palette.color(QPalette::Text);
    return {.background = background,
            .grid = between(background, text, isDark(palette) ? 0.13 : 0.11),
            .text = text,
            .muted = between(text, background, 0.30),
            .accent = tone(Tone::Accent, palette),
            .onAccent = background,
            .good = tone(Tone::Good, palette),
            .warn = tone(Tone::Warn, palette),
            .bad = tone(Tone::Bad, palette)};
}

TrendColors TrendColors::ofPaper()
{
    QPalette paper;
    paper.setColor(QPalette::Window, Qt::white);
    paper.setColor(QPalette::Base, Qt::white);
    paper.setColor(QPalette::Text, QColor(0x1f, 0x24, 0x30));
    return of(paper);
}
} // namespace ui
