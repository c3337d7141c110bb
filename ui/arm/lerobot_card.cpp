// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/arm/lerobot_card.h"

#include "text/arm_text.h"
#include "text/language.h"
#include "ui/arm/arm_model.h"
#include "ui/common/file_dialog.h"
#include "ui/common/follow_language.h"
#include "ui/common/theme.h"
#include "ui/common/widget_style.h"
#include "ui/common/widget_text.h"
#include "ui/widgets/question_dialog.h"

#include <QEvent>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QVBoxLayout>

#include <algorithm>
#include <map>

namespace ui {
namespace {
using session::ArmJoint;

QString folderKey()
{
    return QStringLiteral("arm/folder");
}

/// As high as the texts in it where there is room for them; else they scroll.
class TextArea final : public QScrollArea {
public:
    TextArea(QWidget* texts, QWidget* parent)
        : QScrollArea(parent)
    {
        setWidget(texts);
        setWidgetResizable(true);
        setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
        setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Maximum);
        makeTransparent(this);
        connect(verticalScrollBar(), &QScrollBar::rangeChanged, this, [this](int, int last) {
            setFocusPolicy(last > 0 ? Qt::TabFocus : Qt::NoFocus); // for the arrow keys
        });
    }
    QSize sizeHint() const override
    {
        return {widget()->sizeHint().width(), widget()->heightForWidth(viewport()->width())};
    }
    QSize minimumSizeHint() const override
    {
        constexpr int minLines = 4;
        return {0, std::min(sizeHint().height(), minLines * fontMetrics().lineSpacing())};
    }

protected:
    bool eventFilter(QObject* object, QEvent* event) override
    {
        if (event->type() == QEvent::LayoutRequest || event->type() == QEvent::Resize)
            updateGeometry();
        return QScrollArea::eventFilter(object, event);
    }
};

void setTone(QLabel* label, Tone tone)
{
    QPalette colors = label->palette();
    colors.setColor(QPalette::WindowText, ui::tone(tone, label->window()->palette()));
    label->setPalette(colors);
}
} // namespace

LerobotCard::LerobotCard(session::Workbench& workbench, session::Settings& settings,
                         QWidget* parent)
    : QWidget(parent)
    , m_calibration(workbench.armCalibration())
    , m_settings(settings)
    , m_title(new QLabel(this))
    , m_remarks(new QLabel(this))
    , m_state(new QLabel(this))
    , m_details(new QLabel(this))
    , m_prepare(new QPushButton(this))
    , m_select(new QPushButton(this))
    , m_apply(new QPushButton(this))
    , m_save(new QPushButton(this))
{
    setObjectName(QStringLiteral("lerobotCard"));
    build();
    connect(m_prepare, &QPushButton::clicked, this, &LerobotCard::askToPrepare);
    connect(m_select, &QPushButton::clicked, this, &LerobotCard::select);
    connect(m_apply, &QPushButton::clicked, this, &LerobotCard::askToApply);
    connect(m_save, &QPushButton::clicked, this, &LerobotCard::save);
    followLanguage(this, [this] { retranslate(); });
}

void LerobotCard::build()
{
    makeHeading(m_title);
    m_remarks->setObjectName(QStringLiteral("armRemarks"));
    m_remarks->setWordWrap(true);
    m_prepare->setObjectName(QStringLiteral("armPrepare"));
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
    for (QPushButton* button : {m_prepare, m_select, m_apply, m_save})
        head->addWidget(button);
    auto* texts = new QWidget(this);
    auto* lines = new QVBoxLayout(texts);
    lines->setContentsMargins({});
    for (QLabel* label : {m_remarks, m_state, m_details})
        lines->addWidget(label);
    auto* column = new QVBoxLayout(this);
    column->addLayout(head);
    m_texts = new TextArea(texts, this);
    column->addWidget(m_texts);
    makeCard(this);
}

void LerobotCard::retranslate()
{
    m_title->setText(tr("LeRobot"));
    m_texts->setAccessibleName(m_title->text());
    setButtonText(m_prepare, tr("Prepare servos…"),
                  tr("Writes the settings that LeRobot writes at each start: mode, gains, reply "
                     "delay, gripper limits"));
    setButtonText(m_select, tr("Compare with file…"),
                  tr("Selects a calibration file and compares it with the servos"));
    setButtonText(m_apply, tr("Write file to servos…"),
                  tr("Writes offsets and limits of the file to the servos"));
    setButtonText(m_save, tr("Save servos to file…"),
                  tr("Saves what the servos hold as a calibration file"));
    update();
}

void LerobotCard::update()
{
    const std::vector<jobs::LerobotJoint> held = m_calibration.heldAsFile();
    const bool isHeld = !held.empty() && held.size() == m_calibration.joints().size();
    const QStringList lines = differences();
    const QString remarks = remarksText();
    m_remarks->setText(remarks);
    m_remarks->setVisible(!remarks.isEmpty());
    setTone(m_remarks, Tone::Warn);
    const bool canWrite =
        m_calibration.step() == session::ArmCalibration::Step::Idle && m_calibration.canStart();
    m_prepare->setEnabled(m_calibration.canPrepare());
    m_state->setText(stateText());
    if (m_path.isEmpty())
        m_state->setPalette({});
    else
        setTone(m_state, isHeld && lines.isEmpty() ? Tone::Good : Tone::Warn);
    m_details->setText(lines.join(QLatin1Char('\n')));
    m_details->setVisible(!lines.isEmpty());
    m_save->setEnabled(isHeld && !m_calibration.isBusy());
    m_apply->setEnabled(isHeld && !lines.isEmpty() && hasEveryJoint() && canWrite);
}

QString LerobotCard::stateText() const
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

bool LerobotCard::hasEveryJoint() const
{
    const auto& joints = m_calibration.joints();
    return std::all_of(joints.begin(), joints.end(), [this](const ArmJoint& one) {
        const jobs::LerobotJoint* saved = m_file.find(one.joint.name);
        return saved != nullptr && saved->id == one.joint.id;
    });
}

/// A joint that is not in the list stands there in its row.
QString LerobotCard::remarksText() const
{
    QStringList lines;
    QStringList others; // the table names their models
    const std::vector<base::ArmRemark> remarks = jobs::lerobotRemarks(m_calibration.jointServos());
    for (const base::ArmRemark& remark : remarks) {
        if (remark.kind == base::ArmRemarkKind::OtherModel)
            others << remark.joints;
    }
    if (others.size() > 1)
        lines << tr("! %1: LeRobot expects other models and refuses the bus. Fit those models, or "
                    "enter the present ones both in the arm and in LeRobot's code.")
                     .arg(text::joinItems(others));
    for (const base::ArmRemark& remark : remarks) {
        if (others.size() > 1 && remark.kind == base::ArmRemarkKind::OtherModel)
            continue;
        const QString text = QStringLiteral("! ") + text::armRemarkText(remark);
        if (remark.kind == base::ArmRemarkKind::OtherFirmware)
            lines << text + tr(" The Firmware page shows and updates them.");
        else if (remark.kind != base::ArmRemarkKind::NoReply)
            lines << text;
    }
    return lines.join(QLatin1Char('\n'));
}

QStringList LerobotCard::differences() const
{
    QStringList lines;
    if (m_path.isEmpty())
        return lines;
    const std::map<QString, QString> names{{QStringLiteral("homing_offset"), tr("offset")},
                                           {QStringLiteral("range_min"), tr("minimum")},
                                           {QStringLiteral("range_max"), tr("maximum")}};
    for (const jobs::CalibrationDifference& one :
         jobs::differences(m_calibration.jointServos(), m_file)) {
        const auto name = names.find(one.key);
        if (name == names.end())
            lines << (one.inServo
                          ? tr("%1: not in the file with ID %2").arg(one.joint).arg(*one.inServo)
                          : tr("%1: not a joint of this arm").arg(one.joint));
        else if (one.inServo)
            lines << tr("%1: %2 is %3 in the file, %4 in the servo")
                         .arg(one.joint, name->second)
                         .arg(one.inFile.value_or(0))
                         .arg(*one.inServo);
    }
    return lines;
}

/// Proposes a file of LeRobot's, if there is one; the user selects.
void LerobotCard::select()
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

void LerobotCard::load(const QString& path)
{
    auto file = jobs::loadLerobotFile(path);
    if (!file)
        return Q_EMIT failed(file.error());
    m_path = path;
    m_file = std::move(*file);
    update();
}

void LerobotCard::askToApply()
{
    ask(this,
        {.title = tr("Write %1 to the servos?").arg(QFileInfo(m_path).fileName()),
         .text = (differences() + positionChanges(m_calibration, false)).join(QLatin1Char('\n')),
         .risk = tr("Torque is turned off: hold the arm. Offsets shift the zero positions."),
         .acceptText = tr("Write to servos"),
         .guard = this},
        [this] { m_calibration.writeFile(m_file.joints); });
}

void LerobotCard::askToPrepare()
{
    ask(this,
        {.title = tr("Write LeRobot's settings to the servos?"),
         .text = lerobotChanges(m_calibration).join(QLatin1Char('\n')),
         .risk = tr("Torque is turned off: hold the arm."),
         .acceptText = tr("Write to servos"),
         .guard = this},
        [this] { m_calibration.prepare(); });
}

void LerobotCard::save()
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

void LerobotCard::saveTo(const QString& path)
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
