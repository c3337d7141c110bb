// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/commission_page.h"

#include "report/commission_words.h"
#include "text/language.h"
#include "ui/dialogs/ask.h"
#include "ui/models/commission_model.h"
#include "ui/models/rate_words.h"
#include "ui/widgets/banner.h"

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
const QString firstIdChoice = QStringLiteral("commission/first_id");
const QString lastIdChoice = QStringLiteral("commission/last_id");
const QString rateChoice = QStringLiteral("commission/rate");
const QString centerChoice = QStringLiteral("commission/center");
const QString labelChoice = QStringLiteral("commission/label");
const QString batchChoice = QStringLiteral("commission/batch");
const QString templateChoice = QStringLiteral("commission/template");
constexpr auto typingRests = std::chrono::milliseconds(300);

/// Pasted with the rest; no system has files called so.
bool hasControlCharacter(const QString& path)
{
    return std::any_of(path.begin(), path.end(),
                       [](QChar one) { return one.category() == QChar::Other_Control; });
}
} // namespace

CommissionPage::CommissionPage(Bench& bench, session::Settings& settings, QWidget* parent)
    : QWidget(parent)
    , m_desk(bench.desk)
    , m_deskLives(&bench.desk)
    , m_settings(settings)
    , m_line(bench.desk)
{
    setObjectName(QStringLiteral("commissionPage"));
    build();
    m_rate->addItem(QString(), 0);
    for (const int baud : session::knownRates())
        m_rate->addItem(record::rateLabel(baud), baud);
    restoreChoices();
    connectAll();
    retranslate();
    showState();
    m_lookSoon.start();
}

void CommissionPage::restoreChoices()
{
    const auto number = [this](const QString& key, int usual) {
        return m_settings.choice(key, usual).toInt();
    };
    m_firstId->setValue(number(firstIdChoice, 1));
    m_lastId->setValue(number(lastIdChoice, 253));
    m_rate->setCurrentIndex(std::max(0, m_rate->findData(number(rateChoice, 0))));
    m_center->setChecked(m_settings.choice(centerChoice, false).toBool());
    m_label->setText(m_settings.choice(labelChoice, record::usualLabelFormat()).toString());
    m_batch->setText(m_settings.choice(batchChoice, QString()).toString());
    if (m_batch->text().isEmpty())
        m_batch->setText(session::proposedBatch(QDate::currentDate()));
    m_template->setText(m_settings.choice(templateChoice, QString()).toString());
}

/// Not whether it asks: that is to be decided each time the program is started.
void CommissionPage::rememberChoices()
{
    m_settings.setChoice(firstIdChoice, m_firstId->value());
    m_settings.setChoice(lastIdChoice, m_lastId->value());
    m_settings.setChoice(rateChoice, m_rate->currentData().toInt());
    m_settings.setChoice(centerChoice, m_center->isChecked());
    m_settings.setChoice(labelChoice, m_label->text());
    m_settings.setChoice(batchChoice, m_batch->text());
    m_settings.setChoice(templateChoice, m_template->text());
}

void CommissionPage::connectAll()
{
    using session::Commissioning;
    m_lookSoon.setSingleShot(true);
    m_lookSoon.setInterval(typingRests);
    connect(&m_lookSoon, &QTimer::timeout, this, [this] {
        if (pathsFine())
            m_line.look(m_batch->text(), m_template->text());
    });
    for (QLineEdit* edit : {m_batch, m_template})
        connect(edit, &QLineEdit::textChanged, this, [this] {
            m_wanted = false;
            m_ended = false;
            m_lookSoon.start();
        });
    connect(&m_line, &Commissioning::looked, this, &CommissionPage::looked);
    for (QLineEdit* edit : {m_batch, m_template, m_label})
        connect(edit, &QLineEdit::textChanged, this, &CommissionPage::showState);
    for (QSpinBox* spin : {m_firstId, m_lastId})
        connect(spin, &QSpinBox::valueChanged, this, &CommissionPage::showState);
    connect(m_browseBatch, &QToolButton::clicked, this, &CommissionPage::chooseBatch);
    connect(m_browseTemplate, &QToolButton::clicked, this, &CommissionPage::chooseTemplate);
    connect(m_start, &QPushButton::clicked, this, &CommissionPage::start);
    connect(m_stop, &QPushButton::clicked, &m_line, &Commissioning::stop);
    connect(m_plug, &QPushButton::clicked, this, [this] {
        m_line.plugNext();
        showState();
    });
    connect(m_unplug, &QPushButton::clicked, &m_line, &Commissioning::unplug);
    const auto answers = [this](QPushButton* one, CommissionAnswer answer) {
        connect(one, &QPushButton::clicked, this, [this, answer] { m_line.answer(answer); });
    };
    answers(m_continue, CommissionAnswer::Continue);
    answers(m_same, CommissionAnswer::SameServo);
    answers(m_aside, CommissionAnswer::SetAside);
    connect(m_copy, &QPushButton::clicked, this, &CommissionPage::copyLabels);
    connect(&m_line, &Commissioning::began, this, &CommissionPage::showState);
    connect(&m_line, &Commissioning::changed, this, &CommissionPage::showView);
    connect(&m_line, &Commissioning::batchChanged, this, [this] {
        m_model->show(m_line.batch());
        // Qt does it by itself for new rows only.
        m_table->horizontalHeader()->resizeSections(QHeaderView::ResizeToContents);
        m_table->scrollToBottom();
        showView();
    });
    connect(&m_line, &Commissioning::ended, this, [this](const std::optional<base::Error>& error) {
        m_ended = true;
        if (error)
            m_banner->present(*error);
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
    m_wanted = true;
    m_lookSoon.stop();
    m_line.look(m_batch->text(), m_template->text());
}

void CommissionPage::looked()
{
    const session::CommissionFiles& files = m_line.files();
    if (const auto& error = files.batchError ? files.batchError : files.templateError)
        m_banner->present(*error);
    else
        m_banner->clear();
    m_dangerous->setVisible(!files.dangerous.isEmpty());
    tellDangerous();
    showState();
    if (!std::exchange(m_wanted, false) || !whyNot().isEmpty())
        return;
    if (!m_dangerous->isHidden() && m_dangerous->isChecked())
        askFirst();
    else
        begin();
}

void CommissionPage::tellDangerous()
{
    m_dangerous->setToolTip(tr("A wrong value can make a servo unreachable or dangerous: %1")
                                .arg(m_line.files().dangerous.join(QStringLiteral(", "))));
}

/// Once for the whole batch.
void CommissionPage::askFirst()
{
    Question question;
    question.title = tr("Write dangerous rows to every servo?");
    question.text =
        tr("The template has: %1").arg(m_line.files().dangerous.join(QStringLiteral(", ")));
    question.risk = tr("A wrong value can make a servo unreachable or dangerous, and every servo "
                       "of the batch gets it.");
    question.yes = tr("Write anyway");
    question.guard = this;
    ask(this, question, [this] {
        if (whyNot().isEmpty())
            begin();
    });
}

void CommissionPage::begin()
{
    jobs::CommissionSpec spec;
    for (int id = m_firstId->value(); id <= m_lastId->value(); ++id)
        spec.ids.push_back(id);
    spec.baud = m_rate->currentData().toInt();
    spec.center = m_center->isChecked();
    spec.automatic = m_automatic->isChecked();
    spec.dangerous = !m_dangerous->isHidden() && m_dangerous->isChecked();
    spec.labelFormat = m_label->text();
    m_banner->clear();
    rememberChoices();
    m_line.start(spec, m_batch->text(), m_template->text());
    showState();
}

void CommissionPage::copyLabels()
{
    QList<int> rows;
    for (const QModelIndex& index : m_table->selectionModel()->selectedRows())
        rows.append(index.row());
    QGuiApplication::clipboard()->setText(m_model->labels(rows).join(QLatin1Char('\n')));
}

bool CommissionPage::pathsFine() const
{
    return !hasControlCharacter(m_batch->text()) && !hasControlCharacter(m_template->text());
}

QString CommissionPage::whyNot() const
{
    if (m_desk.state() != session::LinkState::Open)
        return tr("Connect first.");
    if (m_batch->text().isEmpty())
        return tr("Say which file keeps the list of the batch.");
    if (!pathsFine())
        return tr("The name of a file has a character in it that no file can have.");
    if (m_line.files().batchError)
        return tr("The batch cannot be gone on with.");
    if (m_line.files().templateError)
        return tr("The template cannot be read.");
    if (m_firstId->value() > m_lastId->value())
        return tr("The last ID is below the first one.");
    if (m_desk.searching())
        return tr("The search goes on; the line can be started when it has ended.");
    if (m_desk.testing() && !m_line.running())
        return tr("A test runs.");
    return {};
}

void CommissionPage::showState()
{
    if (!m_deskLives)
        return;
    const bool running = m_line.running();
    const QString why = running ? QString() : whyNot();
    m_why->setText(why);
    m_why->setVisible(!why.isEmpty());
    m_setup->setEnabled(!running);
    m_start->setEnabled(!running && why.isEmpty());
    m_stop->setEnabled(running);
    const bool bag = m_line.hasBag();
    m_plug->setVisible(bag);
    m_unplug->setVisible(bag);
    m_plug->setEnabled(bag && m_line.inBag() > 0);
    showView();
}

QString CommissionPage::headline() const
{
    const jobs::CommissionView& view = m_line.view();
    if (!m_line.running())
        return m_ended ? tr("The line has ended") : tr("One servo after the other");
    switch (view.step) {
    case CommissionStep::Waiting:
        if (view.obstacle == jobs::CommissionObstacle::Lost)
            return tr("Connect the same servo again");
        return tr("Connect the next servo");
    case CommissionStep::Blocked:
        if (view.obstacle == jobs::CommissionObstacle::SeveralServos)
            return tr("Several servos answer: leave one");
        if (view.obstacle == jobs::CommissionObstacle::TwinIds)
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
QString CommissionPage::unfinishedWords() const
{
    QStringList servos;
    for (const record::CommissionPending& one : m_line.batch().pending) {
        const auto known = record::unfinishedTroubles(one);
        servos << tr("%1 for ID %2").arg(one.servo.model).arg(one.newId);
        if (!known.empty())
            servos.back() += QStringLiteral(" (⚠ %1)").arg(
                report::commissionTroublesWords(known).in(text::inChinese()));
    }
    return tr("Unfinished: %1. Connect the servo and start the same batch again to finish it.")
        .arg(servos.join(QStringLiteral(", ")));
}

/// Whether it is the one that was begun.
QString CommissionPage::askedWords() const
{
    const jobs::CommissionView& view = m_line.view();
    if (view.halfDone)
        return tr("A servo of this kind was left unfinished here. Continue only if this is that "
                  "servo.");
    if (view.doubtfulId < 0)
        return {};
    if (view.doubtfulId == view.newId)
        return tr("A servo of this kind was left unfinished; no ID is left for another one. If "
                  "this is that servo, click \"%1\".")
            .arg(m_same->text());
    return tr("A servo of this kind was left unfinished; it was to have ID %1. If this is "
              "that servo, click \"%2\"; otherwise it is set up as a new one.")
        .arg(view.doubtfulId)
        .arg(m_same->text());
}

QString CommissionPage::detail() const
{
    const jobs::CommissionView& view = m_line.view();
    if (!m_line.running() && m_ended && !m_line.batch().pending.empty())
        return unfinishedWords();
    if (!m_line.running() && m_ended)
        return m_desk.searching()
                   ? tr("Looking who is on the wire now, since the servos of the list have "
                        "changed.")
                   : tr("Connect the servos to each other and search to see them all.");
    if (!m_line.running())
        return tr("Every servo is plugged in alone, gets template, ID and rate, is checked and "
                  "noted in the batch. Nothing moves.");
    QStringList parts;
    const bool done = view.step == CommissionStep::Unplug && view.newId >= 0;
    if (done && !m_line.batch().rows.empty() && m_line.batch().rows.back().newId == view.newId)
        parts.append(tr("Label: %1").arg(m_line.batch().rows.back().label));
    else if (!view.servo.model.isEmpty())
        parts.append(
            view.baud > 0
                ? tr("%1, ID %2 at %3 baud").arg(view.servo.model).arg(view.servo.id).arg(view.baud)
                : tr("%1, ID %2").arg(view.servo.model).arg(view.servo.id));
    for (const jobs::CommissionHeard& one : view.heard)
        parts.append(tr("%1 at ID %2, %3 baud")
                         .arg(one.model.isEmpty() ? tr("somebody") : one.model)
                         .arg(one.place.id)
                         .arg(one.place.baud));
    if (view.step == CommissionStep::Waiting && view.newId >= 0)
        parts.append(tr("It gets ID %1.").arg(view.newId));
    if (view.step == CommissionStep::Confirm)
        parts.append(askedWords());
    else if (view.halfDone)
        parts.append(tr("It was begun before and is finished now."));
    if (!view.concerns.empty())
        parts.append(QStringLiteral("⚠ ") +
                     report::commissionTroublesWords(view.concerns).in(text::inChinese()));
    parts.removeAll(QString());
    return parts.join(QStringLiteral(" · "));
}

void CommissionPage::showView()
{
    const jobs::CommissionView& view = m_line.view();
    const bool confirm = m_line.running() && view.step == CommissionStep::Confirm;
    m_headline->setText(headline());
    m_headline->setAccessibleName(m_headline->text());
    m_detail->setText(detail());
    const QString saved = m_line.running() ? view.snapshot : QString();
    const QFileInfo file(saved);
    m_saved->setText(tr("Table saved before the first write: %1 in %2")
                         .arg(file.fileName(), QDir::toNativeSeparators(file.path())));
    m_saved->setToolTip(QDir::toNativeSeparators(saved));
    m_saved->setVisible(!saved.isEmpty());
    QPalette palette;
    const bool blocked = m_line.running() && view.step == CommissionStep::Blocked;
    const bool done = m_line.running() && view.step == CommissionStep::Unplug && view.newId >= 0;
    if (blocked || done)
        palette.setColor(QPalette::WindowText,
                         tone(blocked ? Tone::Warn : Tone::Good, this->palette()));
    m_headline->setPalette(palette);
    const bool begins = confirm && !m_continue->isVisible();
    m_continue->setText(tr("Give it ID %1").arg(view.newId));
    m_continue->setAccessibleName(m_continue->text());
    m_continue->setToolTip(tr("Template, ID and rate are written; its table is saved first"));
    m_continue->setVisible(confirm && view.newId != view.doubtfulId);
    m_aside->setVisible(confirm);
    m_same->setVisible(confirm && view.doubtfulId >= 0);
    if (begins && isVisible())
        m_continue->setFocus(); // one key is the click
    const record::CommissionBatch& batch = m_line.batch();
    m_sum->setText(tr("%1 done, %2 failed, %3 set aside, %4 unfinished")
                       .arg(batch.done())
                       .arg(batch.count(record::CommissionVerdict::Failed))
                       .arg(batch.count(record::CommissionVerdict::Aside))
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
