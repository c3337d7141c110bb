// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/history_remote.h"

#include "cli/arguments.h"
#include "cli/history_input.h"
#include "cli/translate.h"
#include "session/history_server_choice.h"

namespace cli {
namespace {
using record::HistoryServer;

base::Result<std::unique_ptr<HistoryServer>> connect(const Values& values)
{
    QString address = values.option("--server").value_or(QStringLiteral("default"));
    if (address == QLatin1String("default")) {
        const session::Settings settings;
        address = session::historyServerChoice(settings).address;
    }
    if (address.isEmpty())
        return badArgument(translate("cli", "no history server is set; name one with --server or "
                                            "SERVODESK_HISTORY_SERVER"));
    return record::connectHistoryServer(address, HistoryServer::Purpose::Browse);
}

base::Result<void> chooseBench(const HistoryServer& server, const QString& name)
{
    const auto benches = server.benches();
    if (!benches)
        return tl::unexpected(benches.error());
    QStringList names;
    for (const record::HistoryBench& bench : *benches) {
        if (bench.name.compare(name, Qt::CaseInsensitive) == 0)
            return server.choose(bench.number);
        names.append(bench.name);
    }
    return badArgument(translate("cli", "no bench called %1 sends there; these do: %2")
                           .arg(name, names.join(QStringLiteral(", "))));
}
} // namespace

std::vector<Option> serverOptions()
{
    return {{"--server",
             QT_TRANSLATE_NOOP("cli", "look at the copies on a history server: its connection "
                                      "string, or \"default\" for the one that is set"),
             "STRING"},
            {"--bench", QT_TRANSLATE_NOOP("cli", "only what this bench has sent to the server"),
             "NAME"}};
}

base::Result<std::unique_ptr<record::History>> openHistory(const Values& values)
{
    const auto bench = values.option("--bench");
    if (!values.option("--server") && !bench)
        return openHistory();
    auto server = connect(values);
    if (!server)
        return tl::unexpected(server.error());
    if (bench) {
        if (const auto chosen = chooseBench(**server, *bench); !chosen)
            return tl::unexpected(chosen.error());
    }
    return std::make_unique<record::History>(std::move(*server));
}

base::Result<std::vector<record::HistoryBench>> listBenches(const Values& values)
{
    const auto server = connect(values);
    if (!server)
        return tl::unexpected(server.error());
    return (*server)->benches();
}
} // namespace cli
