// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/operate/operate_status.h"

#include "text/translate.h"
#include "ui/widgets/feedback.h"
#include "ui/widgets/flow_layout.h"
#include "ui/widgets/pill.h"
#include "ui/widgets/rate_text.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

namespace ui {
using catalog::Role;

namespace {
constexpr std::size_t maxAlarms = 8;

bool reportsFaults(const device::Servo& servo)
{
    return servo.repliesCarryStatus() ||
           (servo.profile && servo.profile->byRole(Role::Status) != nullptr);
}

bool faultsRead(const device::Servo& servo)
{
    if (!servo.profile)
        return false;
    if (servo.repliesCarryStatus())
        return true;
    return servo
        .raw(servo.profile->byRole(Role::Status) != nullptr ? Role::Status
                                                            : Role::PresentTemperature)
        .has_value();
}
} // namespace

OperateStatus::OperateStatus(QWidget* parent)
    : QWidget(parent)
{
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins({});
    auto* pills = new QWidget(this);
    QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Minimum);
    policy.setHeightForWidth(true);
    pills->setSizePolicy(policy);
    m_row = new FlowLayout(pills, 6);
    const auto pill = [&](const char* name) {
        auto* one = new Pill(pills);
        one->setObjectName(QString::fromLatin1(name));
        m_row->addWidget(one);
        return one;
    };
    m_link = pill("statusLink");
    m_moving = pill("statusMoving");
    m_noAlarm = pill("statusNoAlarm");
    for (std::size_t i = 0; i < maxAlarms; ++i) {
        m_alarms.push_back(pill("statusAlarm"));
        m_alarms.back()->hide();
    }
    m_acknowledge = new QPushButton(pills);
    m_acknowledge->setObjectName(QStringLiteral("acknowledge"));
    m_acknowledge->hide();
    m_row->addWidget(m_acknowledge);
    m_age = new QLabel(this);
    m_age->setObjectName(QStringLiteral("statusAge"));
    m_age->setForegroundRole(QPalette::PlaceholderText);
    m_age->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    row->addWidget(pills, 1);
    row->addWidget(m_age);
    connect(m_acknowledge, &QPushButton::clicked, this, &OperateStatus::acknowledgeRequested);
    retranslate();
}

void OperateStatus::show(const session::ServoEntry* entry, const session::Desk& desk)
{
    setVisible(entry != nullptr);
    if (entry == nullptr)
        return;
    showLink(*entry, desk);
    showMoving(*entry, desk);
    showAlarms(*entry, desk);
    showAge(*entry, desk);
}

/// The words are FD's: a technician knows them.
void OperateStatus::showLink(const session::ServoEntry& entry, const session::Desk& desk)
{
    if (desk.state() != session::LinkState::Open) {
        m_link->setState(Tone::Quiet, tr("Not connected"));
        return;
    }
    const bool silent = entry.silent || entry.linkMonitor.isLost();
    const auto& counters = desk.statistics().byId;
    const auto own = counters.find(entry.servo.id);
    QString more;
    if (own != counters.end())
        more = tr("Answers: %1 · time-outs: %2 · wrong checksums: %3")
                   .arg(own->second.ok)
                   .arg(own->second.timeouts)
                   .arg(own->second.badChecksums);
    const bool fresh = isFresh(entry, desk);
    m_link->setState(silent  ? Tone::Bad
                     : fresh ? Tone::Good
                             : Tone::Quiet,
                     silent && entry.garbled ? tr("Unreadable answers")
                     : silent                ? tr("Time-out")
                     : fresh                 ? tr("Communication fine")
                                             : text::translate("ServoRow", "Last seen: %1")
                                   .arg(timeAgoText(desk.now() - entry.lastSeen)),
                     {}, more);
}

void OperateStatus::showMoving(const session::ServoEntry& entry, const session::Desk& desk)
{
    const catalog::Register* reg =
        entry.servo.profile ? entry.servo.profile->byRole(Role::Moving) : nullptr;
    const auto moving = reg != nullptr ? entry.displayedRaw(*reg) : std::nullopt;
    if (!isFresh(entry, desk))
        m_moving->setState(Tone::Quiet, tr("moving: not known"));
    else if (reg == nullptr)
        m_moving->setState(Tone::Quiet, tr("no moving flag"));
    else if (!moving)
        m_moving->setState(Tone::Quiet, tr("moving: not read"));
    else
        m_moving->setState(*moving != 0 ? Tone::Accent : Tone::Quiet,
                           *moving != 0 ? tr("moving") : tr("stopped"));
}

/// Faults are known where the servo answers and what tells of them has been read.
void OperateStatus::showAlarms(const session::ServoEntry& entry, const session::Desk& desk)
{
    const auto& alarms = entry.alarms.alarms();
    for (std::size_t i = 0; i < m_alarms.size(); ++i) {
        const bool used = i < alarms.size();
        m_alarms[i]->setVisible(used);
        if (!used)
            continue;
        const session::Alarm& alarm = alarms[i];
        QString words = (alarm.active ? QStringLiteral("✗ ") : QStringLiteral("! ")) +
                        faultText(alarm.what.key);
        if (!alarm.active)
            words += tr(" — over");
        if (alarm.count > 1)
            words += QStringLiteral(" × %1").arg(alarm.count);
        const QString first = locale().toString(alarm.firstSeen.time(), QLocale::LongFormat);
        QString more = tr("First seen %1, %2 times").arg(first).arg(alarm.count);
        if (alarm.what.derived)
            more += QLatin1Char('\n') + tr("Worked out from its limits: it reports no faults");
        m_alarms[i]->setState(alarm.active ? Tone::Bad : Tone::Warn, words, {}, more);
    }
    m_noAlarm->setVisible(alarms.empty());
    const bool judged = isFresh(entry, desk) && faultsRead(entry.servo);
    m_noAlarm->setState(Tone::Quiet, judged ? tr("no alarm") : tr("alarms: –"), {},
                        !judged ? tr("Not known: the servo does not answer, or what tells of "
                                     "faults has not been read")
                        : reportsFaults(entry.servo)
                            ? QString()
                            : tr("Worked out from its limits: it reports no faults"));
    m_acknowledge->setVisible(!alarms.empty());
}

void OperateStatus::showAge(const session::ServoEntry& entry, const session::Desk& desk)
{
    const session::PollRate rate = desk.pollRate(entry.ref);
    if (!rate.lastAt) {
        m_age->setText(tr("not read yet"));
        return;
    }
    const double age = std::max(0.0, double((desk.now() - *rate.lastAt).count()) / 1e3);
    const QString old = age < 1000 ? tr("%1 ms").arg(qRound(age))
                                   : tr("%1 s").arg(age / 1e3, 0, 'f', age < 10000 ? 1 : 0);
    QString words = tr("value age %1 · %2 Hz").arg(old).arg(qRound(rate.hz));
    if (rate.missed > 0)
        words += tr(" · missed: %1").arg(rate.missed);
    m_age->setText(words);
}

void OperateStatus::retranslate()
{
    m_acknowledge->setText(tr("Acknowledge"));
    m_acknowledge->setAccessibleName(m_acknowledge->text());
    m_acknowledge->setToolTip(tr("Faults that are over go from here; the others stay"));
    m_age->setToolTip(tr("How old the newest value is, and how many readings came in the last "
                         "second"));
    m_age->setAccessibleName(tr("Age and rate"));
}

void OperateStatus::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
}
} // namespace ui
