// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tasks/set_baud_dialog.h"

#include "text/translate.h"
#include "ui/widgets/rate_text.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>

namespace ui {
using catalog::Role;
using session::Event;
using session::ServoEntry;
using text::translate;

namespace {
const catalog::Register* baudRateRegister(const ServoEntry& entry)
{
    return entry.servo.profile ? entry.servo.profile->byRole(Role::BaudRate) : nullptr;
}
} // namespace

SetBaudDialog::SetBaudDialog(session::Desk& desk, session::ServoRef servo, QWidget* parent)
    : TaskDialog(desk, servo, "setBaudDialog", parent)
    , m_label(new QLabel(this))
    , m_rates(new QComboBox(this))
    , m_state(textLabel("baudState"))
{
    m_rates->setObjectName(QStringLiteral("newBaud"));
    m_label->setBuddy(m_rates);
    auto* row = new QHBoxLayout;
    row->addWidget(m_label);
    row->addWidget(m_rates);
    row->addStretch();
    body()->addLayout(row);
    body()->addWidget(m_state);
    fillRates();
    connect(m_rates, &QComboBox::currentIndexChanged, this, [this] { validate(); });
    connect(&desk, &session::Desk::eventOccurred, this, &SetBaudDialog::onDeskEvent);
    finishSetup();
    if (baudRateRegister(*entry()) == nullptr) {
        m_rates->setEnabled(false);
        const base::Error refused{base::ErrorCode::NotSupported, QStringLiteral("set-baud"),
                                  QStringLiteral("fixed-rate"), entry()->servo.id};
        showResult([refused] {
            return refusedText(refused,
                               translate("ServoTasks", "The rate of this servo is fixed."));
        });
    }
    m_rates->setFocus();
}

void SetBaudDialog::fillRates()
{
    const catalog::Register* reg = baudRateRegister(*entry());
    if (reg == nullptr)
        return;
    const QSignalBlocker blocker(m_rates);
    for (const catalog::NamedValue& value : reg->values) {
        bool number = false;
        const int rate = value.key.toInt(&number);
        if (number)
            m_rates->addItem(rateText(rate), value.value);
        if (number && rate == entry()->servo.baud)
            m_rates->setCurrentIndex(m_rates->count() - 1);
    }
}

int SetBaudDialog::neighbors() const
{
    int count = 0;
    for (const session::ServoRef ref : desk().servos())
        count += ref != servo() && desk().servo(ref)->servo.baud == entry()->servo.baud ? 1 : 0;
    return count;
}

void SetBaudDialog::validate()
{
    const catalog::Register* reg = baudRateRegister(*entry());
    if (reg == nullptr) {
        m_state->setVisible(false);
        setReady(false);
        return;
    }
    const bool same = m_rates->currentText() == rateText(entry()->servo.baud);
    QStringList lines;
    if (same) {
        lines << translate("ServoTasks", "It answers at this rate now.");
    } else {
        lines << translate("ServoTasks", "From then on it answers at %1 baud only. ServoDesk "
                                         "follows it; other programs have to be told.")
                     .arg(m_rates->currentText());
        if (const int others = neighbors(); others > 0)
            lines << translate("ServoTasks", "Other servos that stay at %1 baud: %2. A program "
                                             "that uses one rate no longer reaches all of them.")
                         .arg(rateText(entry()->servo.baud))
                         .arg(others);
    }
    m_state->setText(lines.join(QLatin1Char('\n')));
    setReady(!same);
}

void SetBaudDialog::retranslate()
{
    setTexts(translate("ServoTasks", "Set baud rate"),
             translate("ServoTasks", "The new rate is tried first: only one that this adapter can "
                                     "run is written. It is kept at power-off."),
             translate("ServoTasks", "Set baud rate"),
             translate("ServoTasks", "Write the rate, find the servo there, and close its lock"));
    m_label->setText(translate("ServoTasks", "New baud rate:"));
    m_rates->setAccessibleName(translate("ServoTasks", "New baud rate"));
    m_rates->setToolTip(translate("ServoTasks", "The rates that this family knows"));
}

void SetBaudDialog::refresh()
{
    validate();
}

void SetBaudDialog::runAction()
{
    const catalog::Register* reg = baudRateRegister(*entry());
    if (reg == nullptr)
        return;
    m_writing = true;
    setRunning(true);
    session::WriteRequest order;
    order.items = {{reg->key, m_rates->currentData().toInt()}};
    order.dangerous = true; // this dialog is the question
    desk().write(servo(), order);
}

/// Writes have no callback: ours has ended when no write of the rate is pending any more.
void SetBaudDialog::onDeskEvent(const Event& event)
{
    const ServoEntry* own = entry();
    if (!m_writing || event.kind != Event::Kind::Written || event.servo != servo() ||
        own == nullptr)
        return;
    const auto row = own->writes.find(baudRateRegister(*own)->key);
    if (row != own->writes.end() && row->second.pending > 0)
        return;
    m_writing = false;
    setRunning(false);
    refresh();
    if (event.error)
        showError(*event.error);
    if (!event.report)
        return;
    showResult([this, report = *event.report, notices = event.notices] {
        TaskText result =
            writeText(*entry(), report, translate("ServoTasks", "The baud rate has been changed."));
        result.details += noticeLines(notices);
        return result;
    });
}
} // namespace ui
