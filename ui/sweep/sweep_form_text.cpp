// SPDX-License-Identifier: GPL-3.0-or-later
// What the fields of a sweep test are called.
#include "ui/sweep/sweep_form.h"
#include "ui/widgets/segment_button.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>

namespace ui {
namespace {
void name(QLabel* title, QWidget* field, const QString& text, const QString& tip)
{
    title->setText(text);
    title->setToolTip(tip);
    field->setAccessibleName(text);
    field->setToolTip(tip);
}
} // namespace

void SweepForm::retranslate()
{
    const std::array shapes{
        std::pair{tr("Sweep"), tr("To and fro between start and end")},
        std::pair{tr("Stairs"), tr("From start to end in steps, and back the same steps")},
        std::pair{tr("Both sides"), tr("The middle is come to from either side: shows hysteresis")},
        std::pair{tr("Sine"), tr("Goals follow a sine: shows how well it follows")},
        std::pair{tr("Random"), tr("Random targets, the same ones for the same number")},
        std::pair{tr("List"), tr("Targets from a file, one a line")}};
    for (std::size_t i = 0; i < m_shapes.size(); ++i) {
        m_shapes[i]->setText(shapes[i].first);
        m_shapes[i]->setToolTip(shapes[i].second);
        m_shapes[i]->setAccessibleName(shapes[i].first);
    }
    const auto set = [this](Cell cell, const QString& text, const QString& tip) {
        name(m_cells[cell].title, m_cells[cell].field, text, tip);
    };
    const QString place = tr("A raw number, or an angle with its unit: 90deg");
    set(Start, tr("Start"), place);
    set(End, tr("End"), place);
    set(Step, tr("Step"), tr("A raw number of steps, or an angle with its unit: 10deg"));
    set(Period, tr("Period"), tr("Of one whole sine, to the end and back"));
    set(Seed, tr("Sequence"), tr("The same number gives the same targets again"));
    set(List, tr("Targets"),
        tr("A text file: one target a line, and if wished a comma and its "
           "pause in milliseconds"));
    set(Pace, tr("Next goal"), tr("When the next goal is sent"));
    set(Pause, m_pace->currentIndex() == 1 ? tr("Dwell") : tr("Delay"),
        m_pace->currentIndex() == 1 ? tr("So long it rests where it has arrived")
                                    : tr("From one goal to the next, arrived or not"));
    set(Until, tr("Ends after"), tr("When the test has run its course"));
    set(Cycles, tr("Cycles"), tr("One cycle is there and back"));
    set(Minutes, tr("Duration"), tr("From the first leg on"));
    set(Speed, tr("Speed"),
        tr("A raw number, or with its unit: 30rpm. Empty: as the servo has "
           "it"));
    set(Acceleration, tr("Acceleration"), tr("A raw number. Empty: as the servo has it"));
    set(Time, tr("Time"),
        tr("Travel time of a move in milliseconds. Empty: as fast as the speed "
           "says"));
    set(WarmUp, tr("Warm-up"), tr("It moves so long before anything is measured"));
    set(Afterwards, tr("Afterwards"),
        tr("What the servos do when the test has ended or was "
           "stopped"));
    set(Operator, tr("Operator"), tr("Stands in the report"));
    set(Note, tr("Note"), tr("Stands in the report"));
    m_period->setSuffix(tr(" s"));
    m_pause->setSuffix(tr(" ms"));
    m_minutes->setSuffix(tr(" min"));
    m_warmUp->setSuffix(tr(" s"));
    m_speed->setPlaceholderText(tr("as it is"));
    m_acceleration->setPlaceholderText(tr("as it is"));
    m_time->setPlaceholderText(tr("by speed"));
    m_pace->setItemText(0, tr("After a delay"));
    m_pace->setItemText(1, tr("After arrival"));
    m_until->setItemText(0, tr("A number of cycles"));
    m_until->setItemText(1, tr("A length of time"));
    m_afterwards->setItemText(0, tr("Hold"));
    m_afterwards->setItemText(1, tr("Torque off"));
    m_list->setText(
        m_listPath.isEmpty() || !m_listTrouble.isEmpty()
            ? tr("Open a list…")
            : tr("%1 (targets: %2)").arg(QFileInfo(m_listPath).fileName()).arg(m_points.size()));
    m_earlyTitle->setText(tr("Ends early on"));
    m_onAlarm->setText(tr("alarm"));
    m_onAlarm->setToolTip(tr("Over-temperature, overload, voltage: whatever the servo reports"));
    m_onStall->setText(tr("stall"));
    m_onStall->setToolTip(tr("It stands still away from its target"));
    m_onFailure->setText(tr("first failure"));
    m_onFailure->setToolTip(tr("A limit is failed: judged after every cycle"));
    for (QCheckBox* box : {m_onAlarm, m_onStall, m_onFailure})
        box->setAccessibleName(m_earlyTitle->text() + QLatin1Char(' ') + box->text());
}
} // namespace ui
