// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/trends/trigger_dialog.h"

#include "ui/common/follow_language.h"
#include "ui/common/widget_style.h"
#include "ui/common/widget_text.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace ui {
using recording::MarkKind;
using recording::TriggerSpec;

namespace {
constexpr double maxLevel = 1e6;
constexpr double maxPrePostSeconds = 3600;
/// The moving flag is 0 or 1.
constexpr double halfWay = 0.5;

base::Duration seconds(double value)
{
    return base::Duration(static_cast<base::Duration::rep>(value * 1e6));
}
double seconds(base::Duration value)
{
    return double(value.count()) / 1e6;
}
} // namespace

TriggerDialog::TriggerDialog(std::vector<TrendChannel> curves, recording::ChannelId moving,
                             const TriggerSpec& before, QWidget* parent)
    : QDialog(parent)
    , m_curves(std::move(curves))
    , m_moving(moving)
{
    setObjectName(QStringLiteral("triggerDialog"));
    setAttribute(Qt::WA_DeleteOnClose);
    build();
    followLanguage(this, [this] { retranslate(); });
    setSpec(before);
    refresh();
}

void TriggerDialog::build()
{
    auto* column = new QVBoxLayout(this);
    buildForm();
    auto* buttons = new QHBoxLayout;
    m_arm = new QPushButton(this);
    m_arm->setObjectName(QStringLiteral("triggerArm"));
    makeMainAction(m_arm);
    m_arm->setDefault(true);
    m_cancel = new QPushButton(this);
    m_cancel->setObjectName(QStringLiteral("triggerCancel"));
    buttons->addStretch();
    buttons->addWidget(m_cancel);
    buttons->addWidget(m_arm);
    column->addLayout(m_form);
    column->addLayout(buttons);
    for (QComboBox* box : {m_kind, m_curve})
        connect(box, &QComboBox::currentIndexChanged, this, &TriggerDialog::refresh);
    connect(m_cancel, &QPushButton::clicked, this, &QDialog::close);
    connect(m_arm, &QPushButton::clicked, this, [this] {
        Q_EMIT triggerArmed(spec());
        close();
    });
}

void TriggerDialog::buildForm()
{
    m_form = new QFormLayout;
    const auto combo = [this](const char* name) {
        auto* box = new QComboBox(this);
        box->setObjectName(QString::fromLatin1(name));
        m_form->addRow(new QLabel(this), box);
        return box;
    };
    const auto number = [this](const char* name, double low, double high) {
        auto* box = new QDoubleSpinBox(this);
        box->setObjectName(QString::fromLatin1(name));
        box->setRange(low, high);
        box->setDecimals(2);
        m_form->addRow(new QLabel(this), box);
        return box;
    };
    m_kind = combo("triggerKind");
    m_curve = combo("triggerCurve");
    for (const TrendChannel& curve : m_curves)
        m_curve->addItem(curve.name, curve.id);
    m_level = number("triggerLevel", -maxLevel, maxLevel);
    m_hysteresis = number("triggerHysteresis", 0, maxLevel);
    m_pre = number("triggerPre", 0, maxPrePostSeconds);
    m_post = number("triggerPost", 0, maxPrePostSeconds);
}

TriggerDialog::TriggerKind TriggerDialog::triggerKind() const
{
    return static_cast<TriggerKind>(std::max(m_kind->currentIndex(), 0));
}

bool TriggerDialog::isCurveTrigger() const
{
    return triggerKind() <= TriggerKind::Below;
}

void TriggerDialog::refresh()
{
    for (QWidget* field : std::initializer_list<QWidget*>{m_curve, m_level, m_hysteresis}) {
        const bool edge = field != m_hysteresis || triggerKind() == TriggerKind::Rising ||
                          triggerKind() == TriggerKind::Falling;
        field->setVisible(isCurveTrigger() && edge);
        m_form->labelForField(field)->setVisible(isCurveTrigger() && edge);
    }
    const int index = m_curve->currentIndex();
    const QString unit = index >= 0 ? m_curves.at(static_cast<std::size_t>(index)).unit : QString();
    for (QDoubleSpinBox* box : {m_level, m_hysteresis})
        box->setSuffix(unit.isEmpty() ? QString() : QLatin1Char(' ') + unit);
    const bool flag =
        triggerKind() == TriggerKind::MoveBegins || triggerKind() == TriggerKind::MoveEnds;
    const bool canRun = flag ? m_moving >= 0 : !isCurveTrigger() || index >= 0;
    m_arm->setEnabled(canRun);
    m_arm->setToolTip(canRun ? tr("Pauses the chart when the event occurs")
                             : tr("No values suitable for a trigger are being read"));
}

TriggerSpec TriggerDialog::spec() const
{
    TriggerSpec spec;
    spec.channel = m_curve->currentData().isValid() ? m_curve->currentData().toInt() : -1;
    spec.level = m_level->value();
    spec.hysteresis = m_hysteresis->value();
    spec.pre = seconds(m_pre->value());
    spec.post = seconds(m_post->value());
    switch (triggerKind()) {
    case TriggerKind::Rising:
        spec.kind = TriggerSpec::Kind::Rising;
        break;
    case TriggerKind::Falling:
        spec.kind = TriggerSpec::Kind::Falling;
        break;
    case TriggerKind::Above:
        spec.kind = TriggerSpec::Kind::Above;
        break;
    case TriggerKind::Below:
        spec.kind = TriggerSpec::Kind::Below;
        break;
    case TriggerKind::MoveBegins:
    case TriggerKind::MoveEnds:
        spec.kind = triggerKind() == TriggerKind::MoveBegins ? TriggerSpec::Kind::Rising
                                                             : TriggerSpec::Kind::Falling;
        spec.channel = m_moving;
        spec.level = halfWay;
        spec.hysteresis = 0;
        break;
    case TriggerKind::Fault:
    case TriggerKind::Write:
    case TriggerKind::LinkError:
        spec.kind = TriggerSpec::Kind::Mark;
        spec.channel = -1;
        spec.mark = triggerKind() == TriggerKind::Fault   ? MarkKind::Fault
                    : triggerKind() == TriggerKind::Write ? MarkKind::Write
                                                          : MarkKind::LinkError;
        break;
    }
    return spec;
}

void TriggerDialog::setSpec(const TriggerSpec& before)
{
    m_pre->setValue(seconds(before.pre));
    m_post->setValue(seconds(before.post));
    m_level->setValue(before.level);
    m_hysteresis->setValue(before.hysteresis);
    if (const int index = m_curve->findData(before.channel); index >= 0)
        m_curve->setCurrentIndex(index);
    if (before.kind == TriggerSpec::Kind::Falling)
        m_kind->setCurrentIndex(int(TriggerKind::Falling));
    else if (before.kind == TriggerSpec::Kind::Above)
        m_kind->setCurrentIndex(int(TriggerKind::Above));
    else if (before.kind == TriggerSpec::Kind::Below)
        m_kind->setCurrentIndex(int(TriggerKind::Below));
    else if (before.kind == TriggerSpec::Kind::Mark)
        m_kind->setCurrentIndex(int(before.mark == MarkKind::Write       ? TriggerKind::Write
                                    : before.mark == MarkKind::LinkError ? TriggerKind::LinkError
                                                                         : TriggerKind::Fault));
}

void TriggerDialog::retranslate()
{
    setWindowTitle(tr("Trigger"));
    const int kind = std::max(m_kind->currentIndex(), 0);
    m_kind->clear();
    m_kind->addItems({tr("The value rises through a level"), tr("The value falls through a level"),
                      tr("The value is above a level"), tr("The value is below a level"),
                      tr("The servo starts to move"), tr("The servo has stopped"),
                      tr("An alarm occurs"), tr("A value is written"),
                      tr("A servo stops replying")});
    m_kind->setCurrentIndex(kind);
    setFieldText(m_form, m_kind, tr("Wait until"), tr("Event that the chart waits for"));
    setFieldText(m_form, m_curve, tr("Channel"), tr("Channel to monitor"));
    setFieldText(m_form, m_level, tr("Level"), tr("In the unit of the channel"));
    setFieldText(m_form, m_hysteresis, tr("Hysteresis"),
                 tr("How far the value must first move to the other side of the level; prevents "
                    "repeated triggering by noise"));
    setFieldText(m_form, m_pre, tr("Seconds before"), tr("Time shown before the trigger"));
    setFieldText(m_form, m_post, tr("Seconds after"),
                 tr("Time shown after the trigger; then the chart pauses"));
    m_arm->setText(tr("Wait for trigger"));
    m_arm->setAccessibleName(m_arm->text());
    m_cancel->setText(tr("Cancel"));
    m_cancel->setToolTip(tr("Closes without setting a trigger"));
    refresh();
}
} // namespace ui
