// SPDX-License-Identifier: GPL-3.0-or-later
// A workbench with what widgets need besides it, and ports that the test plugs in. One at a time;
// main thread.
#pragma once

#include "gui/fail_on_warnings.h"
#include "session/port_watcher.h"
#include "session/settings.h"
#include "support/temporary_data_folder.h"
#include "support/waiting.h"
#include "ui/app/program.h"
#include "ui/common/commands.h"
#include "ui/common/selection.h"

#include <QDir>
#include <QTemporaryDir>
#include <QtTest>

#include <mutex>

namespace gui {
/// What is plugged in. The watch's thread looks, the test plugs.
class FakePortList {
public:
    void plug(const session::PortInfo& port)
    {
        const std::lock_guard lock(m_mutex);
        m_portList.ports.push_back(port);
    }
    void unplug(const QString& path)
    {
        const std::lock_guard lock(m_mutex);
        auto& ports = m_portList.ports;
        ports.erase(
            std::remove_if(ports.begin(), ports.end(),
                           [&](const session::PortInfo& port) { return port.path == path; }),
            ports.end());
    }
    void adaptersClaimedByBrltty(const QStringList& chips)
    {
        const std::lock_guard lock(m_mutex);
        m_portList.claimedAdapters = chips;
    }
    session::PortWatcher::PortLister lister()
    {
        return [this] {
            const std::lock_guard lock(m_mutex);
            return m_portList;
        };
    }

private:
    std::mutex m_mutex;
    session::PortWatcher::PortList m_portList;
};

inline session::PortInfo adapter(const QString& path, const QString& serial)
{
    session::PortInfo port;
    port.path = path;
    port.description = QStringLiteral("USB Serial");
    port.manufacturer = QStringLiteral("QinHeng");
    port.serialNumber = serial;
    port.vendorId = 0x1a86;
    port.productId = 0x7523;
    return port;
}

class WorkbenchFixture {
public:
    bool open(const QString& port)
    {
        session::PortRequest request;
        request.name = port;
        workbench.link().connectTo(request);
        return support::waitFor(
            [this] { return workbench.link().state() == session::LinkState::Open; });
    }
    bool search(const jobs::ScanSpec& spec = {})
    {
        workbench.search().start(spec);
        return support::waitFor([this] { return !workbench.search().isSearching(); });
    }
    session::ServoRef ref(int id) const
    {
        for (const session::ServoRef one : workbench.registry().order()) {
            if (workbench.registry().servo(one)->servo.id == id)
                return one;
        }
        return 0;
    }
    QAction* action(ui::Command command) const { return commands.action(command); }

private:
    QTemporaryDir m_folder;

public:
    FakePortList portList;
    session::Settings settings{m_folder.filePath(QStringLiteral("servodesk.ini"))};
    session::PortWatcher ports{nullptr, portList.lister()};
    support::TemporaryDataFolder dataFolder; ///< before the session
    session::Session session;
    session::Workbench workbench{session};
    ui::Selection selection;
    ui::Commands commands{workbench, selection};
};
} // namespace gui
