// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/operate/operate_status.h"

#include "text/translate.h"
#include "ui/common/follow_language.h"
#include "ui/common/widget_text.h"
#include "ui/widgets/feedback.h"
#include "ui/widgets/flow_layout.h"
#include "ui/widgets/pill.h"
#include "ui/widgets/rate_text.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>

namespace ui {
using catalog::Role;

namespace {
constexpr std::size_t maxAlarms = 8;
/// Numbers that change faster cannot be read, and each change lays out the line anew.
constexpr base::Duration ageInterval = std::chrono::milliseconds(500);

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
    m_gauges = new QToolButton(this);
    m_gauges->setObjectName(QStringLiteral("showGauges"));
    m_gauges->setProperty("disclosure", true);
    m_gauges->setCheckable(true);
    m_gauges->setFocusPolicy(Qt::StrongFocus);
    row->addWidget(pills, 1);
    row->addWidget(m_age);
    row->addWidget(m_gauges);
    connect(m_gauges, &QToolButton::toggled, this, [this](bool shown) {
        setGauges(shown, true);
        Q_EMIT gaugesToggled(shown);
    });
    connect(m_acknowledge, &QPushButton::clicked, this, &OperateStatus::acknowledgeRequested);
    followLanguage(this, [this] { retranslate(); });
}

void OperateStatus::setGauges(bool shown, bool hasRoom)
{
    m_gauges->setEnabled(hasRoom);
    const QSignalBlocker blocker(m_gauges);
    m_gauges->setChecked(shown);
    m_gauges->setArrowType(shown && hasRoom ? Qt::DownArrow : Qt::RightArrow);
}

void OperateStatus::show(const session::ServoEntry* entry, const session::Workbench& workbench)
{
    setVisible(entry != nullptr);
    if (entry == nullptr)
        return;
    showLink(*entry, workbench);
    showMoving(*entry, workbench);
    showAlarms(*entry, workbench);
    showAge(*entry, workbench);
}

namespace {
/// Only colliding replies have ever come.
bool isNeverReadable(const session::ServoEntry& entry)
{
    return entry.duplicateSuspected && !entry.servo.profile;
}
} // namespace

/// The words are those of the FD software, which technicians know.
void OperateStatus::showLink(const session::ServoEntry& entry, const session::Workbench& workbench)
{
    if (workbench.link().state() != session::LinkState::Open) {
        m_link->setState(Tone::Quiet, tr("Not connected"));
        return;
    }
    const bool silent = entry.silent || entry.linkMonitor.isLost();
    const auto& counters = workbench.link().statistics().byId;
    const auto own = counters.find(entry.servo.id);
    QString more;
    if (own != counters.end())
        more = tr("Replies: %1 · timeouts: %2 · checksum errors: %3")
                   .arg(own->second.ok)
                   .arg(own->second.timeouts)
                   .arg(own->second.badChecksums);
    const bool fresh = isFresh(entry, workbench.link(), workbench.now());
    const bool unreadable = silent ? entry.garbled : isNeverReadable(entry);
    m_link->setState(silent || unreadable ? Tone::Bad
                     : fresh              ? Tone::Good
                                          : Tone::Quiet,
                     unreadable ? tr("Unreadable replies")
                     : silent   ? tr("Timeout")
                     : fresh    ? tr("Communication OK")
                                : text::translate("ServoRow", "Last seen: %1")
                                   .arg(timeAgoText(workbench.now() - entry.lastSeen)),
                     {}, more);
}

void OperateStatus::showMoving(const session::ServoEntry& entry,
                               const session::Workbench& workbench)
{
    const catalog::Register* reg =
        entry.servo.profile ? entry.servo.profile->byRole(Role::Moving) : nullptr;
    const auto moving = reg != nullptr ? entry.displayedRaw(*reg) : std::nullopt;
    if (!isFresh(entry, workbench.link(), workbench.now()))
        m_moving->setState(Tone::Quiet, tr("moving: unknown"));
    else if (reg == nullptr)
        m_moving->setState(Tone::Quiet, tr("no moving flag"));
    else if (!moving)
        m_moving->setState(Tone::Quiet, tr("moving: not read"));
    else
        m_moving->setState(*moving != 0 ? Tone::Accent : Tone::Quiet,
                           *moving != 0 ? tr("moving") : tr("stopped"));
}

/// Faults are known if the servo answers and the registers that report them have been read.
void OperateStatus::showAlarms(const session::ServoEntry& entry,
                               const session::Workbench& workbench)
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
            words += tr(" — cleared");
        if (alarm.count > 1)
            words += QStringLiteral(" × %1").arg(alarm.count);
        const QString first = locale().toString(alarm.firstSeen.time(), QLocale::LongFormat);
        QString more =
            tr("First seen at %1 · %n occurrence(s)", nullptr, int(alarm.count)).arg(first);
        if (alarm.what.derived)
            more += QLatin1Char('\n') +
                    tr("Derived from the limits because this servo does not report alarms");
        m_alarms[i]->setState(alarm.active ? Tone::Bad : Tone::Warn, words, {}, more);
    }
    m_noAlarm->setVisible(alarms.empty());
    const bool judged =
        isFresh(entry, workbench.link(), workbench.now()) && faultsRead(entry.servo);
    m_noAlarm->setState(
        Tone::Quiet, judged ? tr("no alarm") : tr("alarms: –"), {},
        !judged ? tr("Unknown: the servo does not reply, or its alarm status has not been read")
        : reportsFaults(entry.servo)
            ? QString()
            : tr("Derived from the limits because this servo does not report alarms"));
    m_acknowledge->setVisible(!alarms.empty());
}

void OperateStatus::showAge(const session::ServoEntry& entry, const session::Workbench& workbench)
{
    const session::PollRate rate = workbench.polling().pollRate(entry.ref);
    if (!rate.lastAt) {
        m_age->setText(tr("not read yet"));
        return;
    }
    const base::Duration now = workbench.now();
    const bool open = workbench.link().state() == session::LinkState::Open;
    if (open && entry.ref == m_ageOf && now - m_ageShownAt < ageInterval)
        return;
    m_ageOf = entry.ref;
    m_ageShownAt = now;
    const base::Duration age = now - *rate.lastAt;
    QString words = age < ageInterval
                        ? tr("%1 Hz").arg(qRound(rate.hz))
                        : tr("updated %1 ago · %2 Hz").arg(spanText(age)).arg(qRound(rate.hz));
    if (rate.missed > 0)
        words += tr(" · missed: %1").arg(rate.missed);
    m_age->setText(words);
}

void OperateStatus::retranslate()
{
    m_ageOf = 0; // worded anew
    setButtonText(m_acknowledge, tr("Acknowledge"),
                  tr("Removes cleared alarms from this list; active alarms stay"));
    m_age->setToolTip(tr("Age of the latest value and number of readings in the last second"));
    m_age->setAccessibleName(tr("Data age and reading rate"));
    setAccessText(m_gauges, tr("Gauges"), tr("Shows or hides the gauges"));
}
} // namespace ui
