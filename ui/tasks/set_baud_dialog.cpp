// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tasks/set_baud_dialog.h"

#include "text/translate.h"
#include "ui/widgets/rate_text.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>

namespace ui {
using catalog::Role;
using session::ServoEntry;
using text::translate;

namespace {
const catalog::Register* baudRateRegister(const ServoEntry& entry)
{
    return entry.servo.profile ? entry.servo.profile->byRole(Role::BaudRate) : nullptr;
}
} // namespace

SetBaudDialog::SetBaudDialog(session::Workbench& workbench, session::ServoRef servo,
                             QWidget* parent)
    : TaskDialog(workbench, servo, "setBaudDialog", parent)
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
    finishSetup();
    if (baudRateRegister(*entry()) == nullptr) {
        m_rates->setEnabled(false);
        const base::Error refused{base::ErrorCode::NotSupported, QStringLiteral("set-baud"),
                                  QStringLiteral("fixed-rate"), entry()->servo.id};
        showResult([refused] {
            return refusedText(refused,
                               translate("ServoTasks", "The baud rate of this servo is fixed."));
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
    for (const session::ServoRef ref : workbench().registry().order())
        count +=
            ref != servo() && workbench().registry().servo(ref)->servo.baud == entry()->servo.baud
                ? 1
                : 0;
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
        lines << translate("ServoTasks", "The servo already uses this baud rate.");
    } else {
        lines << translate(
                     "ServoTasks",
                     "After this change, the servo will reply only at %1 baud. ServoDesk switches "
                     "automatically; other programs must be set to the new baud rate.")
                     .arg(m_rates->currentText());
        if (const int others = neighbors(); others > 0)
            lines << translate("ServoTasks",
                               "%n other servo(s) stay at %1 baud. A program that uses only one "
                               "baud rate can no longer reach all servos.",
                               nullptr, others)
                         .arg(rateText(entry()->servo.baud));
    }
    m_state->setText(lines.join(QLatin1Char('\n')));
    setReady(!same);
}

void SetBaudDialog::retranslate()
{
    setTexts(translate("ServoTasks", "Set baud rate"),
             translate("ServoTasks",
                       "The new baud rate is tested first and written only if this adapter "
                       "supports it. The servo keeps the new baud rate after power-off."),
             translate("ServoTasks", "Set baud rate"),
             translate("ServoTasks", "Writes the baud rate, finds the servo at the new baud "
                                     "rate, and locks the EPROM"));
    m_label->setText(translate("ServoTasks", "New baud rate:"));
    m_rates->setAccessibleName(translate("ServoTasks", "New baud rate"));
    m_rates->setToolTip(translate("ServoTasks", "Baud rates supported by this family"));
}

void SetBaudDialog::refresh()
{
    validate();
}

void SetBaudDialog::runAction()
{
    if (const catalog::Register* reg = baudRateRegister(*entry()))
        writeRegister(*reg, m_rates->currentData().toInt(),
                      QT_TRANSLATE_NOOP("ServoTasks", "The baud rate has been changed."));
}
} // namespace ui
