// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/connect/link_options.h"

#include "ui/common/follow_language.h"
#include "ui/common/widget_text.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSpinBox>

namespace ui {
namespace {
constexpr int maxTimeoutMs = 2000;
constexpr int maxSilenceUs = 100'000;
constexpr int maxRetries = 10;

QSpinBox* spinBox(QWidget* parent, const char* name, int min, int max, int step)
{
    auto* box = new QSpinBox(parent);
    box->setObjectName(QLatin1String(name));
    box->setRange(min, max);
    box->setSingleStep(step);
    return box;
}
} // namespace

LinkOptions::LinkOptions(QWidget* parent)
    : PopupFrame("linkOptions", parent)
    , m_parity(new QComboBox(this))
    , m_replyTimeout(spinBox(this, "timeoutBox", 0, maxTimeoutMs, 5))
    , m_silence(spinBox(this, "silenceBox", 0, maxSilenceUs, 250))
    , m_retries(spinBox(this, "retriesBox", -1, maxRetries, 1))
    , m_form(new QFormLayout(this))
{
    setFocusProxy(m_parity);
    m_parity->setObjectName(QStringLiteral("parityBox"));
    for (int i = 0; i < 3; ++i)
        m_parity->addItem(QString());
    m_retries->setValue(-1);
    for (QWidget* field :
         std::initializer_list<QWidget*>{m_parity, m_replyTimeout, m_silence, m_retries})
        m_form->addRow(new QLabel(this), field); // an empty string would make no label
    connect(m_parity, &QComboBox::currentIndexChanged, this, &LinkOptions::changed);
    for (QSpinBox* box : {m_replyTimeout, m_silence, m_retries})
        connect(box, &QSpinBox::valueChanged, this, &LinkOptions::changed);
    followLanguage(this, [this] { retranslate(); });
}

void LinkOptions::apply(session::PortRequest& request) const
{
    request.parity = session::Parity(m_parity->currentIndex());
    request.maxReplyLateness.reset();
    request.frameSilence.reset();
    request.retries.reset();
    if (m_replyTimeout->value() > 0)
        request.maxReplyLateness = std::chrono::milliseconds(m_replyTimeout->value());
    if (m_silence->value() > 0)
        request.frameSilence = base::Duration(m_silence->value());
    if (m_retries->value() >= 0)
        request.retries = m_retries->value();
}

void LinkOptions::show(const session::PortRequest& request)
{
    const QSignalBlocker quiet(this);
    m_parity->setCurrentIndex(int(request.parity));
    m_replyTimeout->setValue(
        int(request.maxReplyLateness.value_or(base::Duration{}).count() / 1000));
    m_silence->setValue(int(request.frameSilence.value_or(base::Duration{}).count()));
    m_retries->setValue(request.retries.value_or(-1));
}

bool LinkOptions::isDefault() const
{
    return m_parity->currentIndex() == 0 && m_replyTimeout->value() == 0 &&
           m_silence->value() == 0 && m_retries->value() < 0;
}

void LinkOptions::retranslate()
{
    const auto name = [this](QWidget* field, const QString& label, const QString& tip) {
        setFieldText(m_form, field, label, tip);
        m_form->labelForField(field)->setToolTip(tip);
    };
    const QSignalBlocker quiet(m_parity);
    m_parity->setItemText(0, tr("none"));
    m_parity->setItemText(1, tr("even"));
    m_parity->setItemText(2, tr("odd"));
    for (QSpinBox* box : {m_replyTimeout, m_silence, m_retries})
        box->setSpecialValueText(tr("auto"));
    m_replyTimeout->setSuffix(tr(" ms"));
    m_silence->setSuffix(tr(" µs"));
    name(m_parity, tr("Parity"), tr("Servos are set to no parity at the factory"));
    name(m_replyTimeout, tr("Timeout"),
         tr("Time to wait for a reply, in addition to the transmission time (auto: adjusted to "
            "this adapter; a servo counts as silent after 500 ms)"));
    name(m_silence, tr("Modbus frame gap"),
         tr("Pause between Modbus frames (auto: the standard pause for the baud rate)"));
    name(m_retries, tr("Retries"),
         tr("Number of times a lost request is sent again, if it is safe to repeat"));
}
} // namespace ui
