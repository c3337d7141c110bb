// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tasks/firmware_file_row.h"

#include "text/translate.h"
#include "ui/common/file_dialog.h"
#include "ui/common/widget_text.h"

#include <QDir>
#include <QEvent>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

namespace ui {
using text::translate;

FirmwareFileRow::FirmwareFileRow(session::Settings& settings, QWidget* parent)
    : QWidget(parent)
    , m_settings(settings)
    , m_name(new QLabel(this))
    , m_choose(new QPushButton(this))
{
    m_name->setObjectName(QStringLiteral("firmwareFile"));
    m_name->setTextFormat(Qt::PlainText);
    m_name->setWordWrap(true);
    m_choose->setObjectName(QStringLiteral("firmwareChoose"));
    m_choose->setAutoDefault(false);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(m_name, 1);
    row->addWidget(m_choose);
    connect(m_choose, &QPushButton::clicked, this, &FirmwareFileRow::choose);
    retranslate();
}

void FirmwareFileRow::choose()
{
    askForFile(this,
               {.objectName = QStringLiteral("firmwareFileDialog"),
                .title = translate("ServoTasks", "Select the firmware file"),
                .filters = {translate("ServoTasks", "Firmware for bus servos (*.bin)"),
                            translate("ServoTasks", "All files (*)")},
                .settings = &m_settings,
                .folderKey = QStringLiteral("firmware/folder")},
               [this](const QString& path) { load(path); });
}

void FirmwareFileRow::load(const QString& path)
{
    auto file = jobs::loadFirmwareFile(path);
    m_file.reset();
    if (file)
        m_file = std::move(*file);
    retranslate();
    Q_EMIT changed();
    if (!file)
        Q_EMIT failed(file.error());
}

void FirmwareFileRow::retranslate()
{
    m_name->setText(m_file ? QFileInfo(m_file->path).fileName()
                           : translate("ServoTasks", "No file selected."));
    m_name->setToolTip(m_file ? QDir::toNativeSeparators(m_file->path) : QString());
    setButtonText(m_choose, translate("ServoTasks", "Select file…"),
                  translate("ServoTasks", "Selects the vendor's firmware file, *.bin"));
}

void FirmwareFileRow::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
}
} // namespace ui
