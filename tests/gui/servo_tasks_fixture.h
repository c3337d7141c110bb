// SPDX-License-Identifier: GPL-3.0-or-later
// The servo menu on a real workbench and a simulated bus, without the rest of the window. Dialogs
// are found and used as a user does, by mouse and keyboard. Main thread.
#pragma once

#include "gui/dialogs.h"
#include "sim/host/sim_link.h"
#include "support/temporary_data_folder.h"
#include "support/waiting.h"
#include "ui/common/commands.h"
#include "ui/tasks/servo_tasks.h"

#include <QDialog>
#include <QDir>

namespace gui {
class ServoTasksFixture {
public:
    ServoTasksFixture()
    {
        window.resize(800, 600);
        window.show();
    }

    bool connectTo(const char* port) { return connectTo(QString::fromLatin1(port)); }
    bool connectTo(const QString& port)
    {
        workbench.link().connectTo({.name = port});
        return support::waitFor(
            [this] { return workbench.link().state() == session::LinkState::Open; });
    }
    bool search(int first, int last)
    {
        workbench.search().start({.firstId = first, .lastId = last, .bauds = {}});
        return support::waitFor(
            [this] { return !workbench.search().isSearching() && !workbench.tasks().isBusy(); });
    }
    bool choose(int id)
    {
        for (const session::ServoRef ref : workbench.registry().order()) {
            if (workbench.registry().servo(ref)->servo.id == id)
                selection.select(ref);
        }
        if (selection.current() == 0)
            return false;
        workbench.writes().readTable(selection.current());
        return waitUntilIdle();
    }
    bool ready(const char* port, int first, int last, int id)
    {
        return connectTo(port) && search(first, last) && choose(id);
    }
    bool waitUntilIdle()
    {
        return support::waitFor([this] { return !workbench.tasks().isBusy(); });
    }

    const session::ServoEntry& entry() { return *workbench.registry().servo(selection.current()); }
    template <typename Function>
    decltype(auto) withBus(Function&& function)
    {
        return workbench.link().connection()->simulation()->with(std::forward<Function>(function));
    }
    /// What the servo really holds, past the wire.
    std::int64_t raw(int id, const char* key)
    {
        return withBus(
            [&](sim::VirtualBus& wire) { return wire.servo(id)->raw(QString::fromLatin1(key)); });
    }

    /// The menu was used; the dialog it opened, or null.
    QDialog* open(ui::Command command, const char* name)
    {
        commands.action(command)->trigger();
        return dialog(name);
    }
    QDialog* dialog(const char* name)
    {
        QDialog* found = nullptr;
        const bool shown = support::waitFor([&] {
            for (QWidget* widget : QApplication::topLevelWidgets()) {
                if (widget->isVisible() && widget->objectName() == QLatin1String(name))
                    found = qobject_cast<QDialog*>(widget);
            }
            return found != nullptr;
        });
        return shown ? found : nullptr;
    }

    support::TemporaryDataFolder dataFolder; ///< before the session
    session::Session session;
    session::Workbench workbench{session};
    ui::Selection selection;
    ui::Commands commands{workbench, selection};
    QWidget window;
    ui::ServoTasks* tasks = new ui::ServoTasks(workbench, commands, selection, &window);
};

/// How the task ended, in its own words; empty while it runs.
inline QString resultOf(QDialog* dialog)
{
    const auto* result = dialog->findChild<QWidget*>(QStringLiteral("taskResult"));
    if (result == nullptr || !result->isVisible())
        return {};
    return textOf(dialog, "resultSign") + QLatin1Char(' ') + textOf(dialog, "resultWhat") +
           QLatin1Char('\n') + textOf(dialog, "resultMore");
}

inline bool ended(QDialog* dialog)
{
    return support::waitFor([dialog] {
        const auto* stop = button(dialog, "taskStop");
        return !resultOf(dialog).isEmpty() && (stop == nullptr || !stop->isVisible());
    });
}
} // namespace gui
