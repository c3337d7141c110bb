// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sweep/sweep_end_conditions.h"

#include "ui/widgets/flow_layout.h"

#include <QCheckBox>
#include <QLabel>
#include <QVBoxLayout>

namespace ui {
SweepEndConditions::SweepEndConditions(QWidget* parent)
    : QWidget(parent)
    , m_title(new QLabel(this))
{
    auto* boxes = new QWidget(this);
    QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Minimum);
    policy.setHeightForWidth(true);
    boxes->setSizePolicy(policy);
    auto* flow = new FlowLayout(boxes, 10);
    const auto add = [&](const char* name, bool on) {
        auto* box = new QCheckBox(boxes);
        box->setObjectName(QString::fromLatin1(name));
        box->setChecked(on);
        flow->addWidget(box);
        connect(box, &QCheckBox::toggled, this, &SweepEndConditions::changed);
        return box;
    };
    m_onAlarm = add("sweepOnAlarm", true);
    m_onStall = add("sweepOnStall", true);
    m_onFailure = add("sweepOnFailure", false);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins({});
    column->setSpacing(6);
    column->addWidget(m_title);
    column->addWidget(boxes);
}

void SweepEndConditions::writeTo(results::SweepSpec& spec) const
{
    spec.stopOnAlarm = m_onAlarm->isChecked();
    spec.stopOnStall = m_onStall->isChecked();
    spec.stopOnFailure = m_onFailure->isChecked();
}

void SweepEndConditions::retranslate()
{
    m_title->setText(tr("End early on"));
    m_onAlarm->setText(tr("Alarm"));
    m_onAlarm->setToolTip(tr("Any alarm that the servo reports, such as an over-temperature, "
                             "overload or voltage alarm"));
    m_onStall->setText(tr("Stall"));
    m_onStall->setToolTip(tr("The servo stops too far from its goal"));
    m_onFailure->setText(tr("First failure"));
    m_onFailure->setToolTip(tr("A metric is beyond its limit; checked after every cycle"));
    for (QCheckBox* box : {m_onAlarm, m_onStall, m_onFailure})
        box->setAccessibleName(m_title->text() + QLatin1Char(' ') + box->text());
}
} // namespace ui
