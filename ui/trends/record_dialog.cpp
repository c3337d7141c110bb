// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/trends/record_dialog.h"

#include "ui/common/file_dialog.h"
#include "ui/common/follow_language.h"
#include "ui/common/theme.h"
#include "ui/common/widget_style.h"
#include "ui/common/widget_text.h"

#include <QCheckBox>
#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRadioButton>
#include <QSpinBox>
#include <QStandardPaths>
#include <QVBoxLayout>

namespace ui {
namespace {
const QString shownOnlyKey = QStringLiteral("trend/record_shown");
const QString secondsKey = QStringLiteral("trend/record_seconds");
constexpr int maxSeconds = 7 * 24 * 3600;
constexpr int defaultSeconds = 10;
constexpr int pathChars = 44;

template <typename Widget>
Widget* named(Widget* widget, const char* name)
{
    widget->setObjectName(QString::fromLatin1(name));
    return widget;
}
} // namespace

RecordDialog::RecordDialog(session::Settings& settings, QWidget* parent)
    : QDialog(parent)
    , m_settings(settings)
{
    setObjectName(QStringLiteral("recordDialog"));
    setAttribute(Qt::WA_DeleteOnClose);
    build();
    const QDir folder(rememberedFolder(m_settings, recordingFolderKey()));
    const QString name = QDateTime::currentDateTime().toString(QStringLiteral("yyyy-MM-dd_HHmmss"));
    // The ending that a double click opens here: packaging/linux/servodesk-mime.xml.
    m_path->setText(QDir::toNativeSeparators(
        folder.filePath(QStringLiteral("servodesk_%1.recording.csv").arg(name))));
    (m_settings.pageValue(shownOnlyKey, true).toBool() ? m_shown : m_all)->setChecked(true);
    const int seconds = m_settings.pageValue(secondsKey, 0).toInt();
    m_limited->setChecked(seconds > 0);
    m_seconds->setValue(seconds > 0 ? seconds : defaultSeconds);
    m_seconds->setEnabled(seconds > 0);
    followLanguage(this, [this] { retranslate(); });
}

void RecordDialog::build()
{
    auto* column = new QVBoxLayout(this);
    buildForm();
    m_error = named(new QLabel(this), "recordTrouble");
    m_error->setWordWrap(true);
    m_error->hide();
    auto* buttons = new QHBoxLayout;
    m_start = named(new QPushButton(this), "recordStart");
    makeMainAction(m_start);
    m_start->setDefault(true);
    m_cancel = named(new QPushButton(this), "recordCancel");
    buttons->addStretch();
    buttons->addWidget(m_cancel);
    buttons->addWidget(m_start);
    column->addLayout(m_form);
    column->addWidget(m_error);
    column->addLayout(buttons);
    connect(m_limited, &QCheckBox::toggled, m_seconds, &QWidget::setEnabled);
    connect(m_browse, &QPushButton::clicked, this, &RecordDialog::browse);
    connect(m_start, &QPushButton::clicked, this, &RecordDialog::start);
    connect(m_cancel, &QPushButton::clicked, this, &QDialog::close);
}

void RecordDialog::buildForm()
{
    m_form = new QFormLayout;
    m_path = named(new QLineEdit(this), "recordPath");
    m_path->setMinimumWidth(m_path->fontMetrics().averageCharWidth() * pathChars);
    m_browse = named(new QPushButton(this), "recordBrowse");
    m_browse->setAutoDefault(false);
    auto* file = new QHBoxLayout;
    file->addWidget(m_path, 1);
    file->addWidget(m_browse);
    m_shown = named(new QRadioButton(this), "recordShown");
    m_all = named(new QRadioButton(this), "recordAll");
    m_limited = named(new QCheckBox(this), "recordLimited");
    m_seconds = named(new QSpinBox(this), "recordSeconds");
    m_seconds->setRange(1, maxSeconds);
    auto* length = new QHBoxLayout;
    length->addWidget(m_limited);
    length->addWidget(m_seconds);
    length->addStretch();
    m_form->addRow(new QLabel(this), file);
    m_form->addRow(new QLabel(this), m_shown);
    m_form->addRow(new QLabel(this), m_all);
    m_form->addRow(new QLabel(this), length);
}

RecordRequest RecordDialog::request() const
{
    return {QDir::fromNativeSeparators(m_path->text().trimmed()), m_shown->isChecked(),
            m_limited->isChecked() ? m_seconds->value() : 0};
}

void RecordDialog::start()
{
    const RecordRequest now = request();
    if (now.path.isEmpty()) {
        showError(tr("Choose a file first."));
        return;
    }
    if (QFileInfo(now.path).isFile() && now.path != m_confirmedPath) {
        m_confirmedPath = now.path;
        showError(tr("This file already exists. Press Record again to replace it, or choose "
                     "another name."));
        return;
    }
    m_settings.setPageValue(recordingFolderKey(), QFileInfo(now.path).absolutePath());
    m_settings.setPageValue(shownOnlyKey, now.onlyShown);
    m_settings.setPageValue(secondsKey, now.seconds);
    Q_EMIT recordingRequested(now);
}

void RecordDialog::showError(const QString& words)
{
    m_error->setText(words);
    m_error->show();
    QPalette colors = palette();
    colors.setColor(QPalette::WindowText, tone(Tone::Bad, palette()));
    m_error->setPalette(colors);
}

void RecordDialog::browse()
{
    askForSavePath(this,
                   {QStringLiteral("recordFileDialog"),
                    tr("Record to"),
                    {tr("Table for spreadsheets (*.csv)"), tr("JSON Lines for programs (*.jsonl)")},
                    request().path},
                   [this](const QString& path) {
                       m_path->setText(QDir::toNativeSeparators(path));
                       m_confirmedPath = request().path; // the file dialog has asked
                   });
}

void RecordDialog::retranslate()
{
    setWindowTitle(tr("Record"));
    static_cast<QLabel*>(m_form->itemAt(0, QFormLayout::LabelRole)->widget())->setText(tr("File"));
    setAccessText(m_path, tr("File"), tr("*.csv: a table; *.jsonl: one JSON object per line"));
    setButtonText(m_browse, tr("Choose…"), tr("Opens a dialog to choose the folder and file name"));
    setButtonText(m_shown, tr("Channels shown in the chart"),
                  tr("Records only what the chart shows"));
    setButtonText(m_all, tr("All values that are read"),
                  tr("Includes values not shown in the chart"));
    setButtonText(m_limited, tr("Stop automatically after"),
                  tr("If not selected, recording continues until you stop it"));
    m_seconds->setSuffix(tr(" s"));
    setAccessText(m_seconds, tr("Duration"), tr("Duration in seconds from the first row"));
    setButtonText(m_start, tr("Record"), tr("Starts recording now"));
    setButtonText(m_cancel, tr("Cancel"), tr("Closes without recording"));
}
} // namespace ui
