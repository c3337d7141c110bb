// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/commissioning/commission_page.h"

#include "report/commission_text.h"
#include "text/language.h"
#include "ui/commissioning/commission_model.h"
#include "ui/widgets/banner.h"
#include "ui/widgets/question_dialog.h"
#include "ui/widgets/rate_text.h"

#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QDir>
#include <QEvent>
#include <QFileDialog>
#include <QGuiApplication>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QTableView>
#include <QToolButton>

namespace ui {
using jobs::CommissionAnswer;
using jobs::CommissionStep;

namespace {
const QString firstIdKey = QStringLiteral("commission/first_id");
const QString lastIdKey = QStringLiteral("commission/last_id");
const QString rateKey = QStringLiteral("commission/rate");
const QString centerKey = QStringLiteral("commission/center");
const QString labelKey = QStringLiteral("commission/label");
const QString batchKey = QStringLiteral("commission/batch");
const QString templateKey = QStringLiteral("commission/template");
constexpr auto typingDelay = std::chrono::milliseconds(300);

/// Pasted with the rest; no system has files called so.
bool hasControlCharacter(const QString& path)
{
    return std::any_of(path.begin(), path.end(),
                       [](QChar one) { return one.category() == QChar::Other_Control; });
}
} // namespace

CommissionPage::CommissionPage(AppContext& appContext, session::Settings& settings, QWidget* parent)
    : QWidget(parent)
    , m_desk(appContext.desk)
    , m_deskGuard(&appContext.desk)
    , m_settings(settings)
    , m_commissioning(appContext.desk)
{
    setObjectName(QStringLiteral("commissionPage"));
    build();
    m_rate->addItem(QString(), 0);
    for (const int baud : session::standardBaudRates())
        m_rate->addItem(record::rateLabel(baud), baud);
    loadSettings();
    connectAll();
    retranslate();
    showState();
    m_fileCheckTimer.start();
}

void CommissionPage::loadSettings()
{
    const auto number = [this](const QString& key, int defaultValue) {
        return m_settings.pageValue(key, defaultValue).toInt();
    };
    m_firstId->setValue(number(firstIdKey, 1));
    m_lastId->setValue(number(lastIdKey, 253));
    m_rate->setCurrentIndex(std::max(0, m_rate->findData(number(rateKey, 0))));
    m_center->setChecked(m_settings.pageValue(centerKey, false).toBool());
    m_label->setText(m_settings.pageValue(labelKey, record::defaultLabelFormat()).toString());
    m_batch->setText(m_settings.pageValue(batchKey, QString()).toString());
    if (m_batch->text().isEmpty())
        m_batch->setText(session::defaultBatchPath(QDate::currentDate()));
    m_template->setText(m_settings.pageValue(templateKey, QString()).toString());
}

/// Not whether it asks: that is to be decided each time the program is started.
void CommissionPage::saveSettings()
{
    m_settings.setPageValue(firstIdKey, m_firstId->value());
    m_settings.setPageValue(lastIdKey, m_lastId->value());
    m_settings.setPageValue(rateKey, m_rate->currentData().toInt());
    m_settings.setPageValue(centerKey, m_center->isChecked());
    m_settings.setPageValue(labelKey, m_label->text());
    m_settings.setPageValue(batchKey, m_batch->text());
    m_settings.setPageValue(templateKey, m_template->text());
}

void CommissionPage::connectAll()
{
    using session::Commissioning;
    m_fileCheckTimer.setSingleShot(true);
    m_fileCheckTimer.setInterval(typingDelay);
    connect(&m_fileCheckTimer, &QTimer::timeout, this, [this] {
        if (arePathsValid())
            m_commissioning.checkFiles(m_batch->text(), m_template->text());
    });
    for (QLineEdit* edit : {m_batch, m_template})
        connect(edit, &QLineEdit::textChanged, this, [this] {
            m_startPending = false;
            m_batchEnded = false;
            m_fileCheckTimer.start();
        });
    connect(&m_commissioning, &Commissioning::filesChecked, this, &CommissionPage::onFilesChecked);
    for (QLineEdit* edit : {m_batch, m_template, m_label})
        connect(edit, &QLineEdit::textChanged, this, &CommissionPage::showState);
    for (QSpinBox* spin : {m_firstId, m_lastId})
        connect(spin, &QSpinBox::valueChanged, this, &CommissionPage::showState);
    connect(m_browseBatch, &QToolButton::clicked, this, &CommissionPage::chooseBatch);
    connect(m_browseTemplate, &QToolButton::clicked, this, &CommissionPage::chooseTemplate);
    connect(m_start, &QPushButton::clicked, this, &CommissionPage::start);
    connect(m_stop, &QPushButton::clicked, &m_commissioning, &Commissioning::stop);
    connect(m_plug, &QPushButton::clicked, this, [this] {
        m_commissioning.connectNext();
        showState();
    });
    connect(m_unplug, &QPushButton::clicked, &m_commissioning, &Commissioning::unplug);
    const auto answers = [this](QPushButton* one, CommissionAnswer answer) {
        connect(one, &QPushButton::clicked, this,
                [this, answer] { m_commissioning.submitAnswer(answer); });
    };
    answers(m_continue, CommissionAnswer::Continue);
    answers(m_same, CommissionAnswer::SameServo);
    answers(m_aside, CommissionAnswer::Skip);
    connect(m_copy, &QPushButton::clicked, this, &CommissionPage::copyLabels);
    connect(&m_commissioning, &Commissioning::started, this, &CommissionPage::showState);
    connect(&m_commissioning, &Commissioning::changed, this, &CommissionPage::showView);
    connect(&m_commissioning, &Commissioning::batchChanged, this, [this] {
        m_model->show(m_commissioning.batch());
        // Qt does it by itself for new rows only.
        m_table->horizontalHeader()->resizeSections(QHeaderView::ResizeToContents);
        m_table->scrollToBottom();
        showView();
    });
    connect(&m_commissioning, &Commissioning::finished, this,
            [this](const std::optional<base::Error>& error) {
                m_batchEnded = true;
                if (error)
                    m_banner->showMessage(*error);
                showState();
            });
    for (const auto signal :
         {&session::Desk::linkChanged, &session::Desk::searchChanged, &session::Desk::taskChanged})
        connect(&m_desk, signal, this, &CommissionPage::showState);
}

void CommissionPage::chooseTemplate()
{
    auto* dialog = new QFileDialog(this, tr("Template"));
    dialog->setObjectName(QStringLiteral("commissionTemplateDialog"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFile);
    dialog->setNameFilters({tr("Snapshots and templates (*.json)"), tr("All files (*)")});
    connect(dialog, &QFileDialog::fileSelected, m_template, &QLineEdit::setText);
    dialog->open();
}

void CommissionPage::chooseBatch()
{
    auto* dialog = new QFileDialog(this, tr("Batch"));
    dialog->setObjectName(QStringLiteral("commissionBatchDialog"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setOption(QFileDialog::DontConfirmOverwrite); // one that exists is gone on with
    dialog->setDefaultSuffix(QStringLiteral("csv"));
    dialog->setNameFilters({tr("Lists (*.csv)")});
    connect(dialog, &QFileDialog::fileSelected, m_batch, &QLineEdit::setText);
    dialog->open();
}

/// The files are looked at once more: what is asked about is what is in them now.
void CommissionPage::start()
{
    m_startPending = true;
    m_fileCheckTimer.stop();
    m_commissioning.checkFiles(m_batch->text(), m_template->text());
}

void CommissionPage::onFilesChecked()
{
    const session::CommissionFileCheck& files = m_commissioning.files();
    if (const auto& error = files.batchError ? files.batchError : files.templateError)
        m_banner->showMessage(*error);
    else
        m_banner->hideMessage();
    m_dangerous->setVisible(!files.dangerous.isEmpty());
    updateDangerousText();
    showState();
    if (!std::exchange(m_startPending, false) || !blockedReason().isEmpty())
        return;
    if (!m_dangerous->isHidden() && m_dangerous->isChecked())
        askForConfirmation();
    else
        startCommissioning();
}

void CommissionPage::updateDangerousText()
{
    m_dangerous->setToolTip(tr("A wrong value can make a servo unreachable or dangerous: %1")
                                .arg(m_commissioning.files().dangerous.join(QStringLiteral(", "))));
}

/// Once for the whole batch.
void CommissionPage::askForConfirmation()
{
    Question question;
    question.title = tr("Write dangerous rows to every servo?");
    question.text = tr("The template has: %1")
                        .arg(m_commissioning.files().dangerous.join(QStringLiteral(", ")));
    question.risk = tr("A wrong value can make a servo unreachable or dangerous, and every servo "
                       "of the batch gets it.");
    question.acceptText = tr("Write anyway");
    question.guard = this;
    ask(this, question, [this] {
        if (blockedReason().isEmpty())
            startCommissioning();
    });
}

void CommissionPage::startCommissioning()
{
    jobs::CommissionSpec spec;
    for (int id = m_firstId->value(); id <= m_lastId->value(); ++id)
        spec.ids.push_back(id);
    spec.baud = m_rate->currentData().toInt();
    spec.center = m_center->isChecked();
    spec.automatic = m_automatic->isChecked();
    spec.dangerous = !m_dangerous->isHidden() && m_dangerous->isChecked();
    spec.labelFormat = m_label->text();
    m_banner->hideMessage();
    saveSettings();
    m_commissioning.start(spec, m_batch->text(), m_template->text());
    showState();
}

void CommissionPage::copyLabels()
{
    QList<int> rows;
    for (const QModelIndex& index : m_table->selectionModel()->selectedRows())
        rows.append(index.row());
    QGuiApplication::clipboard()->setText(m_model->labels(rows).join(QLatin1Char('\n')));
}

bool CommissionPage::arePathsValid() const
{
    return !hasControlCharacter(m_batch->text()) && !hasControlCharacter(m_template->text());
}

QString CommissionPage::blockedReason() const
{
    if (m_desk.state() != session::LinkState::Open)
        return tr("Connect first.");
    if (m_batch->text().isEmpty())
        return tr("Say which file keeps the list of the batch.");
    if (!arePathsValid())
        return tr("The name of a file has a character in it that no file can have.");
    if (m_commissioning.files().batchError)
        return tr("The batch cannot be gone on with.");
    if (m_commissioning.files().templateError)
        return tr("The template cannot be read.");
    if (m_firstId->value() > m_lastId->value())
        return tr("The last ID is below the first one.");
    if (m_desk.isSearching())
        return tr("The search goes on; the line can be started when it has ended.");
    if (m_desk.isTesting() && !m_commissioning.isRunning())
        return tr("A test runs.");
    return {};
}

void CommissionPage::showState()
{
    if (!m_deskGuard)
        return;
    const bool running = m_commissioning.isRunning();
    const QString why = running ? QString() : blockedReason();
    m_reasonLabel->setText(why);
    m_reasonLabel->setVisible(!why.isEmpty());
    m_setup->setEnabled(!running);
    m_start->setEnabled(!running && why.isEmpty());
    m_stop->setEnabled(running);
    const bool isSimulated = m_commissioning.hasHotplugQueue();
    m_plug->setVisible(isSimulated);
    m_unplug->setVisible(isSimulated);
    m_plug->setEnabled(isSimulated && m_commissioning.pendingServoCount() > 0);
    showView();
}

QString CommissionPage::headline() const
{
    const jobs::CommissionView& view = m_commissioning.view();
    if (!m_commissioning.isRunning())
        return m_batchEnded ? tr("The line has ended") : tr("One servo after the other");
    switch (view.step) {
    case CommissionStep::Waiting:
        if (view.obstacle == jobs::CommissionObstacle::Lost)
            return tr("Connect the same servo again");
        return tr("Connect the next servo");
    case CommissionStep::Blocked:
        if (view.obstacle == jobs::CommissionObstacle::DuplicateId)
            return tr("Several servos answer: leave one");
        if (view.obstacle == jobs::CommissionObstacle::DuplicateIds)
            return tr("Two servos under one ID: leave one");
        return tr("Somebody answers, but cannot be recognised");
    case CommissionStep::Confirm:
        return tr("Set up as ID %1?").arg(view.newId);
    case CommissionStep::Unplug:
        return view.newId < 0 ? tr("Unplug it") : tr("Unplug: ID %1 is done").arg(view.newId);
    case CommissionStep::Checking:
        return tr("Looking who is there …");
    default:
        return tr("Setting up ID %1 …").arg(view.newId);
    }
}

/// What was left in the middle, and how it is finished.
QString CommissionPage::unfinishedText() const
{
    QStringList servos;
    for (const record::PendingCommission& one : m_commissioning.batch().pending) {
        const auto known = record::unfinishedIssues(one);
        servos << tr("%1 for ID %2").arg(one.servo.model).arg(one.newId);
        if (!known.empty())
            servos.back() += QStringLiteral(" (⚠ %1)").arg(
                report::commissionIssuesText(known).in(text::isUiChinese()));
    }
    return tr("Unfinished: %1. Connect the servo and start the same batch again to finish it.")
        .arg(servos.join(QStringLiteral(", ")));
}

/// Whether it is the one that was begun.
QString CommissionPage::pendingQuestionText() const
{
    const jobs::CommissionView& view = m_commissioning.view();
    if (view.isResumed)
        return tr("A servo of this kind was left unfinished here. Continue only if this is that "
                  "servo.");
    if (view.candidateId < 0)
        return {};
    if (view.candidateId == view.newId)
        return tr("A servo of this kind was left unfinished; no ID is left for another one. If "
                  "this is that servo, click \"%1\".")
            .arg(m_same->text());
    return tr("A servo of this kind was left unfinished; it was to have ID %1. If this is "
              "that servo, click \"%2\"; otherwise it is set up as a new one.")
        .arg(view.candidateId)
        .arg(m_same->text());
}

QString CommissionPage::detail() const
{
    const jobs::CommissionView& view = m_commissioning.view();
    if (!m_commissioning.isRunning() && m_batchEnded && !m_commissioning.batch().pending.empty())
        return unfinishedText();
    if (!m_commissioning.isRunning() && m_batchEnded)
        return m_desk.isSearching()
                   ? tr("Looking who is on the wire now, since the servos of the list have "
                        "changed.")
                   : tr("Connect the servos to each other and search to see them all.");
    if (!m_commissioning.isRunning())
        return tr("Every servo is plugged in alone, gets template, ID and rate, is checked and "
                  "noted in the batch. Nothing moves.");
    QStringList parts;
    const bool done = view.step == CommissionStep::Unplug && view.newId >= 0;
    if (done && !m_commissioning.batch().rows.empty() &&
        m_commissioning.batch().rows.back().newId == view.newId)
        parts.append(tr("Label: %1").arg(m_commissioning.batch().rows.back().label));
    else if (!view.servo.model.isEmpty())
        parts.append(
            view.baud > 0
                ? tr("%1, ID %2 at %3 baud").arg(view.servo.model).arg(view.servo.id).arg(view.baud)
                : tr("%1, ID %2").arg(view.servo.model).arg(view.servo.id));
    for (const jobs::DetectedServo& one : view.detected)
        parts.append(tr("%1 at ID %2, %3 baud")
                         .arg(one.model.isEmpty() ? tr("somebody") : one.model)
                         .arg(one.place.id)
                         .arg(one.place.baud));
    if (view.step == CommissionStep::Waiting && view.newId >= 0)
        parts.append(tr("It gets ID %1.").arg(view.newId));
    if (view.step == CommissionStep::Confirm)
        parts.append(pendingQuestionText());
    else if (view.isResumed)
        parts.append(tr("It was begun before and is finished now."));
    if (!view.issues.empty())
        parts.append(QStringLiteral("⚠ ") +
                     report::commissionIssuesText(view.issues).in(text::isUiChinese()));
    parts.removeAll(QString());
    return parts.join(QStringLiteral(" · "));
}

void CommissionPage::showView()
{
    const jobs::CommissionView& view = m_commissioning.view();
    const bool confirm = m_commissioning.isRunning() && view.step == CommissionStep::Confirm;
    m_headline->setText(headline());
    m_headline->setAccessibleName(m_headline->text());
    m_detail->setText(detail());
    const QString saved = m_commissioning.isRunning() ? view.snapshot : QString();
    const QFileInfo file(saved);
    m_saved->setText(tr("Table saved before the first write: %1 in %2")
                         .arg(file.fileName(), QDir::toNativeSeparators(file.path())));
    m_saved->setToolTip(QDir::toNativeSeparators(saved));
    m_saved->setVisible(!saved.isEmpty());
    QPalette palette;
    const bool blocked = m_commissioning.isRunning() && view.step == CommissionStep::Blocked;
    const bool done =
        m_commissioning.isRunning() && view.step == CommissionStep::Unplug && view.newId >= 0;
    if (blocked || done)
        palette.setColor(QPalette::WindowText,
                         tone(blocked ? Tone::Warn : Tone::Good, this->palette()));
    m_headline->setPalette(palette);
    const bool begins = confirm && !m_continue->isVisible();
    m_continue->setText(tr("Give it ID %1").arg(view.newId));
    m_continue->setAccessibleName(m_continue->text());
    m_continue->setToolTip(tr("Template, ID and rate are written; its table is saved first"));
    m_continue->setVisible(confirm && view.newId != view.candidateId);
    m_aside->setVisible(confirm);
    m_same->setVisible(confirm && view.candidateId >= 0);
    if (begins && isVisible())
        m_continue->setFocus(); // one key is the click
    const record::CommissionBatch& batch = m_commissioning.batch();
    m_summary->setText(tr("%1 done, %2 failed, %3 set aside, %4 unfinished")
                           .arg(batch.done())
                           .arg(batch.count(record::CommissionVerdict::Failed))
                           .arg(batch.count(record::CommissionVerdict::Skipped))
                           .arg(batch.pending.size()));
    m_copy->setEnabled(!m_model->labels({}).isEmpty());
}

void CommissionPage::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange && m_copy != nullptr) {
        retranslate();
        showState();
    } else if (event->type() == QEvent::PaletteChange && m_copy != nullptr) {
        showView();
    }
}

void CommissionPage::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    showState();
}
} // namespace ui
