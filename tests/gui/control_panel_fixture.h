// SPDX-License-Identifier: GPL-3.0-or-later
// The control panel on a real workbench and a simulated bus, without the rest of the window. Its
// widgets are used as a user does; the real state of the servos is read from the simulation, not
// over the bus. Main thread.
#pragma once

#include "gui/press_clock.h"
#include "session/motion/motion_controller.h"
#include "sim/host/sim_link.h"
#include "support/temporary_data_folder.h"
#include "support/waiting.h"
#include "ui/app/program.h"
#include "ui/common/commands.h"
#include "ui/operate/control_panel.h"
#include "ui/operate/control_slider.h"

#include <QAbstractSpinBox>
#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QToolButton>
#include <QtTest>

namespace gui {
class ControlPanelFixture {
public:
    /// `data`: a folder that outlives the fixture, for what is remembered between starts.
    explicit ControlPanelFixture(const QString& data = {})
        : session(sessionWithData(data.isEmpty() ? dataFolder.path() : data))
    {
        settings.setPageValue(QStringLiteral("operate/no_torque_hint"), true);
        panel.resize(380, 900);
        panel.show();
    }

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
    session::ServoRef ref(int id) const
    {
        for (const session::ServoRef one : workbench.registry().order()) {
            if (workbench.registry().servo(one)->servo.id == id)
                return one;
        }
        return 0;
    }
    bool choose(const std::vector<int>& ids)
    {
        std::vector<session::ServoRef> refs;
        for (const int id : ids)
            refs.push_back(ref(id));
        selection.setSelected(refs);
        return waitUntilIdle() && workbench.registry().servo(refs.front())->hasFullTable && shown();
    }
    /// Connected, found and chosen; the first one's panel is filled.
    bool ready(const QString& port, const std::vector<int>& ids)
    {
        return connectTo(port) && search(1, 9) && choose(ids);
    }
    bool waitUntilIdle()
    {
        return support::waitFor([this] { return !workbench.tasks().isBusy() && !drive.isBusy(); });
    }
    /// What the workbench knows has come into the widgets.
    bool shown()
    {
        QSignalSpy spy(&panel, &ui::ControlPanel::goalStateChanged);
        Q_EMIT drive.changed();
        const bool come = spy.wait(5000);
        QCoreApplication::processEvents(); // new widgets have got their places
        return come;
    }
    const session::ServoEntry& entry() { return *workbench.registry().servo(selection.current()); }

    template <typename Function>
    decltype(auto) withBus(Function&& function)
    {
        return workbench.link().connection()->simulation()->with(std::forward<Function>(function));
    }
    /// What the servo really holds.
    std::int64_t raw(int id, const char* key)
    {
        return withBus(
            [&](sim::VirtualBus& wire) { return wire.servo(id)->raw(QString::fromLatin1(key)); });
    }
    void poke(int id, const char* key, std::int64_t raw)
    {
        withBus(
            [&](sim::VirtualBus& wire) { wire.servo(id)->poke(QString::fromLatin1(key), raw); });
    }
    /// Of the shaft, now. The simulation advances when it is asked.
    double degrees(int id)
    {
        const bool idle = !workbench.tasks().isBusy() && !workbench.search().isSearching();
        return withBus([&](sim::VirtualBus& wire) {
            if (idle)
                wire.hostReads(workbench.now());
            return wire.servo(id)->shaftDegrees();
        });
    }
    /// The shaft has not stirred for a while.
    bool isAtRest(int id)
    {
        double before = degrees(id);
        base::Duration since = workbench.now();
        return support::waitFor([&] {
            const double now = degrees(id);
            if (std::abs(now - before) > 0.05)
                since = workbench.now();
            before = now;
            return workbench.now() - since > std::chrono::milliseconds(250);
        });
    }
    /// The list's copy of these registers, fresh.
    bool read()
    {
        workbench.writes().readTable(selection.current());
        return waitUntilIdle() && shown();
    }

    template <typename Widget>
    Widget* find(const char* name)
    {
        return panel.findChild<Widget*>(QString::fromLatin1(name));
    }
    QAbstractSpinBox* box(const char* name) { return find<QAbstractSpinBox>(name); }
    bool has(const char* field)
    {
        const auto* widget = find<QWidget>(field);
        return widget != nullptr && widget->isVisibleTo(&panel);
    }
    QString text(const char* label)
    {
        const auto* found = find<QLabel>(label);
        return found != nullptr && found->isVisibleTo(&panel) ? found->text() : QString();
    }
    QString complaint()
    {
        const auto* banner = find<QWidget>("controlBanner");
        QStringList lines;
        if (banner == nullptr || !banner->isVisibleTo(&panel))
            return {};
        for (const QLabel* label : banner->findChildren<QLabel*>())
            lines << label->text();
        return lines.join(QLatin1Char('\n'));
    }
    void click(const char* name) { QTest::mouseClick(find<QWidget>(name), Qt::LeftButton); }
    /// Typed over what stands there, without Enter.
    void type(const char* name, const QString& text)
    {
        QAbstractSpinBox* spin = box(name);
        QVERIFY2(spin != nullptr, name);
        spin->setFocus();
        spin->selectAll();
        QTest::keyClicks(spin, text);
    }
    void enter(const char* name, const QString& text)
    {
        type(name, text);
        QTest::keyClick(box(name), Qt::Key_Return);
    }
    /// Goal typed, sent and taken.
    bool go(const QString& goal)
    {
        enter("goal", goal);
        return waitUntilIdle();
    }
    QDialog* question()
    {
        QDialog* found = nullptr;
        const bool open = support::waitFor([&] {
            for (QWidget* widget : QApplication::topLevelWidgets()) {
                if (widget->isVisible() && widget->objectName() == QLatin1String("question"))
                    found = qobject_cast<QDialog*>(widget);
            }
            return found != nullptr;
        });
        return open ? found : nullptr;
    }
    /// By the tile and the question it asks.
    bool switchModeByTile(const char* mode)
    {
        QTest::mouseClick(
            find<QAbstractButton>(qPrintable(QStringLiteral("mode_") + QString::fromLatin1(mode))),
            Qt::LeftButton);
        QDialog* asked = question();
        if (asked == nullptr)
            return false;
        confirmationText = asked->findChild<QLabel*>(QStringLiteral("questionText"))->text();
        QTest::mouseClick(asked->findChild<QPushButton*>(QStringLiteral("questionYes")),
                          Qt::LeftButton);
        if (!waitUntilIdle() || !shown())
            return false;
        const catalog::Mode* now = entry().servo.mode();
        return now != nullptr && now->key == QLatin1String(mode);
    }
    bool torque()
    {
        click("torqueSwitch");
        return waitUntilIdle() && shown();
    }
    ui::ControlSlider* slider() { return find<ui::ControlSlider>("goalSlider"); }

    QString confirmationText; ///< text of the latest question

private:
    /// The session looks for its folder once, when it is made.
    static session::Session sessionWithData(const QString& folder)
    {
        qputenv("SERVODESK_DATA_DIR", folder.toLocal8Bit());
        return session::Session();
    }

public:
    AdvancingClock pressClock;               ///< nothing has just moved
    support::TemporaryDataFolder dataFolder; ///< before the session
    session::Settings settings{dataFolder.folder.filePath(QStringLiteral("servodesk.ini"))};
    session::Session session; ///< in its folder
    session::Workbench workbench{session};
    ui::Selection selection;
    ui::Commands commands{workbench, selection};
    session::MotionController& drive = workbench.motion();
    ui::ControlPanel panel{workbench, commands, selection, settings, drive};
};
} // namespace gui
