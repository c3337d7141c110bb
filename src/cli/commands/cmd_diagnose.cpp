// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands.h"
#include "cli/input/arguments.h"
#include "cli/output/progress.h"
#include "cli/run.h"
#include "cli/translate.h"
#include "session/search/diagnosis_spec.h"
#include "text/diagnosis_text.h"
#include "text/error_text.h"

namespace cli {
namespace {
using base::Cause;

struct Findings {
    base::Diagnosis diagnosis;
    QStringList evidence;
    QString cause;
    QString remedy;
};

bool isPortError(const base::Error& error)
{
    switch (error.code) {
    case base::ErrorCode::PortMissing:
    case base::ErrorCode::PortPermission:
    case base::ErrorCode::PortBusy:
    case base::ErrorCode::PortFailed:
    case base::ErrorCode::RateUnsupported:
        return true;
    default:
        return false;
    }
}

Findings ofClosedPort(const base::Error& error)
{
    const text::Description words = text::describe(error);
    Findings findings;
    findings.diagnosis.cause = jobs::causeOf(error);
    findings.cause = words.message;
    findings.remedy = words.remedy;
    if (!words.cause.isEmpty())
        findings.evidence << words.cause;
    return findings;
}

/// A port of most adapters that are in use, so that the remedy names what takes it away.
base::Result<device::Context> noAdapter()
{
    const QString claimed =
        transport::adaptersClaimedByBrltty().isEmpty() ? QString() : QStringLiteral(", brltty");
    return base::fail(base::ErrorCode::PortMissing, QStringLiteral("open"),
                      QStringLiteral("/dev/ttyUSB*") + claimed);
}

Json jsonOf(const Findings& findings)
{
    QStringList also;
    for (const Cause cause : findings.diagnosis.also)
        also << base::causeName(cause);
    const bool isStopped = findings.diagnosis.stopped;
    Json json =
        Json::object()
            .add("cause", isStopped ? Json() : Json(base::causeName(findings.diagnosis.cause)))
            .add("also", isStopped ? QStringList() : also)
            .add("evidence", findings.evidence)
            .add("remedy", isStopped ? Json() : Json(findings.remedy));
    if (isStopped)
        json.add("stopped", true);
    return json;
}

QString textOf(const Findings& findings)
{
    if (findings.diagnosis.stopped)
        return QLatin1Char('\n') + translate("cli", "The diagnosis was stopped early.") +
               QLatin1Char('\n');
    const bool isFine = findings.diagnosis.cause == Cause::Found;
    QStringList lines{QString(),
                      isFine ? findings.cause : translate("cli", "Cause: %1").arg(findings.cause)};
    for (const Cause cause : findings.diagnosis.also)
        lines << translate("cli", "Also possible: %1").arg(text::causeText(cause));
    lines << (isFine ? findings.remedy : translate("cli", "What to do: %1").arg(findings.remedy));
    return lines.join(QLatin1Char('\n')) + QLatin1Char('\n');
}

Exit finish(Run& run, const Findings& findings)
{
    run.finish(jsonOf(findings), textOf(findings));
    const bool isFine = findings.diagnosis.cause == Cause::Found && !findings.diagnosis.stopped;
    return isFine ? Exit::Success : Exit::Failed;
}

base::Result<Exit> runDiagnose(Run& run, const Values& values)
{
    std::optional<std::vector<int>> bauds;
    if (const auto list = values.option("--bauds")) {
        const auto rates = parseBauds(*list);
        if (!rates)
            return tl::unexpected(rates.error());
        bauds = *rates;
    }
    const bool hasNoPort = run.globals().port.isEmpty() && session::adapters().empty();
    const auto context = hasNoPort ? noAdapter() : run.context();
    if (!context && isPortError(context.error())) {
        const Findings findings = ofClosedPort(context.error());
        run.console().print(findings.evidence.join(QLatin1Char('\n')) + QLatin1Char('\n'));
        return finish(run, findings);
    }
    if (!context)
        return tl::unexpected(context.error());
    jobs::DiagnosisSpec spec =
        session::diagnosisSpec({.name = run.portName(), .protocol = run.globals().protocol});
    if (bauds)
        spec.bauds = *bauds;
    Findings findings;
    base::Result<jobs::DiagnosisReport> report;
    {
        ProgressLine line(run.console(), translate("cli", "Searching"));
        report = jobs::diagnose(
            *context, spec, [&line](const jobs::Progress& progress) { line.update(progress); },
            [&](const base::Evidence& evidence) {
                const QString words = text::evidenceText(evidence);
                findings.evidence << words;
                run.console().showStatus(QString());
                run.console().print(words + QLatin1Char('\n'));
            });
    }
    if (!report)
        return tl::unexpected(report.error());
    findings.diagnosis = std::move(report->diagnosis);
    findings.cause = text::causeText(findings.diagnosis.cause);
    findings.remedy = text::causeRemedy(findings.diagnosis.cause);
    return finish(run, findings);
}
} // namespace

Command diagnoseCommand()
{
    return {"diagnose",
            QT_TRANSLATE_NOOP("cli", "find out why a servo is not replying; writes nothing"),
            {},
            {{"--bauds", QT_TRANSLATE_NOOP("cli", "other baud rates to try"), "all|N,N…"}},
            runDiagnose};
}
} // namespace cli
