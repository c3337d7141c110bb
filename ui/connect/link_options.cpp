// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/connect/link_options.h"

#include <QComboBox>
#include <QEvent>
#include <QFormLayout>
#include <QLabel>
#include <QScreen>
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
    : QFrame(parent, Qt::Popup)
    , m_parity(new QComboBox(this))
    , m_replyTimeout(spinBox(this, "patienceBox", 0, maxTimeoutMs, 5))
    , m_silence(spinBox(this, "silenceBox", 0, maxSilenceUs, 250))
    , m_retries(spinBox(this, "retriesBox", -1, maxRetries, 1))
    , m_form(new QFormLayout(this))
{
    setObjectName(QStringLiteral("linkOptions"));
    setFrameShape(QFrame::StyledPanel);
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
    retranslate();
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

void LinkOptions::popUpBelow(const QWidget& button)
{
    adjustSize();
    QPoint position = button.mapToGlobal(QPoint(0, button.height()));
    const QRect screen = button.screen()->availableGeometry();
    position.setX(
        qBound(screen.left(), position.x(), qMax(screen.left(), screen.right() - width())));
    position.setY(
        qBound(screen.top(), position.y(), qMax(screen.top(), screen.bottom() - height())));
    move(position);
    QFrame::show();
    m_parity->setFocus();
}

void LinkOptions::retranslate()
{
    const auto name = [this](QWidget* field, const QString& label, const QString& tip) {
        auto* words = qobject_cast<QLabel*>(m_form->labelForField(field));
        words->setText(label);
        words->setToolTip(tip);
        field->setToolTip(tip);
        field->setAccessibleName(label);
    };
    const QSignalBlocker quiet(m_parity);
    m_parity->setItemText(0, tr("none"));
    m_parity->setItemText(1, tr("even"));
    m_parity->setItemText(2, tr("odd"));
    for (QSpinBox* box : {m_replyTimeout, m_silence, m_retries})
        box->setSpecialValueText(tr("auto"));
    m_replyTimeout->setSuffix(tr(" ms"));
    m_silence->setSuffix(tr(" µs"));
    name(m_parity, tr("Parity"), tr("Servos leave the factory without parity"));
    name(m_replyTimeout, tr("Time-out"),
         tr("How long to wait for an answer beyond its time on the wire. Auto: as long as this "
            "adapter has shown to need"));
    name(m_silence, tr("Modbus silence"),
         tr("Pause between Modbus frames. Auto: as the standard says for the rate"));
    name(m_retries, tr("Retries"),
         tr("How often a lost question is asked again, where it may be repeated"));
}

void LinkOptions::changeEvent(QEvent* event)
{
    QFrame::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
}
} // namespace ui
