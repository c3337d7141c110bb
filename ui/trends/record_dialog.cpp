// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/trends/record_dialog.h"

#include "ui/common/theme.h"

#include <QCheckBox>
#include <QDateTime>
#include <QDir>
#include <QEvent>
#include <QFileDialog>
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
const QString folderKey = QStringLiteral("trend/record_folder");
const QString shownOnlyKey = QStringLiteral("trend/record_shown");
const QString secondsKey = QStringLiteral("trend/record_seconds");
constexpr int maxSeconds = 7 * 24 * 3600;
constexpr int defaultSeconds = 10;
constexpr int pathChars = 44;

QString defaultFolder()
{
    const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    return QDir(documents).exists() ? documents : QDir::homePath();
}
} // namespace

RecordDialog::RecordDialog(session::Settings& settings, QWidget* parent)
    : QDialog(parent)
    , m_settings(settings)
{
    setObjectName(QStringLiteral("recordDialog"));
    setAttribute(Qt::WA_DeleteOnClose);
    build();
    const QDir folder(m_settings.pageValue(folderKey, defaultFolder()).toString());
    const QString name = QDateTime::currentDateTime().toString(QStringLiteral("yyyy-MM-dd_HHmmss"));
    m_path->setText(
        QDir::toNativeSeparators(folder.filePath(QStringLiteral("servodesk_%1.csv").arg(name))));
    (m_settings.pageValue(shownOnlyKey, true).toBool() ? m_shown : m_all)->setChecked(true);
    const int seconds = m_settings.pageValue(secondsKey, 0).toInt();
    m_limited->setChecked(seconds > 0);
    m_seconds->setValue(seconds > 0 ? seconds : defaultSeconds);
    m_seconds->setEnabled(seconds > 0);
    retranslate();
}

void RecordDialog::build()
{
    auto* column = new QVBoxLayout(this);
    m_form = new QFormLayout;
    const auto named = [](auto* widget, const char* name) {
        widget->setObjectName(QString::fromLatin1(name));
        return widget;
    };
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
    m_error = named(new QLabel(this), "recordTrouble");
    m_error->setWordWrap(true);
    m_error->hide();
    m_form->addRow(new QLabel(this), file);
    m_form->addRow(new QLabel(this), m_shown);
    m_form->addRow(new QLabel(this), m_all);
    m_form->addRow(new QLabel(this), length);
    auto* buttons = new QHBoxLayout;
    m_start = named(new QPushButton(this), "recordStart");
    m_start->setProperty("mainAction", true);
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

RecordRequest RecordDialog::request() const
{
    return {QDir::fromNativeSeparators(m_path->text().trimmed()), m_shown->isChecked(),
            m_limited->isChecked() ? m_seconds->value() : 0};
}

void RecordDialog::start()
{
    const RecordRequest now = request();
    if (now.path.isEmpty()) {
        showError(tr("Name a file first."));
        return;
    }
    if (QFileInfo(now.path).isFile() && now.path != m_confirmedPath) {
        m_confirmedPath = now.path;
        showError(tr("There is such a file already. Press Record once more to replace it, or give "
                     "another name."));
        return;
    }
    m_settings.setPageValue(folderKey, QFileInfo(now.path).absolutePath());
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
    const QString csv = tr("Table, for spreadsheets (*.csv)");
    const QString lines = tr("JSON lines, for programs (*.jsonl)");
    auto* dialog = new QFileDialog(this, tr("Record to"));
    dialog->setObjectName(QStringLiteral("recordFileDialog"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setNameFilters({csv, lines});
    dialog->setDefaultSuffix(QStringLiteral("csv"));
    dialog->selectFile(request().path);
    connect(dialog, &QFileDialog::filterSelected, dialog, [dialog, lines](const QString& filter) {
        dialog->setDefaultSuffix(filter == lines ? QStringLiteral("jsonl") : QStringLiteral("csv"));
    });
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& path) {
        m_path->setText(QDir::toNativeSeparators(path));
        m_confirmedPath = request().path; // the file dialog has asked
    });
    dialog->open();
}

void RecordDialog::retranslate()
{
    setWindowTitle(tr("Record"));
    const auto words = [](auto* widget, const QString& text, const QString& tip) {
        widget->setText(text);
        widget->setAccessibleName(text);
        widget->setToolTip(tip);
    };
    static_cast<QLabel*>(m_form->itemAt(0, QFormLayout::LabelRole)->widget())->setText(tr("File"));
    m_path->setAccessibleName(tr("File"));
    m_path->setToolTip(tr("*.csv: a table; *.jsonl: one JSON object a line"));
    words(m_browse, tr("Choose…"), tr("Choose folder and name"));
    words(m_shown, tr("The curves of the chart"), tr("Only what is shown is written"));
    words(m_all, tr("Everything that is read"), tr("Also what the chart does not show"));
    words(m_limited, tr("End by itself after"), tr("Otherwise it goes on until it is stopped"));
    m_seconds->setSuffix(tr(" s"));
    m_seconds->setAccessibleName(tr("Length"));
    m_seconds->setToolTip(tr("Seconds from the first row"));
    words(m_start, tr("Record"), tr("Begin now"));
    words(m_cancel, tr("Cancel"), tr("Record nothing"));
}

void RecordDialog::changeEvent(QEvent* event)
{
    QDialog::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
}
} // namespace ui
