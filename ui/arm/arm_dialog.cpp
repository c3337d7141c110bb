// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/arm/arm_dialog.h"

#include "text/error_text.h"
#include "ui/common/dialog_sizes.h"
#include "ui/common/file_dialog.h"
#include "ui/common/follow_language.h"
#include "ui/common/theme.h"
#include "ui/common/widget_style.h"
#include "ui/common/widget_text.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSet>
#include <QSignalBlocker>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <array>

namespace ui {
namespace {
using base::JointKind;

constexpr int dialogWidth = 620;
constexpr int dialogHeight = 520;
enum JointColumn { NameColumn, IdColumn, ModelColumn, KindColumn, ReversedColumn, jointColumns };

constexpr std::array kinds{JointKind::Limited, JointKind::Continuous, JointKind::Gripper,
                           JointKind::Wheel};

QString kindText(JointKind kind)
{
    switch (kind) {
    case JointKind::Limited:
        return ArmDialog::tr("between two stops");
    case JointKind::Continuous:
        return ArmDialog::tr("continuous");
    case JointKind::Gripper:
        return ArmDialog::tr("gripper");
    case JointKind::Wheel:
        return ArmDialog::tr("wheel");
    }
    return {};
}

QComboBox* kindBox(const QTableWidget* table, int row)
{
    return qobject_cast<QComboBox*>(table->cellWidget(row, KindColumn));
}

void setKinds(QComboBox* box)
{
    const int current = std::max(0, box->currentIndex());
    box->clear();
    for (const JointKind kind : kinds)
        box->addItem(kindText(kind), static_cast<int>(kind));
    box->setCurrentIndex(current);
}
} // namespace

ArmDialog::ArmDialog(const jobs::Arm& arm, const QString& path, session::Settings& settings,
                     QWidget* parent)
    : QDialog(parent)
    , m_settings(settings)
    , m_path(path)
    , m_isNew(arm.joints.empty())
    , m_summary(new QLabel(this))
    , m_name(new QLineEdit(this))
    , m_isLeader(new QCheckBox(this))
    , m_table(new QTableWidget(0, jointColumns, this))
    , m_add(new QPushButton(this))
    , m_remove(new QPushButton(this))
    , m_problem(new QLabel(this))
    , m_form(new QFormLayout)
    , m_buttons(new QDialogButtonBox(QDialogButtonBox::Save | QDialogButtonBox::Cancel, this))
{
    setObjectName(QStringLiteral("armDialog"));
    rememberSize(*this);
    setAttribute(Qt::WA_DeleteOnClose);
    build();
    fill(arm);
    m_remove->setEnabled(false);
    connect(m_name, &QLineEdit::textChanged, this, &ArmDialog::update);
    connect(m_table, &QTableWidget::itemChanged, this, &ArmDialog::update);
    // Also while a row is being removed, when its cells are gone already.
    connect(m_table, &QTableWidget::itemSelectionChanged, this,
            [this] { m_remove->setEnabled(m_table->selectionModel()->hasSelection()); });
    connect(m_add, &QPushButton::clicked, this, &ArmDialog::addNext);
    connect(m_remove, &QPushButton::clicked, this, &ArmDialog::removeSelected);
    connect(m_buttons, &QDialogButtonBox::accepted, this, &ArmDialog::save);
    connect(m_buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    followLanguage(this, [this] { retranslate(); });
    resize(dialogWidth, dialogHeight);
}

void ArmDialog::build()
{
    m_summary->setWordWrap(true);
    m_name->setObjectName(QStringLiteral("armDialogName"));
    m_form->addRow(new QLabel(this), m_name);
    m_isLeader->setObjectName(QStringLiteral("armDialogLeader"));
    m_form->addRow(m_isLeader);
    m_table->setObjectName(QStringLiteral("armDialogTable"));
    m_table->setEditTriggers(QAbstractItemView::AllEditTriggers);
    styleTable(m_table);
    QHeaderView* header = m_table->horizontalHeader();
    header->setSectionResizeMode(QHeaderView::ResizeToContents);
    header->setSectionResizeMode(NameColumn, QHeaderView::Stretch);
    m_add->setObjectName(QStringLiteral("armDialogAdd"));
    m_remove->setObjectName(QStringLiteral("armDialogRemove"));
    m_problem->setObjectName(QStringLiteral("armDialogProblem"));
    m_problem->setWordWrap(true);
    QPushButton* save = m_buttons->button(QDialogButtonBox::Save);
    save->setObjectName(QStringLiteral("armDialogSave"));
    makeMainAction(save);
    auto* edit = new QHBoxLayout;
    edit->addWidget(m_add);
    edit->addWidget(m_remove);
    edit->addStretch(1);
    auto* column = new QVBoxLayout(this);
    column->addWidget(m_summary);
    column->addLayout(m_form);
    column->addWidget(m_table, 1);
    column->addLayout(edit);
    column->addWidget(m_problem);
    column->addWidget(m_buttons);
}

void ArmDialog::fill(const jobs::Arm& arm)
{
    m_name->setText(arm.name);
    m_isLeader->setChecked(arm.isLeader);
    for (const jobs::Joint& joint : arm.joints)
        addJoint(joint);
}

void ArmDialog::addJoint(const jobs::Joint& joint)
{
    const QSignalBlocker block(m_table); // until the row is complete
    const int row = m_table->rowCount();
    m_table->insertRow(row);
    m_table->setItem(row, NameColumn, new QTableWidgetItem(joint.name));
    m_table->setItem(row, ModelColumn, new QTableWidgetItem(joint.model));
    auto* id = new QTableWidgetItem;
    id->setData(Qt::EditRole, joint.id); // a number: edited in a spin box
    m_table->setItem(row, IdColumn, id);
    auto* kind = new QComboBox(m_table);
    setKinds(kind);
    kind->setCurrentIndex(kind->findData(static_cast<int>(joint.kind)));
    m_table->setCellWidget(row, KindColumn, kind);
    auto* reversed = new QTableWidgetItem;
    reversed->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
    reversed->setCheckState(joint.isReversed ? Qt::Checked : Qt::Unchecked);
    m_table->setItem(row, ReversedColumn, reversed);
}

/// With the next free ID, ready for its name.
void ArmDialog::addNext()
{
    jobs::Joint joint;
    for (const jobs::Joint& one : arm().joints)
        joint.id = std::max(joint.id, one.id);
    joint.id = std::min(joint.id + 1, jobs::maxJointId);
    addJoint(joint);
    retranslate();
    m_table->setCurrentCell(m_table->rowCount() - 1, NameColumn);
    m_table->editItem(m_table->currentItem());
}

void ArmDialog::removeSelected()
{
    QSet<int> rows;
    for (const QModelIndex& index : m_table->selectionModel()->selectedRows())
        rows << index.row();
    for (int row = m_table->rowCount() - 1; row >= 0; --row) {
        if (rows.contains(row))
            m_table->removeRow(row);
    }
    update();
}

jobs::Arm ArmDialog::arm() const
{
    jobs::Arm arm;
    arm.name = m_name->text().trimmed();
    arm.isLeader = m_isLeader->isChecked();
    for (int row = 0; row < m_table->rowCount(); ++row) {
        jobs::Joint joint;
        joint.name = m_table->item(row, NameColumn)->text().trimmed();
        joint.id = m_table->item(row, IdColumn)->data(Qt::EditRole).toInt();
        joint.model = m_table->item(row, ModelColumn)->text().trimmed();
        const QComboBox* kind = kindBox(m_table, row);
        joint.kind = kinds[static_cast<std::size_t>(std::max(0, kind->currentIndex()))];
        joint.isReversed = m_table->item(row, ReversedColumn)->checkState() == Qt::Checked;
        arm.joints.push_back(std::move(joint));
    }
    return arm;
}

QString ArmDialog::problem() const
{
    const jobs::Arm edited = arm();
    QSet<QString> names;
    QSet<int> ids;
    for (const jobs::Joint& joint : edited.joints) {
        if (joint.name.isEmpty())
            return tr("The joint with ID %1 has no name.").arg(joint.id);
        if (joint.id < 0 || joint.id > jobs::maxJointId)
            return tr("%1: an ID is a number from 0 to 253.").arg(joint.name);
        if (names.contains(joint.name))
            return tr("Two joints have the name %1.").arg(joint.name);
        if (ids.contains(joint.id))
            return tr("Two joints have the ID %1.").arg(joint.id);
        names << joint.name;
        ids << joint.id;
    }
    return edited.joints.empty() ? tr("The arm has no joints.") : QString();
}

void ArmDialog::save()
{
    askForSavePath(this,
                   {.objectName = QStringLiteral("armDialogSaveDialog"),
                    .title = tr("Save the arm"),
                    .filters = {tr("Robot arms (*.json)")},
                    .fileName = m_path.isEmpty() ? QStringLiteral("my-arm.json") : m_path,
                    .settings = &m_settings,
                    .folderKey = QStringLiteral("arm/folder")},
                   [this](const QString& path) { saveTo(path); });
}

void ArmDialog::saveTo(const QString& path)
{
    if (const auto done = jobs::saveArm(arm(), path); !done) {
        const auto words = text::describe(done.error());
        m_problem->setText(words.message + QLatin1Char(' ') + words.remedy);
        return m_problem->show();
    }
    Q_EMIT saved(path);
    accept();
}

void ArmDialog::update()
{
    const QString why = problem();
    m_problem->setText(why);
    m_problem->setVisible(!why.isEmpty());
    m_buttons->button(QDialogButtonBox::Save)->setEnabled(why.isEmpty());
}

void ArmDialog::retranslate()
{
    setWindowTitle(m_isNew ? tr("New arm") : tr("Edit arm"));
    m_summary->setText(tr("The joints of the arm, each with the ID of its servo. Names are those "
                          "of LeRobot's calibration file. Reversed joints turn the other way in "
                          "LeRobot (drive_mode); no register changes."));
    setFieldText(m_form, m_name, tr("Arm"), tr("Shown in the list of arms"));
    setButtonText(m_isLeader, tr("Leader: moved by hand only"),
                  tr("LeRobot sets neither gains nor gripper limits of a leader"));
    m_table->setHorizontalHeaderLabels(
        {tr("Joint"), tr("ID"), tr("Model"), tr("Kind"), tr("Reversed")});
    setAccessText(m_table, tr("Joints"), tr("One row per joint; an empty model means any"));
    for (int row = 0; row < m_table->rowCount(); ++row) {
        QComboBox* kind = kindBox(m_table, row);
        setKinds(kind);
        kind->setAccessibleName(tr("Kind"));
    }
    setButtonText(m_add, tr("Add joint"), tr("Adds a joint with the next ID"));
    setButtonText(m_remove, tr("Remove"), tr("Removes the selected joints from the arm"));
    setButtonText(m_buttons->button(QDialogButtonBox::Save), tr("Save…"),
                  tr("Saves the arm to a file and selects it"));
    setButtonText(m_buttons->button(QDialogButtonBox::Cancel), tr("Cancel"),
                  tr("Closes without a change"));
    update();
}
} // namespace ui
