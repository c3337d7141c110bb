// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/trend_colours.h"

#include "ui/app/theme.h"

namespace ui {
namespace {
QColor between(const QColor& one, const QColor& other, double share)
{
    const auto mix = [&](int a, int b) { return int(a + (b - a) * share); };
    return {mix(one.red(), other.red()), mix(one.green(), other.green()),
            mix(one.blue(), other.blue())};
}
} // namespace

TrendColours TrendColours::of(const QPalette& palette)
{
    const QColor ground = palette.color(QPalette::Base);
    const QColor text = palette.color(QPalette::Text);
    return {.ground = ground,
            .grid = between(ground, text, isDark(palette) ? 0.13 : 0.11),
            .text = text,
            .quiet = between(text, ground, 0.30),
            .accent = tone(Tone::Accent, palette),
            .onAccent = ground,
            .good = tone(Tone::Good, palette),
            .warn = tone(Tone::Warn, palette),
            .bad = tone(Tone::Bad, palette)};
}

TrendColours TrendColours::ofPaper()
{
    QPalette paper;
    paper.setColor(QPalette::Window, Qt::white);
    paper.setColor(QPalette::Base, Qt::white);
    paper.setColor(QPalette::Text, QColor(0x1f, 0x24, 0x30));
    return of(paper);
}
} // namespace ui
