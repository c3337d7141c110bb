// SPDX-License-Identifier: GPL-3.0-or-later
// The whole program for a test: session, settings of its own, themes, languages and the real
// window on a simulated bus, without a screen. One at a time; main thread.
#pragma once

#include "gui/fail_on_warnings.h"
#include "gui/press_clock.h"
#include "support/temporary_data_folder.h"
#include "support/waiting.h"
#include "ui/app/main_window.h"
#include "ui/app/program.h"
#include "ui/common/language_switch.h"
#include "ui/common/theme.h"

#include <QApplication>
#include <QDialog>
#include <QTemporaryDir>
#include <QtTest>

#include <optional>

namespace gui {
/// For a machine on which the program's own font is not what it gets: what every MainWindowFixture
/// made from now on uses in its place.
inline std::optional<QFont> fontOverride;

class MainWindowFixture {
public:
    explicit MainWindowFixture(const QString& language = QStringLiteral("en"),
                               session::Theme look = session::Theme::Light)
    {
        ui::initProgram();
        if (fontOverride)
            QApplication::setFont(*fontOverride);
        settings.setPageValue(QStringLiteral("search/last_id"), 10); // where the simulated ones are
        languages.apply(language);
        context.commands.retranslate(); // the program speaks the language before it has commands
        themes.apply(look);
        window = std::make_unique<ui::MainWindow>(context, settings, themes, languages);
        window->resize(1280, 800);
        window->show();
    }

    session::Workbench& workbench() { return context.workbench; }
    ui::Selection& selection() { return context.selection; }
    QAction* action(ui::Command command) { return context.commands.action(command); }

    QString page = QStringLiteral("memory"); ///< shown after connecting

    /// Connected, searched, and `id` selected and read.
    bool ready(int id, const QString& port = QStringLiteral("sim:demo"))
    {
        return connectTo(port) && choose(id);
    }
    bool connectTo(const QString& port)
    {
        window->start({.port = session::PortRequest{.name = port}, .page = page});
        return support::waitFor([this] {
            return workbench().search().lastReport().has_value() &&
                   !workbench().search().isSearching();
        });
    }
    bool choose(int id)
    {
        for (const session::ServoRef ref : workbench().registry().order()) {
            if (workbench().registry().servo(ref)->servo.id == id)
                selection().select(ref);
        }
        return selection().current() != 0 && waitUntilIdle() && entry().hasFullTable;
    }
    bool waitUntilIdle()
    {
        return support::waitFor([this] {
            return !workbench().tasks().isBusy() && !workbench().search().isSearching();
        });
    }
    const session::ServoEntry& entry()
    {
        return *workbench().registry().servo(selection().current());
    }
    std::optional<std::int64_t> raw(const char* key)
    {
        return entry().servo.raw(QString::fromLatin1(key));
    }

    /// Switches the language; widgets hear of it through the event loop.
    void setLanguage(const QString& language)
    {
        languages.apply(language);
        context.commands.retranslate(); // the program speaks the language before it has commands
        QCoreApplication::processEvents();
    }

    template <typename Widget>
    Widget* find(const char* name)
    {
        return window->findChild<Widget*>(QString::fromLatin1(name));
    }

    /// A page is made when it is first shown.
    bool isShown(const char* name)
    {
        const auto* widget = find<QWidget>(name);
        return widget != nullptr && widget->isVisible();
    }

    /// The one that is asked, soon; null: none.
    QDialog* question()
    {
        QDialog* found = nullptr;
        const auto isOpen = [&] {
            found = find<QDialog>("question");
            return found != nullptr && found->isVisible();
        };
        return support::waitFor(isOpen) ? found : nullptr;
    }

private:
    AdvancingClock m_pressClock; ///< nothing has just moved
    support::TemporaryDataFolder m_place;

public:
    session::Settings settings{m_place.folder.filePath(QStringLiteral("servodesk.ini"))};
    ui::LanguageSwitch languages;
    ui::ThemeSwitch themes;
    session::Session session;
    ui::AppContext context{session};
    std::unique_ptr<ui::MainWindow> window; ///< goes first
};
} // namespace gui
