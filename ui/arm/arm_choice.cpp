// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/arm/arm_choice.h"

#include "session/arm/arm_calibration.h"
#include "session/settings.h"
#include "ui/arm/arm_dialog.h"
#include "ui/common/file_dialog.h"
#include "ui/common/follow_language.h"
#include "ui/common/widget_text.h"

#include <QComboBox>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QPushButton>

#include <utility>

namespace ui {
namespace {
const QString armSetting = QStringLiteral("arm/arm");
}

ArmChoice::ArmChoice(session::ArmCalibration& calibration, session::Settings& settings,
                     QWidget* parent)
    : QWidget(parent)
    , m_calibration(calibration)
    , m_settings(settings)
    , m_key(jobs::builtInArms().front())
    , m_arms(new QComboBox(this))
    , m_edit(new QPushButton(this))
{
    m_arms->setObjectName(QStringLiteral("armChoice"));
    m_edit->setObjectName(QStringLiteral("armEdit"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins({});
    row->addWidget(m_arms);
    row->addWidget(m_edit);
    connect(m_arms, &QComboBox::activated, this, &ArmChoice::choose);
    connect(m_edit, &QPushButton::clicked, this, &ArmChoice::edit);
    followLanguage(this, [this] { retranslate(); });
}

void ArmChoice::setChangeable(bool isChangeable)
{
    m_arms->setEnabled(isChangeable);
    m_edit->setEnabled(isChangeable);
}

void ArmChoice::loadLast()
{
    const QString last = m_settings.pageValue(armSetting, m_key).toString();
    auto arm = jobs::loadArm(last);
    if (!arm)
        return Q_EMIT failed(arm.error());
    m_key = last;
    m_calibration.setArm(std::move(*arm));
    fill();
}

void ArmChoice::load(const QString& nameOrPath)
{
    auto arm = jobs::loadArm(nameOrPath);
    if (!arm)
        return Q_EMIT failed(arm.error());
    m_calibration.setArm(std::move(*arm));
    m_key = nameOrPath;
    m_settings.setPageValue(armSetting, m_key);
    fill();
    Q_EMIT loaded();
}

/// The built-in arms, that of the user's file, and what asks for another one.
void ArmChoice::fill()
{
    m_arms->clear();
    for (const QString& name : jobs::builtInArms())
        m_arms->addItem(jobs::loadArm(name).value_or(jobs::Arm()).name, name);
    if (!isBuiltIn()) {
        const QString& name = m_calibration.arm().name;
        const QString file = QFileInfo(m_key).fileName();
        m_arms->addItem(name.isEmpty() ? file : QStringLiteral("%1 (%2)").arg(name, file), m_key);
    }
    m_arms->addItem(tr("From file…"), QString());
    m_arms->addItem(tr("New arm…"), QString());
    showChosen();
}

void ArmChoice::showChosen()
{
    m_arms->setCurrentIndex(m_arms->findData(m_key));
}

void ArmChoice::choose(int index)
{
    const QString name = m_arms->itemData(index).toString();
    if (!name.isEmpty())
        return load(name);
    showChosen(); // the choice stays until a file has been loaded or saved
    if (index == m_arms->count() - 1)
        return openEditor({}, {});
    askForFile(this,
               {.objectName = QStringLiteral("armChoiceDialog"),
                .title = tr("Select the file with the arm"),
                .filters = {tr("Robot arms (*.json)")},
                .settings = &m_settings,
                .folderKey = QStringLiteral("arm/folder")},
               [this](const QString& path) { load(path); });
}

void ArmChoice::edit()
{
    openEditor(m_calibration.arm(), isBuiltIn() ? QString() : m_key);
}

void ArmChoice::openEditor(const jobs::Arm& arm, const QString& path)
{
    auto* dialog = new ArmDialog(arm, path, m_settings, this);
    connect(dialog, &ArmDialog::saved, this, &ArmChoice::load);
    dialog->open();
}

void ArmChoice::retranslate()
{
    fill();
    setAccessText(m_arms, tr("Arm"), tr("Selects which joints the arm has"));
    setButtonText(m_edit, tr("Edit…"),
                  tr("Changes the joints of the arm and saves them to a file"));
}
} // namespace ui
