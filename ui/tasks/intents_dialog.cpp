// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tasks/intents_dialog.h"

#include "text/language.h"
#include "text/translate.h"
#include "ui/widgets/fit_columns.h"
#include "ui/widgets/question_dialog.h"

#include <QEvent>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableView>
#include <QVBoxLayout>

namespace ui {
using jobs::Finding;
using jobs::RecoveryAction;
using jobs::RecoveryResult;
using session::Desk;
using session::Event;
using text::translate;

namespace {
constexpr int initialWidth = 880;
constexpr int initialHeight = 420;
constexpr int margin = 24;

/// Of a test's settings and a blinked LED there is no change to finish: both ways put them back.
bool isRollbackOnly(const base::Intent& intent)
{
    return intent.kind == base::IntentKind::Trial || intent.kind == base::IntentKind::Identify;
}

/// What recovery does not write by itself, by name.
QString remainingChangesLine(const RecoveryResult& one, const catalog::Catalog& catalog)
{
    const catalog::ProfilePtr profile = profileOf(catalog, one.before.intent.servo);
    QStringList names;
    for (const QString& key : one.skippedKeys) {
        const catalog::Register* reg = profile->find(key);
        names << (reg != nullptr ? reg->name.in(text::isUiChinese()) : key);
    }
    return names.isEmpty()
               ? QString()
               : translate("ServoTasks", "Left as they are, because they have another value since "
                                         "or would move the servo: %1")
                     .arg(names.join(QStringLiteral(", ")));
}

/// What settling it has really done, which is not always what the button says.
TaskText recoveredText(const RecoveryResult& one, const catalog::Catalog& catalog)
{
    if (one.error)
        return errorText(*one.error);
    if (one.isAllSkipped)
        return {Tone::Warn,
                translate("ServoTasks", "Nothing was written; the change is no longer offered."),
                {remainingChangesLine(one, catalog)}};
    const base::Intent& intent = one.before.intent;
    const bool allowPreviousValues = one.before.finding == Finding::AllOld;
    QString line;
    if (isRollbackOnly(intent))
        line = allowPreviousValues
                   ? translate("ServoTasks", "The servo has the settings from before the test: "
                                             "nothing had to be put back.")
                   : translate("ServoTasks", "The settings from before the test have been put "
                                             "back.");
    else if (one.action == RecoveryAction::Undo)
        line = translate("ServoTasks", "The old values are back.");
    else
        line = translate("ServoTasks", "The change has been finished.");
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

IntentsDialog::IntentsDialog(Desk& desk, const std::vector<RecoveryResult>& intents,
                             const std::vector<base::Intent>& elsewhere, QWidget* parent)
    : QDialog(parent)
    , m_desk(desk)
    , m_model(new IntentsModel(desk.catalog(), this))
    , m_explanation(new QLabel(this))
    , m_table(new QTableView(this))
    , m_otherPortText(new QLabel(this))
    , m_searchHere(new QPushButton(this))
    , m_result(new TaskResult(initialWidth - margin, this))
    , m_finish(new QPushButton(this))
    , m_undo(new QPushButton(this))
    , m_forget(new QPushButton(this))
    , m_later(new QPushButton(this))
{
    setObjectName(QStringLiteral("intentsDialog"));
    setAttribute(Qt::WA_DeleteOnClose);
    build();
    connect(&desk, &Desk::openIntentsFound, this, &IntentsDialog::setIntents);
    connect(&desk, &Desk::eventOccurred, this, &IntentsDialog::onRecoveryFailed);
    connect(&desk, &Desk::linkChanged, this, &IntentsDialog::updateButtons);
    connect(m_table->selectionModel(), &QItemSelectionModel::selectionChanged, this,
            &IntentsDialog::updateButtons);
    connect(m_finish, &QPushButton::clicked, this, [this] { recover(RecoveryAction::Finish); });
    connect(m_undo, &QPushButton::clicked, this, [this] { recover(RecoveryAction::Undo); });
    connect(m_forget, &QPushButton::clicked, this, &IntentsDialog::discardIntent);
    connect(m_later, &QPushButton::clicked, this, &QDialog::reject);
    connect(m_searchHere, &QPushButton::clicked, this, [this] {
        m_searchedHere = true;
        m_searchHere->setEnabled(false);
        m_desk.findOpenIntents(true);
    });
    setIntents(intents, elsewhere);
}

void IntentsDialog::build()
{
    m_explanation->setObjectName(QStringLiteral("explanation"));
    m_explanation->setWordWrap(true);
    m_table->setObjectName(QStringLiteral("intents"));
    m_table->setModel(m_model);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->setWordWrap(false);
    m_table->verticalHeader()->hide();
    m_columns = new FitColumns(m_table);
    m_table->setTabKeyNavigation(false);
    m_otherPortText->setObjectName(QStringLiteral("intentsElsewhere"));
    m_otherPortText->setWordWrap(true);
    m_otherPortText->setTextFormat(Qt::PlainText);
    auto* other = new QHBoxLayout;
    other->addWidget(m_otherPortText, 1);
    other->addWidget(m_searchHere, 0, Qt::AlignTop);
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

void IntentsDialog::setTexts(QPushButton* button, const QString& text, const QString& tip)
{
    button->setText(text);
    button->setAccessibleName(text);
    button->setToolTip(tip);
}

/// What is under way in another program was not interrupted.
QString IntentsDialog::explanation() const
{
    const int rows = m_model->rowCount();
    int underWay = 0;
    for (int row = 0; row < rows; ++row)
        underWay += m_model->at(row)->before.finding == Finding::UnderWay ? 1 : 0;
    if (rows == 0)
        return translate("ServoTasks",
                         "Changes that were begun and have no end in the journal, because a cable "
                         "was pulled, power failed, or the program was ended, are listed here.");
    if (underWay == rows)
        return translate("ServoTasks",
                         "Another program that is still running is making these changes. They are "
                         "left to it. If it ends before they are complete, they are offered here.");
    const QString interrupted = translate(
        "ServoTasks", "These changes were begun and have no end in the journal: a cable was "
                      "pulled, power failed, or the program was ended. Looking at them wrote "
                      "nothing. Choose what to do with each; what is left for later is offered "
                      "again at the next connection.");
    if (underWay == 0)
        return interrupted;
    return interrupted + QLatin1Char(' ') +
           translate("ServoTasks", "A change that is still under way in another program is left "
                                   "to it.");
}

void IntentsDialog::retranslate()
{
    setWindowTitle(translate("ServoTasks", "Interrupted writes"));
    setAccessibleName(windowTitle());
    const bool none = m_model->rowCount() == 0;
    m_explanation->setText(explanation());
    updateFinishText();
    setTexts(m_undo, translate("ServoTasks", "Undo"),
             translate("ServoTasks", "Put the old values back, prove them, and close the lock"));
    setTexts(m_forget, translate("ServoTasks", "Forget…"),
             translate("ServoTasks", "Strike it from the journal; the servo is left as it is"));
    setTexts(m_later, none ? translate("ServoTasks", "Close") : translate("ServoTasks", "Later"),
             translate("ServoTasks", "Close this list; nothing is written"));
    setTexts(m_searchHere, translate("ServoTasks", "Look on this port"),
             translate("ServoTasks",
                       "Read the servos on this port and compare them with these changes; "
                       "nothing is written"));
    updateElsewhereText();
    m_table->setAccessibleName(translate("ServoTasks", "Interrupted writes"));
    m_table->setToolTip(translate("ServoTasks", "Writes without an end in the journal"));
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
        setTexts(
            m_finish, translate("ServoTasks", "Put back"),
            translate("ServoTasks", "Put the settings from before the test back and prove them"));
    else
        setTexts(m_finish, translate("ServoTasks", "Finish"),
                 translate("ServoTasks",
                           "Write what is missing, prove it, and close the lock. Undo "
                           "then takes back the whole change"));
}

void IntentsDialog::updateButtons()
{
    const RecoveryResult* one = current();
    updateFinishText();
    const bool free = one != nullptr && m_recovering.isEmpty();
    const bool open = m_desk.state() == session::LinkState::Open;
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
    m_desk.recoverIntent(m_recovering, action);
}

void IntentsDialog::discardIntent()
{
    const RecoveryResult* one = current();
    if (one == nullptr)
        return;
    Question question;
    question.title = translate("ServoTasks", "Forget this change?");
    question.text = translate("ServoTasks", "ServoDesk no longer offers to finish or undo it. The "
                                            "servo is left as it is.");
    question.risk = translate("ServoTasks", "Its EPROM lock may stand open, and its values may be "
                                            "half old and half new.");
    question.acceptText = translate("ServoTasks", "Forget");
    question.guard = this;
    ask(this, question, [this, uuid = one->before.intent.uuid] { m_desk.discardIntent(uuid); });
}

/// Of a look all that is open; of a settlement the one that was worked on.
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
            return TaskText{Tone::Good, translate("ServoTasks", "No change was left open.")};
        });
    updateButtons();
}

void IntentsDialog::onRecovered(const std::vector<RecoveryResult>& one)
{
    const QString uuid = std::exchange(m_recovering, QString());
    if (!one.empty() && one.front().before.intent.uuid == uuid)
        m_result->showResult(
            [this, first = one.front()] { return recoveredText(first, m_desk.catalog()); });
    else if (one.empty())
        m_result->showResult([] {
            return TaskText{Tone::Warn,
                            translate("ServoTasks",
                                      "Nothing was written: the change is no longer open, or the "
                                      "port on which it was begun exists again.")};
        });
    if (!one.empty() && one.front().done)
        m_model->remove(uuid);
    reload();
}

/// What is open now is a matter of looking.
void IntentsDialog::reload()
{
    retranslate();
    m_desk.findOpenIntents(m_searchedHere);
    updateButtons();
}

/// Which servo, what and where. Only what was begun on a port that is gone is looked for here: on a
/// port that is there the servo itself may still be connected, and here its twin.
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
        gone.prepend(translate("ServoTasks", "Changes that were begun on other ports are open. If "
                                             "the adapter has another name now, look for them "
                                             "here:"));
    if (!present.isEmpty())
        present.prepend(translate("ServoTasks", "Changes that were begun on other ports are open. "
                                                "Connect to that port to finish or undo them:"));
    m_otherPortText->setText((present + gone).join(QLatin1Char('\n')));
    m_otherPortText->setVisible(!m_otherPortIntents.empty());
    // A simulated servo is never the one that was left.
    const session::Connection* connection = m_desk.connection();
    m_searchHere->setVisible(mayBeHere && connection != nullptr && !connection->isSimulated());
    m_searchHere->setEnabled(mayBeHere && m_desk.state() == session::LinkState::Open);
}

/// It broke off, perhaps between two writes, or never began.
void IntentsDialog::onRecoveryFailed(const Event& event)
{
    const bool failed = event.kind == Event::Kind::Failed && event.error &&
                        event.task == QLatin1StringView("recover");
    if (!failed || m_recovering.isEmpty())
        return;
    m_recovering.clear();
    m_result->showResult([error = *event.error] {
        TaskText result = errorText(error);
        result.details << translate("ServoTasks", "The change stays open and is offered again.");
        return result;
    });
    reload();
}

void IntentsDialog::changeEvent(QEvent* event)
{
    QDialog::changeEvent(event);
    if (event->type() == QEvent::LanguageChange && m_later != nullptr)
        retranslate();
}
} // namespace ui
