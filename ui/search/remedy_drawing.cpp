// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/search/remedy_drawing.h"

#include "ui/common/theme.h"

#include <QEvent>
#include <QFile>
#include <QPainter>
#include <QSvgRenderer>

#include <algorithm>

namespace ui {
namespace {
constexpr QSize drawingSize(340, 150); ///< of every file

QString drawingOf(base::Cause cause)
{
    switch (cause) {
    case base::Cause::NoServoOrNoPower:
        return QStringLiteral("measure-supply");
    case base::Cause::EchoOnly:
    case base::Cause::Noise:
        return QStringLiteral("data-and-ground");
    case base::Cause::TwoServosOneId:
    case base::Cause::Bootloader:
        return QStringLiteral("one-servo");
    default:
        return {};
    }
}
} // namespace

RemedyDrawing::RemedyDrawing(QWidget* parent)
    : QWidget(parent)
    , m_renderer(new QSvgRenderer(this))
{
    setObjectName(QStringLiteral("remedyDrawing"));
    QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Preferred);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
    hide();
}

void RemedyDrawing::setCause(base::Cause cause)
{
    setDrawing(drawingOf(cause));
}

void RemedyDrawing::clear()
{
    setDrawing({});
}

void RemedyDrawing::setDrawing(const QString& name)
{
    setVisible(!name.isEmpty());
    if (name == m_name)
        return;
    m_name = name;
    load();
}

/// The files are drawn in four colors that stand for those of the theme.
void RemedyDrawing::load()
{
    QFile file(QStringLiteral(":/drawings/%1.svg").arg(m_name));
    if (m_name.isEmpty() || !file.open(QIODevice::ReadOnly))
        return;
    QByteArray svg = file.readAll();
    for (const auto& [inFile, color] : {std::pair{"#101010", palette().color(QPalette::Text)},
                                        std::pair{"#808080", tone(Tone::Quiet, palette())},
                                        std::pair{"#1f6feb", palette().color(QPalette::Link)},
                                        std::pair{"#c62828", tone(Tone::Bad, palette())}})
        svg.replace(inFile, color.name().toLatin1());
    m_renderer->load(svg);
    update();
}

QSize RemedyDrawing::sizeHint() const
{
    return drawingSize;
}

int RemedyDrawing::heightForWidth(int width) const
{
    return std::min(width, drawingSize.width()) * drawingSize.height() / drawingSize.width();
}

void RemedyDrawing::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    const int width = std::min(this->width(), drawingSize.width());
    m_renderer->render(&painter, QRectF(0, 0, width, heightForWidth(width)));
}

void RemedyDrawing::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange)
        load();
}
} // namespace ui
