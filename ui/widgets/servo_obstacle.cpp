// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/servo_obstacle.h"

#include "text/translate.h"
#include "ui/common/widget_style.h"

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace ui {
using text::translate;

ServoObstacle::ServoObstacle(Commands& commands, const QString& name, QWidget* parent)
    : QWidget(parent)
    , m_why(new QLabel(this))
    , m_setUp(new QPushButton(this))
    , m_page(commands.action(Command::PageCommission))
{
    m_why->setObjectName(name);
    makeEmptyState(m_why);
    m_setUp->setObjectName(name + QStringLiteral("SetUp"));
    makeMainAction(m_setUp);
    connect(m_setUp, &QPushButton::clicked, m_page, &QAction::trigger);
    auto* column = new QVBoxLayout(this);
    column->addStretch(1);
    column->addWidget(m_why);
    column->addWidget(m_setUp, 0, Qt::AlignHCenter);
    column->addStretch(1);
}

void ServoObstacle::showObstacle(const QString& why, const session::ServoEntry* entry)
{
    if (m_why->text() != why)
        m_why->setText(why);
    m_setUp->setText(translate("ServoObstacle", "Set up servos one at a time"));
    m_setUp->setAccessibleName(m_setUp->text());
    m_setUp->setToolTip(m_page->toolTip());
    m_setUp->setVisible(entry != nullptr && !entry->servo.profile && entry->duplicateSuspected);
}

QString unidentifiedText(const session::ServoEntry& entry)
{
    if (entry.duplicateSuspected)
        return translate(
                   "ServoObstacle",
                   "Several servos seem to reply with ID %1, so none of them can be read. New "
                   "servos all have the same ID: connect them one at a time and give each its "
                   "own.")
            .arg(entry.servo.id);
    return translate("ServoObstacle", "This servo replies but does not report its model, so it can "
                                      "be neither moved nor configured. Search again.");
}
} // namespace ui
