// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/commissioning/commission_form.h"

#include "session/commission/commissioning.h"
#include "text/language.h"
#include "ui/common/file_dialog.h"
#include "ui/common/follow_language.h"
#include "ui/common/widget_text.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSpinBox>
#include <QToolButton>

namespace ui {
namespace {
const QString firstIdKey = QStringLiteral("commission/first_id");
const QString lastIdKey = QStringLiteral("commission/last_id");
const QString rateKey = QStringLiteral("commission/rate");
const QString centerKey = QStringLiteral("commission/center");
const QString labelKey = QStringLiteral("commission/label");
const QString batchKey = QStringLiteral("commission/batch");
const QString templateKey = QStringLiteral("commission/template");

/// Pasted by mistake; no system has such file names.
bool hasControlCharacter(const QString& path)
{
    return std::any_of(path.begin(), path.end(),
                       [](QChar one) { return one.category() == QChar::Other_Control; });
}

/// Keeps the room of a hidden widget in a QFormLayout, which ignores the size policy for that.
QWidget* fixedHeightRow(QWidget* widget)
{
    QSizePolicy policy = widget->sizePolicy();
    policy.setRetainSizeWhenHidden(true);
    widget->setSizePolicy(policy);
    auto* room = new QWidget(widget->parentWidget());
    auto* column = new QVBoxLayout(room);
    column->setContentsMargins({});
    column->addWidget(widget);
    return room;
}
} // namespace

CommissionForm::CommissionForm(session::Settings& settings, QWidget* parent)
    : QWidget(parent)
    , m_settings(settings)
{
    build();
    load();
    connectAll();
    followLanguage(this, [this] { retranslate(); });
}

QWidget* CommissionForm::pathField(QLineEdit*& edit, QToolButton*& browse, const char* name)
{
    auto* box = new QWidget(this);
    auto* row = new QHBoxLayout(box);
    row->setContentsMargins({});
    row->setSpacing(2);
    edit = new QLineEdit(box);
    edit->setObjectName(QString::fromLatin1(name));
    edit->setClearButtonEnabled(true);
    browse = new QToolButton(box);
    browse->setObjectName(QString::fromLatin1(name) + QStringLiteral("Browse"));
    browse->setText(QStringLiteral("…"));
    row->addWidget(edit, 1);
    row->addWidget(browse);
    return box;
}

void CommissionForm::build()
{
    m_form = new QFormLayout(this);
    m_form->setContentsMargins({});
    m_form->setRowWrapPolicy(QFormLayout::WrapLongRows);
    const auto row = [this](QWidget* field) { m_form->addRow(new QLabel(this), field); };
    const auto number = [this](const char* name) {
        auto* spin = new QSpinBox(this);
        spin->setObjectName(QString::fromLatin1(name));
        spin->setRange(0, 253);
        return spin;
    };
    const auto check = [this](const char* name) {
        auto* box = new QCheckBox(this);
        box->setObjectName(QString::fromLatin1(name));
        return box;
    };
    row(pathField(m_batch, m_browseBatch, "commissionBatch"));
    row(pathField(m_template, m_browseTemplate, "commissionTemplate"));
    row(m_firstId = number("commissionFirstId"));
    row(m_lastId = number("commissionLastId"));
    m_rate = new QComboBox(this);
    m_rate->setObjectName(QStringLiteral("commissionRate"));
    m_rate->addItem(QString(), 0);
    for (const int baud : session::standardBaudRates())
        m_rate->addItem(results::rateLabel(baud), baud);
    row(m_rate);
    m_label = new QLineEdit(this);
    m_label->setObjectName(QStringLiteral("commissionLabel"));
    row(m_label);
    m_form->addRow(m_center = check("commissionCenter"));
    m_form->addRow(m_automatic = check("commissionAutomatic"));
    m_dangerous = check("commissionDangerous");
    m_dangerous->hide();
    m_form->addRow(fixedHeightRow(m_dangerous));
}

void CommissionForm::load()
{
    const auto number = [this](const QString& key, int defaultValue) {
        return m_settings.pageValue(key, defaultValue).toInt();
    };
    m_firstId->setValue(number(firstIdKey, 1));
    m_lastId->setValue(number(lastIdKey, 253));
    m_rate->setCurrentIndex(std::max(0, m_rate->findData(number(rateKey, 0))));
    m_center->setChecked(m_settings.pageValue(centerKey, false).toBool());
    m_label->setText(m_settings.pageValue(labelKey, results::defaultLabelFormat()).toString());
    m_batch->setText(m_settings.pageValue(batchKey, QString()).toString());
    if (m_batch->text().isEmpty())
        m_batch->setText(session::defaultBatchPath(QDate::currentDate()));
    m_template->setText(m_settings.pageValue(templateKey, QString()).toString());
}

/// Without the choice to set up without confirmation: that is made anew each time the program is
/// started.
void CommissionForm::save()
{
    m_settings.setPageValue(firstIdKey, m_firstId->value());
    m_settings.setPageValue(lastIdKey, m_lastId->value());
    m_settings.setPageValue(rateKey, m_rate->currentData().toInt());
    m_settings.setPageValue(centerKey, m_center->isChecked());
    m_settings.setPageValue(labelKey, m_label->text());
    m_settings.setPageValue(batchKey, m_batch->text());
    m_settings.setPageValue(templateKey, m_template->text());
}

void CommissionForm::connectAll()
{
    for (QLineEdit* edit : {m_batch, m_template}) {
        connect(edit, &QLineEdit::textChanged, this, &CommissionForm::filesChanged);
        connect(edit, &QLineEdit::textChanged, this, &CommissionForm::changed);
    }
    for (QSpinBox* spin : {m_firstId, m_lastId})
        connect(spin, &QSpinBox::valueChanged, this, &CommissionForm::changed);
    connect(m_browseBatch, &QToolButton::clicked, this, &CommissionForm::chooseBatch);
    connect(m_browseTemplate, &QToolButton::clicked, this, &CommissionForm::chooseTemplate);
}

void CommissionForm::chooseTemplate()
{
    askForFile(this,
               {QStringLiteral("commissionTemplateDialog"),
                tr("Template"),
                {tr("Snapshots and templates (*.json)"), tr("All files (*)")}},
               [this](const QString& path) { m_template->setText(path); });
}

void CommissionForm::chooseBatch()
{
    FileRequest request{
        QStringLiteral("commissionBatchDialog"), tr("Batch"), {tr("Batch files (*.csv)")}};
    request.asksBeforeOverwrite = false; // an existing batch is continued
    askForSavePath(this, request, [this](const QString& path) { m_batch->setText(path); });
}

QString CommissionForm::batchPath() const
{
    return m_batch->text();
}

QString CommissionForm::templatePath() const
{
    return m_template->text();
}

bool CommissionForm::arePathsValid() const
{
    return !hasControlCharacter(m_batch->text()) && !hasControlCharacter(m_template->text());
}

QString CommissionForm::pathProblem() const
{
    if (m_batch->text().isEmpty())
        return tr("Specify the batch file.");
    if (!arePathsValid())
        return tr("The file name contains a character that is not allowed.");
    return {};
}

QString CommissionForm::idProblem() const
{
    return m_firstId->value() > m_lastId->value()
               ? tr("The last ID must not be lower than the first ID.")
               : QString();
}

void CommissionForm::setDangerousKeys(const QStringList& keys)
{
    m_dangerousKeys = keys;
    m_dangerous->setVisible(!keys.isEmpty());
    showDangerousKeys();
}

void CommissionForm::showDangerousKeys()
{
    m_dangerous->setToolTip(
        tr("A wrong value in these rows can make a servo unreachable or dangerous: %1")
            .arg(text::joinItems(m_dangerousKeys)));
}

bool CommissionForm::isDangerousIncluded() const
{
    return !m_dangerousKeys.isEmpty() && m_dangerous->isChecked();
}

jobs::CommissionSpec CommissionForm::spec() const
{
    jobs::CommissionSpec spec;
    for (int id = m_firstId->value(); id <= m_lastId->value(); ++id)
        spec.ids.push_back(id);
    spec.baud = m_rate->currentData().toInt();
    spec.center = m_center->isChecked();
    spec.automatic = m_automatic->isChecked();
    if (isDangerousIncluded())
        spec.consent = device::Consent::confirmed();
    spec.labelFormat = m_label->text();
    return spec;
}

void CommissionForm::retranslate()
{
    const auto field = [this](QWidget* part, QWidget* control, const QString& name,
                              const QString& tip) {
        if (auto* label = qobject_cast<QLabel*>(m_form->labelForField(part)))
            label->setText(name);
        setAccessText(control, name, tip);
    };
    field(m_batch->parentWidget(), m_batch, tr("Batch"),
          tr("Batch file (CSV); an existing batch is resumed"));
    field(m_template->parentWidget(), m_template, tr("Template"),
          tr("Snapshot or template written to every servo; leave empty for none"));
    field(m_firstId, m_firstId, tr("First ID"),
          tr("ID of the first servo; each later servo gets the next ID"));
    field(m_lastId, m_lastId, tr("Last ID"),
          tr("Commissioning ends when this ID has been assigned"));
    field(m_rate, m_rate, tr("Baud rate"), tr("Baud rate to set on every servo"));
    field(
        m_label, m_label, tr("Label"),
        tr("Label text, with placeholders: {model} {id} {rate} {baud} {firmware} {date} {was_id}"));
    const QString browseBatch = tr("Select the batch file");
    setAccessText(m_browseBatch, browseBatch, browseBatch);
    const QString browseTemplate = tr("Select the template");
    setAccessText(m_browseTemplate, browseTemplate, browseTemplate);
    m_rate->setItemText(0, tr("Unchanged"));
    setButtonText(m_center, tr("Set the present position as the midpoint"),
                  tr("Only for servos with a command to set the midpoint; move the horn to the "
                     "midpoint first"));
    setButtonText(m_automatic, tr("Set up without confirmation"),
                  tr("Sets up each servo without asking; servos with an alarm or another problem "
                     "are set aside"));
    m_dangerous->setText(tr("Include the template's dangerous rows"));
    m_dangerous->setAccessibleName(m_dangerous->text());
    showDangerousKeys();
}
} // namespace ui
