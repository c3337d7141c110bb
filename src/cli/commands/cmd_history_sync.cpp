// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands.h"
#include "cli/history_remote.h"
#include "cli/input/arguments.h"
#include "cli/output/progress.h"
#include "cli/run.h"
#include "cli/translate.h"
#include "session/detachable_worker.h"
#include "session/history/history_server_choice.h"
#include "session/history/history_uploader.h"
#include "session/paths.h"

#include <atomic>
#include <future>

namespace cli {
namespace {
using session::SendProgress;
constexpr auto checkInterval = std::chrono::milliseconds(50);
constexpr auto maxSilence = std::chrono::minutes(2);
constexpr auto shutdownTimeout = std::chrono::milliseconds(900);

/// Written by the thread that sends.
struct SendingProgress {
    std::atomic<std::int64_t> sent{0};
    std::atomic<std::int64_t> pending{0};
};

/// On a thread that can be abandoned, because a server may hang.
base::Result<SendProgress> send(Run& run, const session::HistoryServerChoice& choice)
{
    const auto sending = std::make_shared<session::HistoryUploader>(session::historyFile(),
                                                                    choice.address, choice.bench);
    const auto promise = std::make_shared<std::promise<base::Result<SendProgress>>>();
    auto answer = promise->get_future();
    session::DetachableWorker thread;
    const auto progress = std::make_shared<SendingProgress>();
    thread.start([sending, promise, progress] {
        promise->set_value(sending->send([progress](const SendProgress& done) {
            progress->sent = done.sent;
            progress->pending = done.pending;
        }));
    });
    ProgressLine line(run.console(), translate("cli", "Sending"));
    while (answer.wait_for(checkInterval) != std::future_status::ready) {
        if (run.stop().isRequested()) {
            sending->abort();
            thread.finish(shutdownTimeout);
            return base::fail(base::ErrorCode::Stopped, QStringLiteral("history-server"));
        }
        if (sending->silenceTime() > maxSilence)
            sending->dropConnection();
        const double rows = double(progress->sent + progress->pending);
        if (rows > 0)
            line.update({double(progress->sent) / rows});
    }
    thread.finish(shutdownTimeout, [sending] { sending->disconnect(); });
    return answer.get();
}

QString savedServerText(const session::HistoryServerChoice& choice)
{
    return (choice.isFixedByEnvironment
                ? translate("cli", "Bench name saved; the server is set by "
                                   "SERVODESK_HISTORY_SERVER")
                : translate("cli", "Server and bench name saved; the desktop program uses them "
                                   "too")) +
           QLatin1Char('\n');
}

base::Result<Exit> runSync(Run& run, const Values& values)
{
    session::Settings settings;
    session::HistoryServerChoice choice = session::historyServerChoice(settings);
    if (const auto server = values.option("--server")) {
        choice.address = *server;
        choice.isFixedByEnvironment = false;
    }
    choice.bench = values.option("--bench").value_or(choice.bench).trimmed();
    if (choice.address.trimmed().isEmpty())
        return badArgument(translate("cli", "no history server is set; set one with --server or "
                                            "SERVODESK_HISTORY_SERVER"));
    const auto address = history::ServerAddress::parse(choice.address);
    if (!address)
        return tl::unexpected(address.error());
    const auto sent = send(run, choice);
    const bool remember = values.has("--remember");
    if (!sent) {
        if (remember)
            run.console().printMessage(translate("cli", "Server and bench name were not saved"));
        return tl::unexpected(sent.error());
    }
    if (remember) {
        if (const auto kept = session::setHistoryServerChoice(settings, choice); !kept)
            return tl::unexpected(kept.error());
    }
    QString words =
        translate("cli", "%n row(s) sent to %1 from bench %2; the server is now up to date",
                  nullptr, int(sent->sent))
            .arg(address->displayText(), choice.bench) +
        QLatin1Char('\n');
    if (remember)
        words += savedServerText(choice);
    run.finish(Json::object()
                   .add("server", address->displayText())
                   .add("bench", choice.bench)
                   .add("sent", sent->sent)
                   .add("remembered", remember),
               words);
    return Exit::Success;
}
} // namespace

Command historySyncCommand()
{
    return {
        "history sync",
        QT_TRANSLATE_NOOP("cli", "send history entries that a history server (PostgreSQL) does not "
                                 "have yet; no port is needed"),
        {},
        {{"--server",
          QT_TRANSLATE_NOOP("cli",
                            "connection string, for example postgresql://USER@HOST/DATABASE, "
                            "without a password (store the password in ~/.pgpass); default: "
                            "SERVODESK_HISTORY_SERVER, or else the remembered server. By default, "
                            "a server on another computer needs a "
                            "valid TLS certificate; to change this, use ?sslmode=..."),
          "STRING"},
         {"--bench", QT_TRANSLATE_NOOP("cli", "name of this bench on the server"), "NAME"},
         {"--remember",
          QT_TRANSLATE_NOOP("cli", "use this server and name from now on, in the desktop program "
                                   "too; saved once everything has been sent")}},
        runSync};
}
} // namespace cli
