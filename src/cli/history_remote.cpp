// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/history_remote.h"

#include "cli/input/arguments.h"
#include "cli/input/history_input.h"
#include "cli/translate.h"
#include "session/detachable_worker.h"
#include "session/history/history_server_choice.h"
#include "text/language.h"

#include <future>

namespace cli {
namespace {
using history::HistoryServer;
constexpr auto checkInterval = std::chrono::milliseconds(50);
constexpr auto shutdownTimeout = std::chrono::milliseconds(900);

base::Result<std::unique_ptr<HistoryServer>> connect(Run& run, const Values& values)
{
    QString address = values.option("--server").value_or(QStringLiteral("default"));
    if (address == QLatin1String("default")) {
        session::Settings settings;
        address = session::historyServerChoice(settings).address;
    }
    if (address.isEmpty())
        return badArgument(translate("cli", "no history server is set; set one with --server or "
                                            "SERVODESK_HISTORY_SERVER"));
    return history::connectHistoryServer(address, HistoryServer::Purpose::Browse, &run.stop());
}

base::Result<void> selectBench(const HistoryServer& server, const QString& name)
{
    const auto benches = server.benches();
    if (!benches)
        return tl::unexpected(benches.error());
    QStringList names;
    for (const history::HistoryBench& bench : *benches) {
        if (bench.name.compare(name, Qt::CaseInsensitive) == 0)
            return server.selectBench(bench.number);
        names.append(bench.name);
    }
    return badArgument(
        translate("cli", "no data from a bench named %1 on this server; available benches: %2")
            .arg(name, text::joinItems(names)));
}

bool usesServer(const Values& values)
{
    return values.option("--server") || values.option("--bench") ||
           values.option("--kind") == QStringLiteral("benches");
}
} // namespace

base::Result<Exit> runHistoryWork(Run& run, const Values& values, HistoryWork work)
{
    if (!usesServer(values))
        return work(run, values);
    (void)run.session(); // is created on this thread
    const auto promise = std::make_shared<std::promise<base::Result<Exit>>>();
    auto answer = promise->get_future();
    session::DetachableWorker thread;
    thread.start([&run, values, work, promise] { promise->set_value(work(run, values)); });
    while (answer.wait_for(checkInterval) != std::future_status::ready) {
        // A connected server is left in time; connecting cannot be interrupted.
        if (run.stop().isRequested() &&
            answer.wait_for(shutdownTimeout) != std::future_status::ready)
            return base::fail(base::ErrorCode::Stopped, QStringLiteral("history-server"));
    }
    thread.finish(shutdownTimeout);
    return answer.get();
}

std::vector<Option> serverOptions()
{
    return {{"--server",
             QT_TRANSLATE_NOOP("cli", "read from a history server: its connection string, or "
                                      "\"default\" for the configured server"),
             "STRING"},
            {"--bench",
             QT_TRANSLATE_NOOP("cli", "only data sent to the server by the bench with this name"),
             "NAME"}};
}

base::Result<std::unique_ptr<history::History>> openHistory(Run& run, const Values& values)
{
    const auto bench = values.option("--bench");
    if (!values.option("--server") && !bench)
        return openHistory();
    auto server = connect(run, values);
    if (!server)
        return tl::unexpected(server.error());
    if (bench) {
        if (const auto chosen = selectBench(**server, *bench); !chosen)
            return tl::unexpected(chosen.error());
    }
    return std::make_unique<history::History>(std::move(*server));
}

base::Result<std::vector<history::HistoryBench>> listBenches(Run& run, const Values& values)
{
    const auto server = connect(run, values);
    if (!server)
        return tl::unexpected(server.error());
    return (*server)->benches();
}
} // namespace cli
