// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/search/search_panel.h"

#include "text/error_text.h"
#include "text/progress_text.h"
#include "ui/common/widget_text.h"
#include "ui/search/search_scope.h"
#include "ui/search/servo_delegate.h"
#include "ui/search/servo_list_model.h"
#include "ui/widgets/rate_text.h"
#include "ui/widgets/thin_progress.h"

#include <QLabel>
#include <QListView>
#include <QMenu>
#include <QPushButton>
#include <QSignalBlocker>
#include <QStackedWidget>

#include <algorithm>

namespace ui {
using session::LinkState;
using session::ServoRef;

namespace {
constexpr int panelWidth = 300;
} // namespace

QSize SearchPanel::sizeHint() const
{
    return {panelWidth, QWidget::sizeHint().height()};
}

void SearchPanel::search()
{
    m_workbench.search().start(m_scope->spec());
}

void SearchPanel::searchChanged()
{
    const bool now = m_workbench.search().isSearching();
    if (now && !m_searching) {
        m_error.reset();
        m_lastProgress.reset();
        m_progress->setValue(0);
    }
    if (!now)
        m_progress->setValue(m_error || !m_workbench.search().lastReport() ? 0 : permille);
    m_searching = now;
    showStatus();
    showList();
}

/// The end is reported after the list has been updated; searchChanged() comes before that.
void SearchPanel::onEvent(const session::Event& event)
{
    if (event.kind == session::Event::Kind::SearchEnded) {
        m_error = event.error;
        searchEnded();
    }
    // Servos missed by an earlier search are not reported while servos are set up one by one.
    const bool line = event.task == QLatin1String("commission");
    if (line && (event.kind == session::Event::Kind::Started ||
                 event.kind == session::Event::Kind::Finished)) {
        m_commissioning = event.kind == session::Event::Kind::Started;
        showStatus();
        showList();
    }
}

void SearchPanel::searchEnded()
{
    m_progress->setValue(m_error || !m_workbench.search().lastReport() ? 0 : permille);
    showStatus();
    showList();
}

void SearchPanel::showProgress(const jobs::Progress& progress)
{
    m_lastProgress = progress;
    m_progress->setValue(int(progress.fraction * permille));
    showStatus();
}

void SearchPanel::showStatus()
{
    QString words;
    QString tip;
    if (m_searching && m_lastProgress) {
        words = tr("%1 % · %n servo(s) · %2 left", nullptr, int(m_lastProgress->found))
                    .arg(int(m_lastProgress->fraction * 100))
                    .arg(text::durationText(m_lastProgress->remaining.value_or(base::Duration{})));
        if (m_workbench.link().canSetBaud())
            words += tr(" · at %1").arg(shortRate(m_lastProgress->baud));
    } else if (m_commissioning) {
        words = tr("Commissioning is running. Its servos are shown on the Commissioning page.");
    } else if (m_searching) {
        words = tr("Starting the search…");
    } else if (m_error) {
        const text::Description error = text::describe(*m_error);
        words = error.message;
        tip = error.cause + QLatin1Char('\n') + error.remedy;
    } else if (const auto& report = m_workbench.search().lastReport()) {
        const int found = int(report->found.size());
        words = (report->stopped ? tr("Stopped after %1 · %n servo(s)", nullptr, found)
                                 : tr("Search took %1 · %n servo(s)", nullptr, found))
                    .arg(spanText(report->elapsed));
        if (report->slowPassAdvised)
            words += QLatin1Char('\n') + tr("Some servos replied late, so others may have been "
                                            "missed. Select \"Wait longer\" and search again.");
    }
    m_status->setText(words);
    m_status->setToolTip(tip.isEmpty() ? words : words + QLatin1Char('\n') + tip);
}

void SearchPanel::showScope()
{
    const jobs::ScanSpec spec = m_scope->spec();
    const base::Duration span = m_workbench.search().estimate(spec);
    const int ids = spec.lastId - spec.firstId + 1;
    QString words = tr("%n ID(s) to search", nullptr, ids);
    if (spec.bauds.size() > 1)
        words += tr(" · baud rates: %1").arg(spec.bauds.size());
    if (span.count() > 0)
        words += tr(" · about %1").arg(spanText(span));
    m_estimate->setText(words);
    m_estimate->setToolTip(tr("Search time if no servos are found"));
}

void SearchPanel::showList()
{
    const bool isEmpty = m_model->rowCount() == 0;
    const bool isDone = m_workbench.search().lastReport().has_value() && !m_searching &&
                        !m_commissioning && m_workbench.link().state() == LinkState::Open;
    m_stack->setCurrentIndex(isEmpty ? 1 : 0);
    m_findOut->setVisible(isEmpty && isDone);
    m_why->setVisible(!isEmpty && isDone);
    retranslate();
}

void SearchPanel::showContextMenu(const QPoint& place)
{
    if (!m_list->indexAt(place).isValid() && !m_list->currentIndex().isValid())
        return;
    auto* menu = new QMenu(this);
    menu->setObjectName(QStringLiteral("servoMenu"));
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->setToolTipsVisible(true);
    const auto add = [&](std::initializer_list<Command> commands) {
        for (const Command command : commands)
            menu->addAction(m_commands.action(command));
        menu->addSeparator();
    };
    add({Command::ReadTable, Command::Identify});
    add({Command::SetId, Command::SetBaud, Command::Center, Command::RestoreDefaults});
    add({Command::Reboot, Command::ClearAlarm, Command::CloseLock});
    menu->popup(m_list->viewport()->mapToGlobal(place));
}

/// The current servo stays the first while it is selected.
void SearchPanel::onListSelectionChanged()
{
    std::vector<ServoRef> refs;
    for (const QModelIndex& index : m_list->selectionModel()->selectedIndexes()) {
        if (const ServoRef ref = m_model->refAt(index.row()); ref != 0)
            refs.push_back(ref);
    }
    if (refs.empty())
        return followSelection(); // a click beside the rows selects nothing
    m_selection.setSelectedRows(std::move(refs), m_model->refAt(m_list->currentIndex().row()));
}

void SearchPanel::followSelection()
{
    QItemSelectionModel* marked = m_list->selectionModel();
    QItemSelection rows;
    for (const ServoRef ref : m_selection.selected()) {
        if (const int row = m_model->rowOf(ref); row >= 0)
            rows.select(m_model->index(row, 0), m_model->index(row, 0));
    }
    const int current = m_model->rowOf(m_selection.current());
    const QSignalBlocker blocker(marked); // what is marked here has been chosen elsewhere
    marked->select(rows, QItemSelectionModel::ClearAndSelect);
    if (current >= 0 && m_list->currentIndex().row() != current)
        marked->setCurrentIndex(m_model->index(current, 0), QItemSelectionModel::NoUpdate);
    else if (current < 0)
        marked->clearCurrentIndex();
    m_list->viewport()->update();
}

void SearchPanel::linkChanged()
{
    const bool open = m_workbench.link().state() == LinkState::Open;
    m_scope->setHasBaud(!open || m_workbench.link().canSetBaud());
    m_delegate->setDimmed(!open);
    m_list->viewport()->update();
    showScope();
    showStatus();
    showList();
}

void SearchPanel::retranslate()
{
    m_search->setText(tr("Search"));
    m_stop->setText(tr("Stop"));
    for (const auto& [button, command] :
         {std::pair{m_search, Command::Search}, std::pair{m_stop, Command::StopSearch}}) {
        button->setToolTip(m_commands.action(command)->toolTip());
        button->setAccessibleName(button->text());
    }
    m_progress->setAccessibleName(tr("Search progress"));
    m_progress->setToolTip(tr("How much of the search is complete"));
    m_list->setAccessibleName(tr("Servos"));
    m_list->setToolTip(tr("Servos that have replied; selecting one only reads it; hold Ctrl or "
                          "Shift to select several servos and move them together"));
    m_empty->setText(emptyText());
    m_empty->setToolTip(m_empty->text());
    const QString tip = m_commands.action(Command::Diagnose)->toolTip();
    setButtonText(m_findOut, tr("Find out why…"), tip);
    setButtonText(m_why, tr("Servos missing? Find out why…"), tip);
}

QString SearchPanel::emptyText() const
{
    if (m_commissioning)
        return {};
    if (m_workbench.link().state() != LinkState::Open)
        return tr("Servos appear here when they are found.");
    const auto& report = m_workbench.search().lastReport();
    if (m_searching || !report || report->stopped || m_error)
        return tr("No servos in the list yet. Search the bus.");
    return tr("No servo replied.");
}
} // namespace ui
