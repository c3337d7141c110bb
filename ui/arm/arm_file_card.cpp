// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/arm/arm_file_card.h"

#include "ui/arm/arm_model.h"
#include "ui/common/file_dialog.h"
#include "ui/common/follow_language.h"
#include "ui/common/theme.h"
#include "ui/common/widget_style.h"
#include "ui/common/widget_text.h"
#include "ui/widgets/question_dialog.h"

#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace ui {
namespace {
using session::ArmJoint;
using Field = int jobs::JointCalibration::*;

QString folderKey()
{
    return QStringLiteral("arm/folder");
}

void setTone(QLabel* label, Tone tone)
{
    QPalette colors = label->palette();
    colors.setColor(QPalette::WindowText, ui::tone(tone, label->window()->palette()));
    label->setPalette(colors);
}
} // namespace

ArmFileCard::ArmFileCard(session::Workbench& workbench, session::Settings& settings,
                         QWidget* parent)
    : QWidget(parent)
    , m_workbench(workbench)
    , m_calibration(workbench.armCalibration())
    , m_settings(settings)
    , m_title(new QLabel(this))
    , m_state(new QLabel(this))
    , m_details(new QLabel(this))
    , m_select(new QPushButton(this))
    , m_apply(new QPushButton(this))
    , m_save(new QPushButton(this))
{
    setObjectName(QStringLiteral("armFileCard"));
    build();
    connect(m_select, &QPushButton::clicked, this, &ArmFileCard::select);
    connect(m_apply, &QPushButton::clicked, this, &ArmFileCard::askToApply);
    connect(m_save, &QPushButton::clicked, this, &ArmFileCard::save);
    followLanguage(this, [this] { retranslate(); });
}

void ArmFileCard::build()
{
    makeHeading(m_title);
    m_state->setObjectName(QStringLiteral("armFileState"));
    m_state->setWordWrap(true);
    m_details->setObjectName(QStringLiteral("armFileDetails"));
    m_details->setWordWrap(true);
    m_details->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_select->setObjectName(QStringLiteral("armFileSelect"));
    m_apply->setObjectName(QStringLiteral("armFileApply"));
    m_save->setObjectName(QStringLiteral("armFileSave"));
    auto* head = new QHBoxLayout;
    head->addWidget(m_title, 1);
    for (QPushButton* button : {m_select, m_apply, m_save})
        head->addWidget(button);
    auto* column = new QVBoxLayout(this);
    column->addLayout(head);
    column->addWidget(m_state);
    column->addWidget(m_details);
    makeCard(this);
}

void ArmFileCard::retranslate()
{
    m_title->setText(tr("LeRobot calibration file"));
    setButtonText(m_select, tr("Compare with file…"),
                  tr("Selects a calibration file and compares it with the servos"));
    setButtonText(m_apply, tr("Write file to servos…"),
                  tr("Writes offsets and limits of the file to the servos"));
    setButtonText(m_save, tr("Save servos to file…"),
                  tr("Saves what the servos hold as a calibration file"));
    update();
}

void ArmFileCard::update()
{
    const std::vector<jobs::LerobotJoint> held = m_calibration.heldAsFile();
    const bool isHeld = !held.empty() && held.size() == m_calibration.joints().size();
    const QStringList lines = differences();
    m_state->setText(stateText());
    if (m_path.isEmpty())
        m_state->setPalette({});
    else
        setTone(m_state, isHeld && lines.isEmpty() ? Tone::Good : Tone::Warn);
    m_details->setText(lines.join(QLatin1Char('\n')));
    m_details->setVisible(!lines.isEmpty());
    m_save->setEnabled(isHeld && !m_calibration.isBusy());
    m_apply->setEnabled(isHeld && !lines.isEmpty() && hasEveryJoint() && m_calibration.canStart());
}

QString ArmFileCard::stateText() const
{
    if (m_path.isEmpty())
        return tr("LeRobot accepts its file only if it equals what the servos hold. Select the "
                  "file to compare it.");
    const QString name = QFileInfo(m_path).fileName();
    const std::vector<jobs::LerobotJoint> held = m_calibration.heldAsFile();
    if (held.size() != m_calibration.joints().size())
        return tr("%1: cannot be compared before all servos have been read.").arg(name);
    return differences().isEmpty()
               ? tr("✓ %1 equals the servos.").arg(name)
               : tr("! %1 differs from the servos: LeRobot would ask for a new calibration.")
                     .arg(name);
}

bool ArmFileCard::hasEveryJoint() const
{
    const auto& joints = m_calibration.joints();
    return std::all_of(joints.begin(), joints.end(), [this](const ArmJoint& one) {
        const jobs::LerobotJoint* saved = m_file.find(one.joint.name);
        return saved != nullptr && saved->id == one.joint.id;
    });
}

QStringList ArmFileCard::differences() const
{
    QStringList lines;
    if (m_path.isEmpty())
        return lines;
    for (const ArmJoint& one : m_calibration.joints()) {
        const jobs::LerobotJoint* saved = m_file.find(one.joint.name);
        if (saved == nullptr || saved->id != one.joint.id) {
            lines << tr("%1: not in the file with ID %2").arg(one.joint.name).arg(one.joint.id);
            continue;
        }
        const auto compare = [&](const QString& name, Field field) {
            if (one.held && (*one.held).*field != saved->calibration.*field)
                lines << tr("%1: %2 is %3 in the file, %4 in the servo")
                             .arg(one.joint.name, name)
                             .arg(saved->calibration.*field)
                             .arg((*one.held).*field);
        };
        compare(tr("offset"), &jobs::JointCalibration::homingOffset);
        compare(tr("minimum"), &jobs::JointCalibration::rangeMin);
        compare(tr("maximum"), &jobs::JointCalibration::rangeMax);
    }
    for (const jobs::LerobotJoint& saved : m_file.joints) {
        const auto& joints = m_calibration.joints();
        const bool isOurs = std::any_of(joints.begin(), joints.end(), [&](const ArmJoint& one) {
            return one.joint.name == saved.name;
        });
        if (!isOurs)
            lines << tr("%1: not a joint of this arm").arg(saved.name);
    }
    return lines;
}

/// Proposes a file of LeRobot's, if there is one; the user selects.
void ArmFileCard::select()
{
    const QStringList known = jobs::findLerobotFiles();
    askForFile(this,
               {.objectName = QStringLiteral("armFileDialog"),
                .title = tr("Select the calibration file"),
                .filters = {tr("Calibration files (*.json)")},
                .fileName = m_path.isEmpty() && !known.isEmpty() ? known.front() : m_path,
                .settings = &m_settings,
                .folderKey = folderKey()},
               [this](const QString& path) { load(path); });
}

void ArmFileCard::load(const QString& path)
{
    auto file = jobs::loadLerobotFile(path);
    if (!file)
        return Q_EMIT failed(file.error());
    m_path = path;
    m_file = std::move(*file);
    update();
}

void ArmFileCard::askToApply()
{
    ask(this,
        {.title = tr("Write %1 to the servos?").arg(QFileInfo(m_path).fileName()),
         .text = (differences() + armSettingsLines(m_workbench, m_calibration.joints()))
                     .join(QLatin1Char('\n')),
         .risk = tr("Torque is turned off: hold the arm. Offsets shift the zero positions."),
         .acceptText = tr("Write to servos"),
         .guard = this},
        [this] { m_calibration.writeFile(m_file.joints); });
}

void ArmFileCard::save()
{
    askForSavePath(this,
                   {.objectName = QStringLiteral("armFileSaveDialog"),
                    .title = tr("Save the calibration"),
                    .filters = {tr("Calibration files (*.json)")},
                    .fileName = m_path.isEmpty() ? QStringLiteral("arm.json") : m_path,
                    .settings = &m_settings,
                    .folderKey = folderKey()},
                   [this](const QString& path) { saveTo(path); });
}

void ArmFileCard::saveTo(const QString& path)
{
    const auto file = jobs::lerobotFileFor(path, m_calibration.heldAsFile());
    if (!file)
        return Q_EMIT failed(file.error());
    if (const auto done = jobs::saveLerobotFile(*file, path); !done)
        return Q_EMIT failed(done.error());
    load(path);
    Q_EMIT saved(path);
}
} // namespace ui
