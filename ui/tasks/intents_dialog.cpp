// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tasks/intents_dialog.h"

#include "text/language.h"
#include "text/translate.h"
#include "ui/common/follow_language.h"
#include "ui/common/widget_style.h"
#include "ui/common/widget_text.h"
#include "ui/widgets/fit_columns.h"
#include "ui/widgets/question_dialog.h"

#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableView>
#include <QVBoxLayout>

namespace ui {
using jobs::Finding;
using jobs::RecoveryAction;
using jobs::RecoveryResult;
using session::Event;
using session::Workbench;
using text::translate;

namespace {
constexpr int initialWidth = 880;
constexpr int initialHeight = 420;

/// Settings of a test and a blinking LED have no change to finish: both actions restore them.
bool isRollbackOnly(const base::Intent& intent)
{
    return intent.kind == base::IntentKind::Trial || intent.kind == base::IntentKind::Identify;
}

/// The names of the registers that recovery does not write by itself.
QString remainingChangesLine(const RecoveryResult& one, const catalog::Catalog& catalog)
{
    const catalog::ProfilePtr profile = profileOf(catalog, one.before.intent.servo);
    QStringList names;
    for (const QString& key : one.skippedKeys)
        names << text::registerName(profile.get(), key);
    return names.isEmpty()
               ? QString()
               : translate("ServoTasks",
                           "These registers were not written because their values have changed in "
                           "the meantime or because writing them would move the servo: %1")
                     .arg(text::joinItems(names));
}

/// What the recovery has really done, which is not always what the button names.
TaskText recoveredText(const RecoveryResult& one, const catalog::Catalog& catalog)
{
    if (one.error)
        return errorText(*one.error);
    if (one.isAllSkipped)
        return {Tone::Warn,
                translate("ServoTasks", "Nothing was written. ServoDesk will no longer offer to "
                                        "finish or undo this change."),
                {remainingChangesLine(one, catalog)}};
    const base::Intent& intent = one.before.intent;
    const bool allowPreviousValues = one.before.finding == Finding::AllOld;
    QString line;
    if (isRollbackOnly(intent))
        line = allowPreviousValues
                   ? translate("ServoTasks", "The servo already has the settings from before the "
                                             "test. Nothing needed to be restored.")
                   : translate("ServoTasks", "The settings from before the test have been "
                                             "restored.");
    else if (one.action == RecoveryAction::Undo)
        line = translate("ServoTasks", "The old values have been restored.");
    else
        line = translate("ServoTasks", "The change has been completed.");
    TaskText result{Tone::Good, line, {remainingChangesLine(one, catalog)}};
    if (one.report)
        result.details << lockLine(one.report->lock);
    result.details.removeAll(QString());
    return result;
}

bool canRecover(const RecoveryResult& one)
{
    return one.before.finding != Finding::NoReply && one.before.finding != Finding::OtherServo &&
           one.before.finding != Finding::Unreadable && one.before.finding != Finding::UnderWay;
}
} // namespace

IntentsDialog::IntentsDialog(Workbench& workbench, const std::vector<RecoveryResult>& intents,
                             const std::vector<base::Intent>& elsewhere, QWidget* parent)
    : QDialog(parent)
    , m_workbench(workbench)
    , m_model(new IntentsModel(workbench.catalog(), this))
    , m_explanation(new QLabel(this))
    , m_table(new QTableView(this))
    , m_otherPortText(new QLabel(this))
    , m_searchHere(new QPushButton(this))
    , m_result(new TaskResult(initialWidth - 2 * dialogMargin, this))
    , m_finish(new QPushButton(this))
    , m_undo(new QPushButton(this))
    , m_forget(new QPushButton(this))
    , m_later(new QPushButton(this))
{
    setObjectName(QStringLiteral("intentsDialog"));
    setAttribute(Qt::WA_DeleteOnClose);
    build();
    connect(&workbench.recovery(), &session::RecoveryService::openIntentsFound, this,
            &IntentsDialog::setIntents);
    connect(&workbench, &Workbench::eventOccurred, this, &IntentsDialog::onRecoveryFailed);
    connect(&workbench.link(), &session::LinkController::linkChanged, this,
            &IntentsDialog::updateButtons);
    connect(m_table->selectionModel(), &QItemSelectionModel::selectionChanged, this,
            &IntentsDialog::updateButtons);
    connect(m_finish, &QPushButton::clicked, this, [this] { recover(RecoveryAction::Finish); });
    connect(m_undo, &QPushButton::clicked, this, [this] { recover(RecoveryAction::Undo); });
    connect(m_forget, &QPushButton::clicked, this, &IntentsDialog::discardIntent);
    connect(m_later, &QPushButton::clicked, this, &QDialog::reject);
    connect(m_searchHere, &QPushButton::clicked, this, [this] {
        m_searchedHere = true;
        m_searchHere->setEnabled(false);
        m_workbench.recovery().findOpenIntents(true);
    });
    setIntents(intents, elsewhere);
    followLanguage(this, [this] { retranslate(); });
}

void IntentsDialog::build()
{
    m_explanation->setObjectName(QStringLiteral("explanation"));
    m_explanation->setWordWrap(true);
    m_table->setObjectName(QStringLiteral("intents"));
    m_table->setModel(m_model);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    styleTable(m_table);
    m_columns = new FitColumns(m_table);
    m_otherPortText->setObjectName(QStringLiteral("intentsElsewhere"));
    m_otherPortText->setWordWrap(true);
    m_otherPortText->setTextFormat(Qt::PlainText);
    auto* other = new QHBoxLayout;
    other->addWidget(m_otherPortText, 1);
    other->addWidget(m_searchHere, 0, Qt::AlignTop);
    QHBoxLayout* row = buildButtons();
    auto* column = new QVBoxLayout(this);
    // A result that appears must not resize the window under the user's hand.
    column->setSizeConstraint(QLayout::SetNoConstraint);
    column->setSpacing(12);
    column->addWidget(m_explanation);
    column->addWidget(m_table, 1);
    column->addLayout(other);
    column->addWidget(m_result);
    column->addLayout(row);
    setMinimumSize(initialWidth, initialHeight);
}

QHBoxLayout* IntentsDialog::buildButtons()
{
    auto* row = new QHBoxLayout;
    const std::pair<QPushButton*, const char*> buttons[] = {{m_finish, "intentFinish"},
                                                            {m_undo, "intentUndo"},
                                                            {m_forget, "intentForget"},
                                                            {m_searchHere, "intentsLookHere"},
                                                            {m_later, "intentLater"}};
    for (const auto& [button, name] : buttons) {
        button->setObjectName(QLatin1String(name));
        button->setAutoDefault(false);
    }
    row->addWidget(m_finish);
    row->addWidget(m_undo);
    row->addWidget(m_forget);
    row->addStretch();
    row->addWidget(m_later);
    m_later->setDefault(true);
    return row;
}

/// A write that another program is executing was not interrupted.
QString IntentsDialog::explanation() const
{
    const int rows = m_model->rowCount();
    int underWay = 0;
    for (int row = 0; row < rows; ++row)
        underWay += m_model->at(row)->before.finding == Finding::UnderWay ? 1 : 0;
    if (rows == 0)
        return translate(
            "ServoTasks",
            "Changes that were started but not finished are listed here. Possible causes: a cable "
            "was pulled, the power failed, or the program was terminated.");
    if (underWay == rows)
        return translate(
            "ServoTasks",
            "Another program is still making these changes, so ServoDesk does not touch them. If "
            "that program ends before the changes are complete, they will be listed here.");
    const QString interrupted = translate(
        "ServoTasks", "These changes were started but not finished because a cable was pulled, the "
                      "power failed, or the program was terminated. ServoDesk has only checked "
                      "them; nothing was written. Choose what to do with each change. Postponed "
                      "changes will be listed again the next time you connect.");
    if (underWay == 0)
        return interrupted;
    return text::joinSentences(
        {interrupted,
         translate("ServoTasks", "If another program is still making a change, ServoDesk leaves "
                                 "the change to that program.")});
}

void IntentsDialog::retranslate()
{
    setWindowTitle(translate("ServoTasks", "Interrupted writes"));
    setAccessibleName(windowTitle());
    const bool none = m_model->rowCount() == 0;
    m_explanation->setText(explanation());
    updateFinishText();
    setButtonText(
        m_undo, translate("ServoTasks", "Undo"),
        translate("ServoTasks", "Restores the old values, verifies them, and locks the EPROM"));
    setButtonText(
        m_forget, translate("ServoTasks", "Forget…"),
        translate("ServoTasks",
                  "Marks the change as abandoned in the journal; the servo stays as it is"));
    setButtonText(m_later,
                  none ? translate("ServoTasks", "Close") : translate("ServoTasks", "Later"),
                  translate("ServoTasks", "Closes this list; writes nothing"));
    setButtonText(m_searchHere, translate("ServoTasks", "Search this port"),
                  translate("ServoTasks",
                            "Reads the servos on this port and compares them with these changes; "
                            "writes nothing"));
    updateElsewhereText();
    m_table->setAccessibleName(translate("ServoTasks", "Interrupted writes"));
    m_table->setToolTip(translate("ServoTasks", "Interrupted writes"));
    m_model->retranslate();
}

const RecoveryResult* IntentsDialog::current() const
{
    const QModelIndexList rows = m_table->selectionModel()->selectedRows();
    return rows.isEmpty() ? nullptr : m_model->at(rows.first().row());
}

void IntentsDialog::updateFinishText()
{
    const RecoveryResult* one = current();
    if (one != nullptr && isRollbackOnly(one->before.intent))
        setButtonText(m_finish, translate("ServoTasks", "Restore"),
                      translate("ServoTasks",
                                "Restores the settings from before the test and verifies them"));
    else
        setButtonText(m_finish, translate("ServoTasks", "Finish"),
                      translate("ServoTasks",
                                "Writes and verifies the missing values and locks the EPROM; "
                                "afterwards, Undo can revert the whole change"));
}

void IntentsDialog::updateButtons()
{
    const RecoveryResult* one = current();
    updateFinishText();
    const bool free = one != nullptr && m_recovering.isEmpty();
    const bool open = m_workbench.link().state() == session::LinkState::Open;
    m_finish->setEnabled(free && open && canRecover(*one));
    m_undo->setEnabled(free && open && canRecover(*one));
    m_forget->setEnabled(free && open && one->before.finding != Finding::UnderWay);
}

void IntentsDialog::recover(RecoveryAction action)
{
    const RecoveryResult* one = current();
    if (one == nullptr || !m_recovering.isEmpty())
        return;
    m_recovering = one->before.intent.uuid;
    m_result->showResult([] { return TaskText{Tone::Quiet, translate("ServoTasks", "Working…")}; });
    updateButtons();
    m_workbench.recovery().recoverIntent(m_recovering, action);
}

void IntentsDialog::discardIntent()
{
    const RecoveryResult* one = current();
    if (one == nullptr)
        return;
    Question question;
    question.title = translate("ServoTasks", "Forget this change?");
    question.text = translate(
        "ServoTasks",
        "ServoDesk will no longer offer to finish or undo this change. The servo stays as it is.");
    question.risk = translate(
        "ServoTasks",
        "The EPROM may be unlocked, and the servo may have some old and some new values.");
    question.acceptText = translate("ServoTasks", "Forget");
    question.guard = this;
    ask(this, question,
        [this, uuid = one->before.intent.uuid] { m_workbench.recovery().discardIntent(uuid); });
}

/// After a search all open intents; after a recovery the one that was recovered.
void IntentsDialog::setIntents(const std::vector<RecoveryResult>& all,
                               const std::vector<base::Intent>& elsewhere)
{
    if (!m_recovering.isEmpty()) {
        onRecovered(all);
        return;
    }
    m_otherPortIntents = elsewhere;
    m_model->setIntents(all);
    retranslate();
    if (!all.empty())
        m_table->selectRow(0);
    m_columns->fit();
    if (all.empty() && elsewhere.empty() && !m_result->isVisibleTo(this))
        m_result->showResult([] {
            return TaskText{Tone::Good, translate("ServoTasks", "No unfinished changes.")};
        });
    updateButtons();
}

void IntentsDialog::onRecovered(const std::vector<RecoveryResult>& one)
{
    const QString uuid = std::exchange(m_recovering, QString());
    if (!one.empty() && one.front().before.intent.uuid == uuid)
        m_result->showResult(
            [this, first = one.front()] { return recoveredText(first, m_workbench.catalog()); });
    else if (one.empty())
        m_result->showResult([] {
            return TaskText{
                Tone::Warn,
                translate(
                    "ServoTasks",
                    "Nothing was written because the change is no longer listed as unfinished, or "
                    "because the port where it was started is available again.")};
        });
    if (!one.empty() && one.front().done)
        m_model->remove(uuid);
    reload();
}

/// Only a new search shows what is open now.
void IntentsDialog::reload()
{
    retranslate();
    m_workbench.recovery().findOpenIntents(m_searchedHere);
    updateButtons();
}

/// Servo, change and port. Only changes begun on a port that is gone are searched here: on a
/// present port the servo itself may still be connected, and an identical one here.
void IntentsDialog::updateElsewhereText()
{
    QStringList gone;
    QStringList present;
    bool mayBeHere = false;
    for (const base::Intent& intent : m_otherPortIntents) {
        const bool there = jobs::isPortPresent(intent);
        (there ? present : gone) << m_model->line(intent);
        mayBeHere = mayBeHere || !(there || intent.isActiveElsewhere);
    }
    if (!gone.isEmpty())
        gone.prepend(translate("ServoTasks",
                               "Unfinished changes from other ports. If the adapter's port "
                               "name has changed, search the new port for the servos:"));
    if (!present.isEmpty())
        present.prepend(translate("ServoTasks", "Unfinished changes from other ports. To finish or "
                                                "undo a change, connect to its port:"));
    m_otherPortText->setText((present + gone).join(QLatin1Char('\n')));
    m_otherPortText->setVisible(!m_otherPortIntents.empty());
    // A simulated servo is never the one with the interrupted change.
    const session::Connection* connection = m_workbench.link().connection();
    m_searchHere->setVisible(mayBeHere && connection != nullptr && !connection->isSimulated());
    m_searchHere->setEnabled(mayBeHere && m_workbench.link().state() == session::LinkState::Open);
}

/// The recovery failed, perhaps between two writes, or never began.
void IntentsDialog::onRecoveryFailed(const Event& event)
{
    const bool failed = event.kind == Event::Kind::Failed && event.error &&
                        event.task == QLatin1StringView("recover");
    if (!failed || m_recovering.isEmpty())
        return;
    m_recovering.clear();
    m_result->showResult([error = *event.error] {
        TaskText result = errorText(error);
        result.details << translate("ServoTasks",
                                    "The change is still unfinished and will be listed again.");
        return result;
    });
    reload();
}
} // namespace ui
