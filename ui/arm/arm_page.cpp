// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/arm/arm_page.h"

#include "text/error_text.h"
#include "ui/arm/arm_file_card.h"
#include "ui/arm/arm_model.h"
#include "ui/arm/joint_range_delegate.h"
#include "ui/common/file_dialog.h"
#include "ui/common/follow_language.h"
#include "ui/common/widget_style.h"
#include "ui/common/widget_text.h"
#include "ui/widgets/banner.h"
#include "ui/widgets/question_dialog.h"
#include "ui/widgets/tone_delegate.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableView>
#include <QVBoxLayout>

#include <algorithm>

namespace ui {
namespace {
using session::ArmCalibration;
using session::ArmJoint;
using Step = ArmCalibration::Step;

constexpr int minRangeWidth = 120;

bool isDone(const jobs::ApplyResult& result)
{
    return result.verdict == jobs::ApplyVerdict::Done ||
           result.verdict == jobs::ApplyVerdict::AlreadySet;
}
} // namespace

ArmPage::ArmPage(AppContext& context, session::Settings& settings, QWidget* parent)
    : QWidget(parent)
    , m_workbench(context.workbench)
    , m_calibration(context.workbench.armCalibration())
    , m_settings(settings)
    , m_model(new ArmModel(context.workbench, this))
    , m_banner(new Banner(this))
    , m_title(new QLabel(this))
    , m_arm(new QComboBox(this))
    , m_isMiddleShown(new QCheckBox(this))
    , m_cancel(new QPushButton(this))
    , m_action(new QPushButton(this))
    , m_instruction(new QLabel(this))
    , m_table(new QTableView(this))
    , m_file(new ArmFileCard(context.workbench, settings, this))
{
    setObjectName(QStringLiteral("armPage"));
    m_banner->hideMessage();
    auto* column = new QVBoxLayout(this);
    column->addWidget(m_banner);
    column->addWidget(buildJoints(), 1);
    column->addWidget(m_file);
    connect(&m_calibration, &ArmCalibration::changed, this, &ArmPage::update);
    connect(&m_calibration, &ArmCalibration::written, this, &ArmPage::showResults);
    const auto showError = [this](const base::Error& error) { m_banner->showMessage(error); };
    connect(&m_calibration, &ArmCalibration::failed, this, showError);
    connect(m_file, &ArmFileCard::failed, this, showError);
    connect(m_file, &ArmFileCard::saved, this, [this](const QString& path) {
        m_banner->showMessage([path] {
            return BannerText{Tone::Good, tr("Saved: %1").arg(QDir::toNativeSeparators(path))};
        });
    });
    connect(m_arm, &QComboBox::activated, this, &ArmPage::chooseArm);
    connect(m_action, &QPushButton::clicked, this, &ArmPage::runAction);
    connect(m_cancel, &QPushButton::clicked, &m_calibration, &ArmCalibration::cancel);
    followLanguage(this, [this] { retranslate(); });
}

QWidget* ArmPage::buildJoints()
{
    auto* card = new QWidget(this);
    makeHeading(m_title);
    m_arm->setObjectName(QStringLiteral("armChoice"));
    m_isMiddleShown->setObjectName(QStringLiteral("armMiddleShown"));
    m_cancel->setObjectName(QStringLiteral("armCancel"));
    m_action->setObjectName(QStringLiteral("armAction"));
    makeMainAction(m_action);
    m_instruction->setObjectName(QStringLiteral("armInstruction"));
    m_instruction->setWordWrap(true);
    m_table->setObjectName(QStringLiteral("armTable"));
    m_table->setModel(m_model);
    m_table->setSelectionMode(QAbstractItemView::NoSelection);
    m_table->setFocusPolicy(Qt::NoFocus);
    m_table->setFrameShape(QFrame::NoFrame);
    m_table->setItemDelegate(new ToneDelegate(m_table));
    m_table->setItemDelegateForColumn(ArmModel::RangeColumn, new JointRangeDelegate(m_table));
    styleTable(m_table);
    QHeaderView* header = m_table->horizontalHeader();
    header->setSectionResizeMode(QHeaderView::ResizeToContents);
    header->setSectionResizeMode(ArmModel::RangeColumn, QHeaderView::Stretch);
    header->setMinimumSectionSize(60);
    m_table->setMinimumWidth(minRangeWidth);
    auto* head = new QHBoxLayout;
    head->addWidget(m_title);
    head->addWidget(m_arm);
    head->addStretch(1);
    head->addWidget(m_isMiddleShown);
    head->addWidget(m_cancel);
    head->addWidget(m_action);
    auto* column = new QVBoxLayout(card);
    column->addLayout(head);
    column->addWidget(m_instruction);
    column->addWidget(m_table, 1);
    makeCard(card);
    return card;
}

void ArmPage::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    update();
}

/// The last entry asks for a file.
void ArmPage::chooseArm(int index)
{
    const QString name = m_arm->itemData(index).toString();
    if (!name.isEmpty())
        return loadArm(name);
    update(); // the choice stays until a file has been loaded
    askForFile(this,
               {.objectName = QStringLiteral("armChoiceDialog"),
                .title = tr("Select the file with the arm"),
                .filters = {tr("Robot arms (*.json)")},
                .settings = &m_settings,
                .folderKey = QStringLiteral("arm/folder")},
               [this](const QString& path) { loadArm(path); });
}

void ArmPage::loadArm(const QString& path)
{
    auto arm = jobs::loadArm(path);
    if (!arm)
        return m_banner->showMessage(arm.error());
    m_banner->hideMessage();
    m_calibration.setArm(std::move(*arm));
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
        break;
    }
}

void ArmPage::askToRecord()
{
    ask(this,
        {.title = tr("Turn torque off?"),
         .text = tr("The joints are then moved by hand while their positions are recorded. Nothing "
                    "else is written."),
         .risk = tr("The arm drops when torque goes off: hold it."),
         .acceptText = tr("Torque off"),
         .guard = this},
        [this] {
            m_banner->hideMessage();
            m_calibration.startRecording();
        });
}

void ArmPage::askToWrite()
{
    std::vector<ArmJoint> planned;
    for (const ArmJoint& one : m_calibration.joints()) {
        if (one.planned)
            planned.push_back(one);
    }
    const int count = static_cast<int>(planned.size());
    QStringList text{tr("The memory tables are saved first, and every value is read back. Torque "
                        "stays off.")};
    text << armSettingsLines(m_workbench, planned);
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
            return BannerText{Tone::Good, tr("Offset and limits of %n joint(s) written and read "
                                             "back.",
                                             nullptr, count)};
        const auto words = error ? std::optional(text::describe(*error)) : std::nullopt;
        return BannerText{
            Tone::Bad,
            tr("Not all joints could be written: ID %1").arg(failed.join(QStringLiteral(", "))),
            words ? words->message : QString(),
            words ? words->remedy : tr("Calibrate these joints again.")};
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
    }
    const QStringList missing = missingJoints();
    if (!missing.isEmpty())
        return tr("Not in the list of servos: %1. Search the bus, or select another arm.")
            .arg(missing.join(QStringLiteral(", ")));
    return tr("Hold the arm and turn its torque off, then move every joint through its range. The "
              "middle of each range becomes 2048, and its ends become the limits.");
}

void ArmPage::update()
{
    if (!isVisible())
        return;
    m_calibration.readUnread();
    m_model->update();
    m_file->update();
    m_instruction->setText(instruction());
    const Step step = m_calibration.step();
    const auto& joints = m_calibration.joints();
    const bool isPlanned = std::any_of(joints.begin(), joints.end(),
                                       [](const ArmJoint& one) { return one.planned.has_value(); });
    m_action->setEnabled(step == Step::Recording ||
                         (m_calibration.canStart() && (step == Step::Idle || isPlanned)));
    m_cancel->setVisible(step == Step::Recording || step == Step::Recorded);
    m_isMiddleShown->setVisible(step == Step::Idle || step == Step::Recording);
    m_arm->setEnabled(!m_calibration.isBusy());
    const int known = m_arm->findText(m_calibration.arm().name);
    m_arm->setCurrentIndex(known >= 0 ? known : m_arm->count() - 1);
    switch (step) {
    case Step::Idle:
        setButtonText(m_action, tr("Record ranges…"),
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
    m_arm->clear();
    for (const QString& name : jobs::builtInArms())
        m_arm->addItem(jobs::loadArm(name).value_or(jobs::Arm()).name, name);
    m_arm->addItem(tr("From file…"), QString());
    setAccessText(m_arm, tr("Arm"), tr("Selects which joints the arm has"));
    setButtonText(m_isMiddleShown, tr("Last pose is the middle"),
                  tr("Uses the pose in which you click Continue as the middle, instead of the "
                     "middle of each range"));
    setButtonText(m_cancel, tr("Cancel"),
                  tr("Ends the calibration; the servos keep their offsets and limits"));
    setAccessText(m_table, tr("Joints"), tr("One row per joint of the arm"));
    update();
}
} // namespace ui
