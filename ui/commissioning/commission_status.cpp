// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/commissioning/commission_status.h"

#include "report/commission_text.h"
#include "text/language.h"
#include "ui/common/theme.h"
#include "ui/common/widget_style.h"
#include "ui/common/widget_text.h"
#include "ui/widgets/press_guard.h"
#include "ui/widgets/step_strip.h"

#include <QDir>
#include <QEvent>
#include <QFileInfo>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace ui {
using jobs::CommissionAnswer;
using jobs::CommissionStep;

namespace {
constexpr double headlineScale = 1.4;
constexpr int headlineLines = 2; ///< room for the longest one
} // namespace

CommissionStatus::CommissionStatus(session::Commissioning& commissioning,
                                   const session::SearchService& search, QWidget* parent)
    : QWidget(parent)
    , m_commissioning(commissioning)
    , m_search(search)
{
    build();
    retranslate();
}

void CommissionStatus::build()
{
    auto* column = new QVBoxLayout(this);
    column->setSpacing(8);
    const auto label = [this](const char* name) {
        auto* made = new QLabel(this);
        made->setObjectName(QString::fromLatin1(name));
        made->setWordWrap(true);
        return made;
    };
    m_headline = label("commissionHeadline");
    QFont large = m_headline->font();
    large.setPointSizeF(large.pointSizeF() * headlineScale);
    large.setBold(true);
    m_headline->setFont(large);
    m_headline->setFixedHeight(headlineLines * QFontMetrics(large).lineSpacing());
    m_detail = label("commissionDetail");
    m_saved = label("commissionSaved");
    m_saved->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred); // a path is one word
    for (QLabel* one : {m_detail, m_saved})
        one->setTextInteractionFlags(Qt::TextSelectableByMouse);
    auto* answers = new QHBoxLayout;
    const auto button = [&](const char* name, CommissionAnswer answer) {
        auto* made = new QPushButton(this);
        made->setObjectName(QString::fromLatin1(name));
        connect(made, &QPushButton::clicked, this,
                [this, answer] { m_commissioning.submitAnswer(answer); });
        return made;
    };
    m_continue = button("commissionContinue", CommissionAnswer::Continue);
    makeMainAction(m_continue);
    m_same = button("commissionSame", CommissionAnswer::SameServo);
    m_aside = button("commissionAside", CommissionAnswer::Skip);
    answers->addWidget(m_same); // first: it is not always there, and must not move the others
    answers->addWidget(m_aside);
    answers->addWidget(m_continue);
    QSizePolicy policy = m_continue->sizePolicy(); // the widgets below it keep their place
    policy.setRetainSizeWhenHidden(true);
    m_continue->setSizePolicy(policy);
    for (QWidget* writer : {m_continue, m_same})
        new PressGuard(writer);
    m_steps = new StepStrip(this);
    m_steps->setObjectName(QStringLiteral("commissionSteps"));
    auto* top = new QHBoxLayout;
    top->setSpacing(12);
    top->addWidget(m_headline, 1);
    top->addLayout(answers);
    column->addLayout(top);
    column->addWidget(m_steps);
    column->addWidget(m_detail);
    column->addWidget(m_saved);
    makeCard(this);
}

int CommissionStatus::stepNumber() const
{
    if (!m_commissioning.isRunning())
        return -1;
    switch (m_commissioning.view().step) {
    case CommissionStep::Waiting:
    case CommissionStep::Blocked:
        return 0;
    case CommissionStep::Checking:
        return 1;
    case CommissionStep::Confirm:
    case CommissionStep::Snapshot:
    case CommissionStep::Template:
    case CommissionStep::Id:
    case CommissionStep::Rate:
    case CommissionStep::Center:
        return 2;
    case CommissionStep::Health:
        return 3;
    case CommissionStep::Unplug:
        break;
    }
    return 4;
}

QString CommissionStatus::headline() const
{
    const jobs::CommissionView& view = m_commissioning.view();
    if (!m_commissioning.isRunning())
        return m_hasEnded ? tr("Commissioning has ended") : tr("One servo at a time");
    switch (view.step) {
    case CommissionStep::Waiting:
        if (view.obstacle == jobs::CommissionObstacle::Lost)
            return tr("Connect the same servo again");
        return tr("Connect the next servo");
    case CommissionStep::Blocked:
        if (view.obstacle == jobs::CommissionObstacle::DuplicateId)
            return tr("Several servos are replying: disconnect all but one");
        if (view.obstacle == jobs::CommissionObstacle::DuplicateIds)
            return tr("Two servos with the same ID: disconnect one");
        return tr("A servo is replying but cannot be identified");
    case CommissionStep::Confirm:
        return tr("Set up as ID %1?").arg(view.newId);
    case CommissionStep::Unplug:
        return view.newId < 0 ? tr("Disconnect the servo")
                              : tr("Disconnect the servo: ID %1 is done").arg(view.newId);
    case CommissionStep::Checking:
        return tr("Checking the bus…");
    default:
        return tr("Setting up ID %1…").arg(view.newId);
    }
}

/// Which servos are unfinished, and how they are finished.
QString CommissionStatus::unfinishedText() const
{
    QStringList servos;
    for (const results::PendingCommission& one : m_commissioning.batch().pending) {
        const auto known = results::unfinishedIssues(one);
        servos << tr("%1 for ID %2").arg(one.servo.model).arg(one.newId);
        if (!known.empty())
            servos.back() +=
                QStringLiteral(" (⚠ %1)").arg(text::localized(report::commissionIssuesText(known)));
    }
    return tr("Unfinished: %1. To finish setting up a servo, connect it and start the same batch "
              "again.")
        .arg(text::joinItems(servos));
}

/// Asks whether the connected servo is the unfinished one.
QString CommissionStatus::pendingQuestionText() const
{
    const jobs::CommissionView& view = m_commissioning.view();
    if (view.isResumed)
        return tr("This batch contains an unfinished servo of the same model. Continue only if it "
                  "is the one that is connected now.");
    if (view.candidateId < 0)
        return {};
    if (view.candidateId == view.newId)
        return tr("One servo of this model is still unfinished, and no IDs are left for other "
                  "servos. If it is the one that is connected now, click \"%1\".")
            .arg(m_same->text());
    return tr("One servo of this model is still unfinished; its assigned ID is %1. If it is the "
              "one that is connected now, click \"%2\"; otherwise, the connected servo will be set "
              "up as a new one.")
        .arg(view.candidateId)
        .arg(m_same->text());
}

QString CommissionStatus::stoppedDetail() const
{
    if (!m_hasEnded)
        return tr(
            "Connect one servo at a time. Each servo receives the template, an ID and the baud "
            "rate; it is then checked and recorded in the batch. The servos do not move.");
    if (!m_commissioning.batch().pending.empty())
        return unfinishedText();
    return m_search.isSearching()
               ? tr("The servos in the list have changed. Searching the bus again.")
               : tr("Connect all servos to the bus, then search the bus to see them.");
}

/// The label of a servo that is done, or which servo it is.
QString CommissionStatus::servoText() const
{
    const jobs::CommissionView& view = m_commissioning.view();
    const std::vector<results::CommissionRow>& rows = m_commissioning.batch().rows;
    const bool done = view.step == CommissionStep::Unplug && view.newId >= 0;
    if (done && !rows.empty() && rows.back().newId == view.newId)
        return tr("Label: %1").arg(rows.back().label);
    if (view.servo.model.isEmpty())
        return {};
    return view.baud > 0
               ? tr("%1, ID %2 at %3 baud").arg(view.servo.model).arg(view.servo.id).arg(view.baud)
               : tr("%1, ID %2").arg(view.servo.model).arg(view.servo.id);
}

QString CommissionStatus::detail() const
{
    if (!m_commissioning.isRunning())
        return stoppedDetail();
    const jobs::CommissionView& view = m_commissioning.view();
    QStringList parts{servoText()};
    for (const jobs::DetectedServo& one : view.detected)
        parts.append(tr("%1 with ID %2, %3 baud")
                         .arg(one.model.isEmpty() ? tr("unidentified servo") : one.model)
                         .arg(one.place.id)
                         .arg(one.place.baud));
    if (view.step == CommissionStep::Waiting && view.newId >= 0)
        parts.append(tr("The servo will get ID %1.").arg(view.newId));
    if (view.step == CommissionStep::Confirm)
        parts.append(pendingQuestionText());
    else if (view.isResumed)
        parts.append(tr("Setup of this servo was interrupted earlier and is now being finished."));
    if (!view.issues.empty())
        parts.append(QStringLiteral("⚠ ") +
                     text::localized(report::commissionIssuesText(view.issues)));
    parts.removeAll(QString());
    return parts.join(QStringLiteral(" · "));
}

void CommissionStatus::show(bool hasEnded)
{
    m_hasEnded = hasEnded;
    showView();
}

void CommissionStatus::showView()
{
    const jobs::CommissionView& view = m_commissioning.view();
    m_headline->setText(headline());
    m_headline->setAccessibleName(m_headline->text());
    m_detail->setText(detail());
    m_steps->setCurrent(stepNumber());
    showSavedTable();
    showHeadlineTone();
    const bool confirm = m_commissioning.isRunning() && view.step == CommissionStep::Confirm;
    const bool begins = confirm && !m_continue->isVisible();
    setButtonText(m_continue, tr("Set ID %1").arg(view.newId),
                  tr("Saves the memory table, then writes the template, ID and baud rate"));
    m_continue->setVisible(confirm && view.newId != view.candidateId);
    m_aside->setVisible(confirm);
    m_same->setVisible(confirm && view.candidateId >= 0);
    if (begins && isVisible())
        m_continue->setFocus(); // the servo can be confirmed with one key
}

void CommissionStatus::showSavedTable()
{
    const QString saved = m_commissioning.isRunning() ? m_commissioning.view().snapshot : QString();
    const QFileInfo file(saved);
    m_saved->setText(tr("Memory table saved before the first write: %1 in %2")
                         .arg(file.fileName(), QDir::toNativeSeparators(file.path())));
    m_saved->setToolTip(QDir::toNativeSeparators(saved));
    m_saved->setVisible(!saved.isEmpty());
}

void CommissionStatus::showHeadlineTone()
{
    const jobs::CommissionView& view = m_commissioning.view();
    QPalette colors;
    if (m_commissioning.isRunning() && view.step == CommissionStep::Blocked)
        colors.setColor(QPalette::WindowText, tone(Tone::Warn, palette()));
    if (m_commissioning.isRunning() && view.step == CommissionStep::Unplug && view.newId >= 0)
        colors.setColor(QPalette::WindowText, tone(Tone::Good, palette()));
    m_headline->setPalette(colors);
}

void CommissionStatus::retranslate()
{
    m_steps->setSteps({tr("Connect"), tr("Identify"), tr("Write"), tr("Check"), tr("Unplug")});
    setButtonText(m_same, tr("Resume setup"),
                  tr("Confirms that this is the unfinished servo, and sets its assigned ID"));
    setButtonText(m_aside, tr("Set aside"),
                  tr("Writes nothing to this servo and records it in the batch as set aside"));
    showView();
}

void CommissionStatus::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (m_aside == nullptr)
        return;
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    else if (event->type() == QEvent::PaletteChange)
        showHeadlineTone();
}
} // namespace ui
