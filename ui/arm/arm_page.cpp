// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/arm/arm_page.h"

#include "text/arm_text.h"
#include "text/error_text.h"
#include "text/language.h"
#include "ui/arm/arm_choice.h"
#include "ui/arm/arm_model.h"
#include "ui/arm/joint_range_delegate.h"
#include "ui/arm/lerobot_card.h"
#include "ui/common/follow_language.h"
#include "ui/common/widget_style.h"
#include "ui/common/widget_text.h"
#include "ui/widgets/banner.h"
#include "ui/widgets/question_dialog.h"
#include "ui/widgets/tone_delegate.h"

#include <QCheckBox>
#include <QDir>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableView>
#include <QVBoxLayout>

#include <algorithm>

namespace ui {
namespace {
using catalog::Role;
using session::ArmCalibration;
using session::ArmJoint;
using Step = ArmCalibration::Step;

constexpr int minRangeWidth = 120;
constexpr std::chrono::milliseconds updateInterval{50};
constexpr std::chrono::seconds refreshInterval{1};
constexpr std::chrono::milliseconds pollPeriod{50};
constexpr int strongerTestTorque = 60; ///< %, for an arm that is heavy

/// Those that it has.
QStringList roleKeys(const catalog::Profile& profile, std::initializer_list<Role> roles)
{
    QStringList keys;
    for (const Role role : roles) {
        if (const catalog::Register* reg = profile.byRole(role))
            keys << reg->key;
    }
    return keys;
}

bool isDone(const jobs::ApplyResult& result)
{
    return result.verdict == jobs::ApplyVerdict::Done ||
           result.verdict == jobs::ApplyVerdict::AlreadySet;
}
} // namespace

ArmPage::ArmPage(AppContext& context, session::Settings& settings, QWidget* parent)
    : QWidget(parent)
    , m_workbench(context.workbench)
    , m_workbenchGuard(&context.workbench)
    , m_calibration(context.workbench.armCalibration())
    , m_model(new ArmModel(context.workbench, this))
    , m_banner(new Banner(this))
    , m_title(new QLabel(this))
    , m_arm(new ArmChoice(m_calibration, settings, this))
    , m_isMiddleShown(new QCheckBox(this))
    , m_test(new QPushButton(this))
    , m_cancel(new QPushButton(this))
    , m_action(new QPushButton(this))
    , m_instruction(new QLabel(this))
    , m_table(new QTableView(this))
    , m_lerobot(new LerobotCard(context.workbench, settings, this))
{
    setObjectName(QStringLiteral("armPage"));
    m_banner->hideMessage();
    auto* column = new QVBoxLayout(this);
    column->addWidget(m_banner);
    column->addWidget(buildJoints(), 1);
    column->addWidget(m_lerobot);
    connectAll();
    m_arm->loadLast();
    followLanguage(this, [this] { retranslate(); });
}

void ArmPage::connectAll()
{
    m_updateTimer.setSingleShot(true);
    m_updateTimer.setInterval(updateInterval);
    connect(&m_updateTimer, &QTimer::timeout, this, &ArmPage::update);
    m_refreshTimer.setInterval(refreshInterval);
    connect(&m_refreshTimer, &QTimer::timeout, m_model, &ArmModel::update);
    connect(&m_calibration, &ArmCalibration::changed, this, &ArmPage::updateSoon);
    connect(&m_calibration, &ArmCalibration::written, this, &ArmPage::showResults);
    connect(&m_calibration, &ArmCalibration::tested, this, &ArmPage::showTestResults);
    const auto showError = [this](const base::Error& error) { m_banner->showMessage(error); };
    connect(&m_calibration, &ArmCalibration::failed, this, showError);
    connect(m_lerobot, &LerobotCard::failed, this, showError);
    connect(m_lerobot, &LerobotCard::saved, this, [this](const QString& path) {
        m_banner->showMessage([path] {
            return BannerText{Tone::Good, tr("Saved: %1").arg(QDir::toNativeSeparators(path))};
        });
    });
    connect(m_arm, &ArmChoice::failed, this, showError);
    connect(m_arm, &ArmChoice::loaded, this, [this] {
        m_banner->hideMessage();
        update(); // its joints may be others
    });
    connect(m_test, &QPushButton::clicked, this, &ArmPage::askToTest);
    connect(m_action, &QPushButton::clicked, this, &ArmPage::runAction);
    connect(m_table->selectionModel(), &QItemSelectionModel::selectionChanged, this,
            &ArmPage::updateButtons);
    connect(m_cancel, &QPushButton::clicked, &m_calibration, &ArmCalibration::cancel);
}

QWidget* ArmPage::buildJoints()
{
    auto* card = new QWidget(this);
    makeHeading(m_title);
    m_isMiddleShown->setObjectName(QStringLiteral("armMiddleShown"));
    m_cancel->setObjectName(QStringLiteral("armCancel"));
    m_test->setObjectName(QStringLiteral("armTest"));
    m_action->setObjectName(QStringLiteral("armAction"));
    makeMainAction(m_action);
    m_instruction->setObjectName(QStringLiteral("armInstruction"));
    m_instruction->setWordWrap(true);
    m_table->setObjectName(QStringLiteral("armTable"));
    m_table->setModel(m_model);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_table->setFrameShape(QFrame::NoFrame);
    m_table->setItemDelegate(new ToneDelegate(m_table));
    m_table->setItemDelegateForColumn(ArmModel::RangeColumn, new JointRangeDelegate(m_table));
    styleTable(m_table);
    QHeaderView* header = m_table->horizontalHeader();
    header->setSectionResizeMode(QHeaderView::ResizeToContents);
    header->setSectionResizeMode(ArmModel::RangeColumn, QHeaderView::Stretch);
    header->setMinimumSectionSize(40);
    m_table->setMinimumWidth(minRangeWidth);
    auto* head = new QHBoxLayout;
    head->addWidget(m_title);
    head->addWidget(m_arm);
    head->addStretch(1);
    head->addWidget(m_test);
    head->addWidget(m_cancel);
    head->addWidget(m_action);
    auto* column = new QVBoxLayout(card);
    column->addLayout(head);
    auto* below = new QHBoxLayout;
    below->addWidget(m_instruction, 1);
    below->addWidget(m_isMiddleShown, 0, Qt::AlignTop);
    column->addLayout(below);
    column->addWidget(m_table, 1);
    makeCard(card);
    return card;
}

void ArmPage::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    m_refreshTimer.start();
    update();
}

void ArmPage::hideEvent(QHideEvent* event)
{
    QWidget::hideEvent(event);
    m_updateTimer.stop();
    m_refreshTimer.stop();
    updateSubscription();
}

/// The positions of the joints, and what calibrates them.
void ArmPage::updateSubscription()
{
    if (!m_workbenchGuard)
        return;
    session::Subscription subscription;
    subscription.period = pollPeriod;
    std::vector<session::ServoRef> polled;
    for (const ArmJoint& one : m_calibration.joints()) {
        const session::ServoEntry* entry = m_workbench.registry().servo(one.servo);
        if (!isVisible() || entry == nullptr || !entry->servo.profile)
            continue;
        polled.push_back(one.servo);
        subscription.parts.push_back(
            {one.servo, roleKeys(*entry->servo.profile, {Role::PresentPosition}),
             roleKeys(*entry->servo.profile,
                      {Role::PositionOffset, Role::MinAngle, Role::MaxAngle, Role::Lock})});
    }
    if (polled != std::exchange(m_polled, polled))
        m_workbench.polling().subscribe(QStringLiteral("arm"), subscription);
}

session::JointRows ArmPage::selectedRows() const
{
    session::JointRows rows;
    for (const QModelIndex& index : m_table->selectionModel()->selectedRows()) {
        const auto row = static_cast<std::size_t>(index.row());
        if (row < m_calibration.joints().size()) // the table follows a little later
            rows.push_back(row);
    }
    std::sort(rows.begin(), rows.end());
    return rows;
}

QString ArmPage::selectedNames() const
{
    QStringList names;
    for (const std::size_t row : selectedRows())
        names << m_calibration.joints()[row].joint.name;
    return names.isEmpty() ? QString()
                           : tr("Only the selected joints: %1.").arg(text::joinItems(names));
}

void ArmPage::runAction()
{
    switch (m_calibration.step()) {
    case Step::Idle:
        return askToRecord();
    case Step::Recording:
        return m_calibration.finishRecording(m_isMiddleShown->isChecked());
    case Step::Recorded:
        return askToWrite();
    case Step::Writing:
    case Step::Testing:
        break;
    }
}

void ArmPage::askToRecord()
{
    ask(this,
        {.title = tr("Turn torque off?"),
         .text = text::joinSentences(
             {selectedNames(), tr("The joints are then moved by hand while their positions are "
                                  "recorded. Nothing else is written.")}),
         .risk = tr("The arm drops when torque goes off: hold it."),
         .acceptText = tr("Torque off"),
         .guard = this},
        [this, rows = selectedRows()] {
            m_banner->hideMessage();
            m_calibration.startRecording(rows);
        });
}

void ArmPage::askToWrite()
{
    const int count = static_cast<int>(m_calibration.plannedRows().size());
    QStringList text{tr("The memory tables are saved first, and every value is read back. Torque "
                        "stays off.")};
    text << positionChanges(m_calibration, true);
    ask(this,
        {.title = tr("Write offset and limits of %n joint(s)?", nullptr, count),
         .text = text.join(QLatin1Char('\n')),
         .risk = tr("The offset shifts the zero position of a joint."),
         .acceptText = tr("Write to servos"),
         .guard = this},
        [this] { m_calibration.write(); });
}

void ArmPage::showResults(const std::vector<jobs::ApplyResult>& results)
{
    QStringList failed;
    std::optional<base::Error> error;
    for (const jobs::ApplyResult& one : results) {
        if (isDone(one))
            continue;
        failed << QString::number(one.id);
        error = error ? error : one.error;
    }
    const int count = static_cast<int>(results.size());
    m_banner->showMessage([failed, error, count] {
        if (failed.isEmpty())
            return BannerText{Tone::Good,
                              tr("%n joint(s) written and read back.", nullptr, count),
                              {},
                              tr("Undo takes back one joint at a time, the last one first.")};
        const auto words = error ? std::optional(text::describe(*error)) : std::nullopt;
        return BannerText{Tone::Bad,
                          tr("Not all joints could be written: ID %1").arg(text::joinItems(failed)),
                          words ? words->message : QString(),
                          words ? words->remedy : tr("Write these joints again.")};
    });
}

/// Of those that a test would move.
QStringList ArmPage::uncalibratedNames() const
{
    const std::vector<jobs::JointServo> all = m_calibration.jointServos();
    std::vector<jobs::JointServo> tested;
    for (const std::size_t row : m_calibration.movable(selectedRows()))
        tested.push_back(all[row]);
    return jobs::uncalibratedJoints(tested);
}

void ArmPage::askToTest()
{
    const auto start = [this, rows = selectedRows()](int torque) {
        m_banner->hideMessage();
        m_calibration.startMoveTest(torque, rows);
    };
    const auto moveText = [](int torque) { return tr("Move at %1 % torque").arg(torque); };
    const QStringList wide = uncalibratedNames();
    const QString warning =
        wide.isEmpty() ? QString()
                       : tr("Not calibrated, so these run into their mechanical stops: %1.")
                             .arg(text::joinItems(wide));
    ask(this,
        {.title = tr("Move the joints to their limits?"),
         .text = text::joinSentences(
             {selectedNames(),
              tr("One joint after the other turns torque on, moves slowly to both ends of "
                 "its limits and back, and turns torque off. With little torque a heavy "
                 "arm may not get there.")}),
         .risk = text::joinSentences({warning, tr("The arm moves: keep hands and objects away, and "
                                                  "hold what would drop.")}),
         .acceptText = moveText(jobs::defaultTestTorque),
         .alternativeText = moveText(strongerTestTorque),
         .alternativeToolTip = tr("For a heavy arm"),
         .alternativeAction = [start] { start(strongerTestTorque); },
         .guard = this},
        [start] { start(jobs::defaultTestTorque); });
}

void ArmPage::showTestResults(bool isComplete)
{
    using base::MoveTestState;
    QStringList notReached;
    QString endedBy;
    int reached = 0;
    MoveTestState end = MoveTestState::Reached;
    for (const ArmJoint& one : m_calibration.joints()) {
        if (!one.test)
            continue;
        if (one.test->state == MoveTestState::Reached) {
            ++reached;
        } else if (one.test->state == MoveTestState::NotReached) {
            notReached << one.joint.name;
        } else {
            endedBy = one.joint.name;
            end = one.test->state;
        }
    }
    if (!endedBy.isEmpty())
        return m_banner->showMessage([endedBy, end] {
            return BannerText{
                Tone::Bad, tr("%1: %2", "joint, result").arg(endedBy, text::moveTestStateText(end)),
                tr("The move test has ended there."), tr("Check the servo's alarms and supply.")};
        });
    if (!notReached.isEmpty())
        return m_banner->showMessage([notReached] {
            return BannerText{
                Tone::Bad, tr("Not at both ends: %1").arg(text::joinItems(notReached)),
                tr("Something is in the way, the limits are beyond a mechanical stop, or the "
                   "torque is too little."),
                tr("Clear the range and test again with more torque, or calibrate these joints "
                   "again.")};
        });
    if (reached > 0)
        m_banner->showMessage([reached, isComplete] {
            return BannerText{isComplete ? Tone::Good : Tone::Warn,
                              isComplete ? tr("%n joint(s) reached both ends.", nullptr, reached)
                                         : tr("Stopped after %n joint(s), which reached both ends.",
                                              nullptr, reached)};
        });
}

QStringList ArmPage::missingJoints() const
{
    QStringList missing;
    for (const ArmJoint& one : m_calibration.joints()) {
        if (one.servo == 0)
            missing << QStringLiteral("%1 (ID %2)").arg(one.joint.name).arg(one.joint.id);
    }
    return missing;
}

QString ArmPage::instruction() const
{
    switch (m_calibration.step()) {
    case Step::Idle:
        break;
    case Step::Recording:
        return tr("Torque is off. Move every joint from stop to stop, in any order. The encoder's "
                  "seam may lie anywhere in the range. Click Continue when every joint is "
                  "recorded.");
    case Step::Recorded:
        return tr("Nothing has been written yet. Check the new offsets and limits, then write them "
                  "to the servos. Joints that were not recorded stay as they are.");
    case Step::Writing:
        return tr("Writing…");
    case Step::Testing:
        return tr("The joints move one after the other. Esc turns torque off at once.");
    }
    const QStringList missing = missingJoints();
    if (!missing.isEmpty())
        return tr("Not in the list of servos: %1. Search the bus, or select another arm.")
            .arg(text::joinItems(missing));
    return tr(
        "Hold the arm and turn its torque off, then move every joint through its range. The "
        "middle of each range becomes 2048, and its ends become the limits. Select rows to record "
        "or test only these joints.");
}

void ArmPage::updateSoon()
{
    if (m_calibration.step() != m_shownStep)
        update();
    else if (!m_updateTimer.isActive())
        m_updateTimer.start();
}

void ArmPage::update()
{
    if (!isVisible())
        return;
    m_calibration.readUnread();
    updateSubscription();
    m_shownStep = m_calibration.step();
    m_model->update();
    m_lerobot->update();
    m_instruction->setText(instruction());
    m_arm->setChangeable(!m_calibration.isBusy());
    updateButtons();
}

void ArmPage::updateButtons()
{
    const Step step = m_calibration.step();
    const session::JointRows rows = selectedRows();
    const session::JointRows planned = m_calibration.plannedRows();
    const bool canStart = m_calibration.canStart(rows);
    m_action->setEnabled(step == Step::Recording || (step == Step::Idle && canStart) ||
                         (!planned.empty() && m_calibration.canStart(planned)));
    m_cancel->setVisible(step == Step::Recording || step == Step::Recorded ||
                         step == Step::Testing);
    m_isMiddleShown->setVisible(step == Step::Idle || step == Step::Recording);
    m_test->setVisible(step == Step::Idle);
    m_test->setEnabled(canStart);
    const int count = static_cast<int>(rows.size());
    setButtonText(m_test, count > 0 ? tr("Test %n joint(s)…", nullptr, count) : tr("Test moves…"),
                  tr("Moves the joints to both ends of their limits, slowly and with little "
                     "torque, after a question"));
    switch (step) {
    case Step::Idle:
    case Step::Testing:
        setButtonText(m_action,
                      count > 0 ? tr("Record %n joint(s)…", nullptr, count) : tr("Record ranges…"),
                      tr("Turns torque off after a question and records how far joints are moved"));
        break;
    case Step::Recording:
        setButtonText(m_action, tr("Continue"),
                      tr("Ends the recording and shows the new offsets and limits"));
        break;
    case Step::Recorded:
    case Step::Writing:
        setButtonText(m_action, tr("Write to servos…"),
                      tr("Writes the new offsets and limits after a question"));
        break;
    }
}

void ArmPage::retranslate()
{
    m_title->setText(tr("Arm"));
    m_model->retranslate();
    setButtonText(m_isMiddleShown, tr("Last pose is the middle"),
                  tr("Uses the pose in which you click Continue as the middle, instead of the "
                     "middle of each range"));
    setButtonText(m_cancel, tr("Cancel"),
                  tr("Ends the recording or the test; the servos keep their offsets and limits"));
    setAccessText(m_table, tr("Joints"),
                  tr("One row per joint of the arm; select rows to record or test only these"));
    update();
}
} // namespace ui
