// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/common/theme.h"

#include "ui/common/system_theme.h"
#include "ui/common/widget_style.h"

#include <QApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QIcon>
#include <QListWidget>
#include <QPainter>
#include <QProxyStyle>
#include <QStyleOption>
#include <QTreeView>

#include <algorithm>

namespace ui {
namespace {
struct Colors {
    QRgb window;    ///< the ground the cards lie on
    QRgb base;      ///< cards, tables and fields
    QRgb alternate; ///< bars, and every second row
    QRgb text, quiet, button, line, accent, onAccent, tip;
};
constexpr Colors lightColors{0xffeef0f4, 0xffffffff, 0xfff7f8fb, 0xff1f2430, 0xff5d6675,
                             0xffffffff, 0xffc9ced6, 0xff1d6ee6, 0xffffffff, 0xffffffff};
constexpr Colors darkColors{0xff202329, 0xff2a2e35, 0xff2f333b, 0xffe6e8ec, 0xffa3abb8,
                            0xff353a43, 0xff4b515c, 0xff3d82ea, 0xffffffff, 0xff3a3f49};

/// Disabled: still readable, but visibly not usable.
QColor faintText(const Colors& c)
{
    QColor faint(c.text);
    faint.setAlphaF(0.5F);
    return faint;
}

QPalette paletteOf(const Colors& c)
{
    QPalette palette;
    const auto set = [&](QPalette::ColorRole role, QRgb rgb) {
        palette.setColor(role, QColor(rgb));
    };
    set(QPalette::Window, c.window);
    set(QPalette::WindowText, c.text);
    set(QPalette::Base, c.base);
    set(QPalette::AlternateBase, c.alternate);
    set(QPalette::Text, c.text);
    set(QPalette::PlaceholderText, c.quiet);
    set(QPalette::Button, c.button);
    set(QPalette::ButtonText, c.text);
    set(QPalette::BrightText, c.onAccent);
    set(QPalette::ToolTipBase, c.tip);
    set(QPalette::ToolTipText, c.text);
    set(QPalette::Highlight, c.accent);
    set(QPalette::HighlightedText, c.onAccent);
    set(QPalette::Link, c.accent);
    set(QPalette::LinkVisited, c.accent);
    set(QPalette::Light, c.base);
    set(QPalette::Midlight, c.alternate);
    set(QPalette::Mid, c.line);
    set(QPalette::Dark, c.line);
    palette.setColor(QPalette::Shadow, QColor(0, 0, 0));
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        palette.setColor(QPalette::Disabled, role, faintText(c));
    palette.setColor(QPalette::Disabled, QPalette::Highlight, QColor(c.line));
    return palette;
}

/// Of selected rows: pale, so that colors that mean something are told apart on it.
QColor selectionTint(const Colors& c)
{
    constexpr float share = 0.18F;
    const QColor base(c.base);
    const QColor accent(c.accent);
    const auto mix = [](float a, float b) { return a + (b - a) * share; };
    return QColor::fromRgbF(mix(base.redF(), accent.redF()), mix(base.greenF(), accent.greenF()),
                            mix(base.blueF(), accent.blueF()));
}

// What Fusion lacks: more spacing, cards, underlined tabs, and one clear main action.
const char* const styleRules = R"(
QToolTip { padding: 4px; }
QToolBar#topBar { background: palette(alternate-base); border: none; border-bottom: 1px solid palette(mid); }
QStatusBar { background: palette(alternate-base); border-top: 1px solid palette(mid); }
QStatusBar::item { border: none; }
QMenuBar { background: palette(alternate-base); }
QMenuBar::item { background: transparent; padding: 4px 8px; }
QMenuBar::item:selected { background: palette(highlight); color: palette(highlighted-text); }
QDockWidget { font-weight: 600; }
QDockWidget::title { background: palette(alternate-base); padding: 6px 8px 4px 8px; }
QWidget[panel="true"] { background: palette(alternate-base); }
QWidget[card="true"] {
    background: palette(base); border: 1px solid palette(mid); border-radius: 6px;
}
QLabel[heading="true"] { font-weight: 600; }
QTabBar::tab {
    background: transparent; border: none; border-bottom: 3px solid transparent;
    color: @quiet; padding: 7px 10px 5px 10px;
}
QTabBar::tab:hover { color: palette(window-text); }
QTabBar::tab:selected { color: palette(window-text); border-bottom-color: palette(highlight); }
QTabBar::tab:selected:focus { color: palette(link); }
QTableView, QTreeView { selection-background-color: @tint; selection-color: palette(text); }
QPushButton, QToolButton { padding: 4px 10px; }
QToolButton[disclosure="true"] { padding: 0; border: 1px solid transparent; border-radius: 3px; }
QToolButton[disclosure="true"]:focus { border-color: palette(highlight); }
QTabBar QToolButton { padding: 0; }
QToolButton[menuOnly="true"]::menu-indicator { image: none; }
QPushButton[link="true"] { color: palette(link); padding: 4px 0; text-align: left; }
QTabWidget > QToolButton { padding: 0 6px; }
QPushButton[mainAction="true"] {
    background: palette(highlight); color: palette(highlighted-text);
    border: 1px solid palette(highlight); border-radius: 4px; padding: 5px 12px;
}
QPushButton[mainAction="true"]:disabled {
    background: palette(button); color: @faint; border-color: palette(mid);
}
QPushButton[mainAction="true"]:focus { border: 2px solid palette(window-text); }
QPushButton[stopAction="true"] {
    background: #c62f2f; color: white; font-weight: 600;
    border: 1px solid #a32222; border-radius: 4px; padding: 5px 14px;
}
QPushButton[stopAction="true"]:hover { background: #d63c3c; }
QPushButton[stopAction="true"]:pressed { background: #a32222; }
QPushButton[stopAction="true"]:disabled { background: palette(button); color: @faint; }
QHeaderView::section {
    padding: 4px 5px; border: none; border-bottom: 1px solid palette(mid);
    background: palette(base); font-weight: 600;
}
QLineEdit, QSpinBox, QDoubleSpinBox, QComboBox { padding: 2px 4px; min-height: 20px; }
)";
bool hasTableRows(const QWidget* widget)
{
    return qobject_cast<const QTreeView*>(widget) != nullptr ||
           qobject_cast<const QListWidget*>(widget) != nullptr;
}

/// Fusion outlines a checkbox a little darker than the window, which is invisible on a dark one.
class ProgramStyle final : public QProxyStyle {
public:
    ProgramStyle()
        : QProxyStyle(QStringLiteral("Fusion"))
    {}

    /// The buttons of every dialog end with the one that does it, whatever the desktop.
    int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                  QStyleHintReturn* result) const override
    {
        return hint == SH_DialogButtonLayout ? int(QDialogButtonBox::GnomeLayout)
                                             : QProxyStyle::styleHint(hint, option, widget, result);
    }

    int pixelMetric(PixelMetric metric, const QStyleOption* option,
                    const QWidget* widget) const override
    {
        switch (metric) {
        case PM_LayoutLeftMargin:
        case PM_LayoutTopMargin:
        case PM_LayoutRightMargin:
        case PM_LayoutBottomMargin:
            if (qobject_cast<const QDialog*>(widget) != nullptr)
                return dialogMargin;
            break;
        case PM_FocusFrameHMargin: // beside the text of a cell, which adds a pixel
            return cellMargin - 1;
        default:
            break;
        }
        return QProxyStyle::pixelMetric(metric, option, widget);
    }

    /// Rows of lists and trees are as high as those of tables.
    QSize sizeFromContents(ContentsType type, const QStyleOption* option, const QSize& contents,
                           const QWidget* widget) const override
    {
        QSize size = QProxyStyle::sizeFromContents(type, option, contents, widget);
        if (type == CT_ItemViewItem && hasTableRows(widget))
            size.setHeight(std::max(size.height(), option->fontMetrics.height() + rowPadding));
        return size;
    }

    void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                       const QWidget* widget) const override
    {
        QProxyStyle::drawPrimitive(element, option, painter, widget);
        const bool box =
            element == PE_IndicatorCheckBox || element == PE_IndicatorItemViewItemCheck;
        if (!box || !isDark(option->palette))
            return;
        painter->save();
        painter->setPen(option->palette.color(QPalette::PlaceholderText));
        painter->setBrush(Qt::NoBrush);
        painter->drawRect(option->rect.adjusted(0, 0, -1, -1));
        painter->restore();
    }
};
} // namespace

bool isDark(const QPalette& palette)
{
    return palette.color(QPalette::Window).lightness() < 128;
}

QColor tone(Tone tone, const QPalette& palette)
{
    const bool dark = isDark(palette);
    switch (tone) {
    case Tone::Good:
        return dark ? QColor(0x5f, 0xc9, 0x8b) : QColor(0x12, 0x78, 0x45);
    case Tone::Warn:
        return dark ? QColor(0xf0, 0xb2, 0x4a) : QColor(0x93, 0x5a, 0x06);
    case Tone::Bad:
        return dark ? QColor(0xff, 0x83, 0x7a) : QColor(0xb8, 0x25, 0x25);
    case Tone::Quiet:
        return palette.color(QPalette::PlaceholderText);
    case Tone::Accent:
        return dark ? QColor(0x7f, 0xb2, 0xff) : QColor(0x17, 0x5f, 0xce);
    }
    return palette.color(QPalette::Text);
}

ThemeSwitch::ThemeSwitch(QObject* parent)
    : QObject(parent)
    , m_desktop(new SystemTheme(this))
{
    connect(m_desktop, &SystemTheme::changed, this, [this] {
        if (m_theme == session::Theme::System)
            show();
    });
}

void ThemeSwitch::apply(session::Theme theme)
{
    m_theme = theme;
    show();
}

bool ThemeSwitch::usesDarkTheme() const
{
    return m_theme == session::Theme::Dark ||
           (m_theme == session::Theme::System && m_desktop->usesDarkTheme());
}

void ThemeSwitch::show()
{
    // Every widget of every page is polished again, which takes a third of a second. It is skipped
    // when "system" and the present theme look the same.
    if (m_shownDark != usesDarkTheme())
        paint();
    Q_EMIT changed();
}

void ThemeSwitch::paint()
{
    if (!m_shownDark)
        QApplication::setStyle(new ProgramStyle);
    m_shownDark = usesDarkTheme();
    QIcon::setThemeName(usesDarkTheme() ? QStringLiteral("breeze-dark") : QStringLiteral("breeze"));
    const Colors& colors = usesDarkTheme() ? darkColors : lightColors;
    QApplication::setPalette(paletteOf(colors));
    // Set again each time: rules with palette(...) are resolved when they are set.
    const QColor faint = faintText(colors);
    qApp->setStyleSheet(QString::fromLatin1(styleRules)
                            .replace(QLatin1String("@tint"), selectionTint(colors).name())
                            .replace(QLatin1String("@quiet"), QColor(colors.quiet).name())
                            .replace(QLatin1String("@faint"), QStringLiteral("rgba(%1,%2,%3,%4)")
                                                                  .arg(faint.red())
                                                                  .arg(faint.green())
                                                                  .arg(faint.blue())
                                                                  .arg(faint.alpha())));
}
} // namespace ui
