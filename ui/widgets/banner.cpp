// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/banner.h"

#include "text/error_text.h"
#include "ui/common/follow_language.h"

#include <QAction>
#include <QHBoxLayout>
#include <QIcon>
#include <QLabel>
#include <QPainter>
#include <QToolButton>

namespace ui {
namespace {
constexpr int edge = 4;

QString symbolFor(Tone tone)
{
    switch (tone) {
    case Tone::Good:
        return QStringLiteral("✓");
    case Tone::Quiet:
    case Tone::Accent:
        return QStringLiteral("i");
    case Tone::Warn:
        return QStringLiteral("!");
    case Tone::Bad:
        break;
    }
    return QStringLiteral("✗");
}

QLabel* copyableLabel(QWidget* parent, const char* name)
{
    auto* label = new QLabel(parent);
    label->setObjectName(QLatin1String(name));
    label->setTextFormat(Qt::PlainText);
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    return label;
}
} // namespace

Banner::Banner(QWidget* parent)
    : QFrame(parent)
    , m_symbol(new QLabel(this))
    , m_what(copyableLabel(this, "bannerWhat"))
    , m_more(copyableLabel(this, "bannerMore"))
    , m_buttons(new QHBoxLayout)
    , m_close(new QToolButton(this))
{
    setObjectName(QStringLiteral("banner"));
    QFont bold = font();
    bold.setBold(true);
    m_what->setFont(bold);
    m_symbol->setFont(bold);
    m_close->setObjectName(QStringLiteral("bannerClose"));
    m_close->setIcon(QIcon::fromTheme(QStringLiteral("window-close")));
    m_close->setText(QStringLiteral("×"));
    m_close->setAutoRaise(true);
    auto* bannerText = new QVBoxLayout;
    bannerText->setSpacing(2);
    bannerText->addWidget(m_what);
    bannerText->addWidget(m_more);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(12 + edge, 8, 8, 8);
    row->addWidget(m_symbol, 0, Qt::AlignTop);
    row->addLayout(bannerText, 1);
    row->addLayout(m_buttons);
    row->addWidget(m_close, 0, Qt::AlignTop);
    connect(m_close, &QToolButton::clicked, this, [this] {
        hideMessage();
        Q_EMIT dismissed();
    });
    followLanguage(this, [this] { fill(); });
    hide();
}

void Banner::showMessage(TextProvider textProvider, const QList<QAction*>& actions)
{
    Q_EMIT messageReplaced();
    m_textProvider = std::move(textProvider);
    while (QLayoutItem* item = m_buttons->takeAt(0)) {
        item->widget()->hide();
        item->widget()->deleteLater(); // it may be the one that was pressed
        delete item;
    }
    for (QAction* action : actions) {
        auto* button = new QToolButton(this);
        button->setObjectName(QStringLiteral("bannerAction"));
        button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
        button->setDefaultAction(action);
        m_buttons->addWidget(button);
    }
    fill();
    show();
}

void Banner::showMessage(const base::Error& error, const QList<QAction*>& actions)
{
    showMessage(
        [error] {
            const text::Description bannerText = text::describe(error);
            return BannerText{Tone::Bad, bannerText.message, bannerText.cause, bannerText.remedy};
        },
        actions);
}

void Banner::hideMessage()
{
    m_textProvider = {};
    hide();
}

void Banner::fill()
{
    m_close->setToolTip(tr("Close this message"));
    m_close->setAccessibleName(tr("Close this message"));
    if (!m_textProvider)
        return;
    for (int i = 0; i < m_buttons->count(); ++i) {
        auto* button = qobject_cast<QToolButton*>(m_buttons->itemAt(i)->widget());
        button->setAccessibleName(button->defaultAction()->text());
    }
    const BannerText bannerText = m_textProvider();
    m_tone = bannerText.tone;
    m_symbol->setText(symbolFor(bannerText.tone));
    m_what->setText(bannerText.message);
    QStringList more;
    for (const QString& sentence : {bannerText.cause, bannerText.remedy}) {
        if (!sentence.isEmpty())
            more << sentence;
    }
    m_more->setText(more.join(QLatin1Char('\n')));
    m_more->setVisible(!more.isEmpty());
    const QString all = (QStringList(bannerText.message) + more).join(QLatin1Char('\n'));
    m_what->setToolTip(all);
    m_more->setToolTip(all);
    setAccessibleName(bannerText.message);
    setAccessibleDescription(more.join(QLatin1Char(' ')));
    update();
}

void Banner::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF frame = QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5);
    painter.setPen(palette().color(QPalette::Mid));
    painter.setBrush(palette().color(QPalette::Base));
    painter.drawRoundedRect(frame, 4, 4);
    painter.setPen(Qt::NoPen);
    painter.setBrush(tone(m_tone, palette()));
    painter.drawRoundedRect(QRectF(frame.left(), frame.top(), edge, frame.height()), 2, 2);
}
} // namespace ui
