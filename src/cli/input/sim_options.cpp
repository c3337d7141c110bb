// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/input/sim_options.h"

#include <CLI/CLI.hpp>
#include <QStringList>

namespace cli {
namespace {
constexpr int usageError = 2;

struct Raw {
    std::string preset = "demo";
    std::string servos;
    int baud = 0;
    std::string link;
    std::string state;
    double seconds = 0;
    bool wireTime = false;
    int latencyMs = 0;
    bool echo = false;
    std::vector<std::string> faults;
    int epromMs = 0;
    std::uint64_t seed = 1;
};

QString text(const std::string& local)
{
    return QString::fromLocal8Bit(local.c_str());
}

void describe(CLI::App& app, Raw& raw)
{
    auto* preset =
        app.add_option(
               "--preset", raw.preset,
               "A ready-made bus: demo, trouble, modbus, lx, sweep, new-arm, so101; line and "
               "line-trouble, a bag of six servos that are plugged in one after the other: "
               "SIGUSR1 or the line \"next\" on standard input puts the next one on the "
               "wire in place of the one before, \"unplug\" leaves the wire empty, "
               "\"plug N\" adds the Nth")
            ->capture_default_str();
    app.add_option(
           "--servos", raw.servos,
           "The servos, MODEL@ID or MODEL@ID:BAUD each: sts3215@1,sts3250@2,scs15@3. Their "
           "defects stand behind them: sts3215@1+overshoot=5+rest-hysteresis=12. Known "
           "are rest-hysteresis and static-error (steps), overshoot (% of the way), speed "
           "(1 is healthy), speed-per-load, noise (steps), moving (0 or 1: stuck flag), "
           "load-friction (N·m), stop (degrees), hand (degrees/s: a hand turns the shaft "
           "while torque is off), supply-ohms, ambient (°C), firmware-lost "
           "(0 or 1: stays in its bootloader, as after an interrupted update). Firmware that "
           "behaves differently, 1 for yes: deaf (hears nothing while it writes its "
           "EPROM; default: requests wait in its receive buffer), new-id-reply (an ID "
           "change is acknowledged with the new ID; default: the old one), run-to-goal "
           "(torque on after power-up runs to the goal register; default: holds), "
           "late-baud (a new rate holds from the next power-up on), staggered-ping "
           "(answers a broadcast PING in turn, 3 ms per ID); firmware-minor: its minor version; "
           "eprom-ms: time of an EPROM "
           "write. Behind a preset the same names are for all its servos: "
           "--preset demo+deaf=1")
        ->excludes(preset);
    app.add_option("--baud", raw.baud, "Rate of all servos without one of their own")
        ->check(CLI::PositiveNumber);
    app.add_option("--link", raw.link, "Make this symbolic link to the terminal");
    app.add_option("--state", raw.state, "Keep the EPROMs in this file from run to run");
    app.add_option("--seconds", raw.seconds, "End after this time")->check(CLI::PositiveNumber);
    app.add_flag("--wire-time", raw.wireTime, "Replies take as long as on a real wire");
    app.add_option("--latency-ms", raw.latencyMs, "Latency of the simulated adapter")
        ->check(CLI::Range(0, 10'000));
    app.add_flag("--echo", raw.echo, "The adapter returns what is sent");
    app.add_option("--fault", raw.faults,
                   "Faults and their probabilities: drop=0.01,corrupt=0.01,garbage=…,late=…,"
                   "late-ms=30,truncate=…,drop-request=…,mute=ID");
    app.add_option("--eprom-ms", raw.epromMs, "How long an EPROM write takes (default: 6)")
        ->check(CLI::Range(0, 10'000));
    app.add_option("--seed", raw.seed, "Seed of faults and noise")->capture_default_str();
}

session::SimOptions toOptions(const CLI::App& app, const Raw& raw)
{
    session::SimOptions options;
    options.preset = text(raw.preset);
    options.servos = text(raw.servos);
    if (app.count("--baud") > 0)
        options.baud = raw.baud;
    options.symlink = text(raw.link);
    options.stateFile = text(raw.state);
    if (app.count("--seconds") > 0)
        options.runFor = base::Duration(static_cast<base::Duration::rep>(raw.seconds * 1e6));
    options.wireTime = raw.wireTime;
    options.latency = std::chrono::milliseconds(raw.latencyMs);
    options.echo = raw.echo;
    QStringList faults;
    for (const std::string& fault : raw.faults)
        faults += text(fault);
    options.faults = faults.join(QLatin1Char(','));
    if (app.count("--eprom-ms") > 0)
        options.epromTime = std::chrono::milliseconds(raw.epromMs);
    options.seed = raw.seed;
    return options;
}
} // namespace

SimCommandLine parseSimCommandLine(int argc, const char* const* argv)
{
    CLI::App app("Simulated servo bus on a pseudo-terminal. The first line of output names it: "
                 "\"port: PATH\". SIGTERM or Ctrl-C ends the program.",
                 "servodesk-sim");
    app.footer("Exit codes: 0 done, 2 usage, 3 no terminal, 5 state file.");
    Raw raw;
    describe(app, raw);
    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        return {std::nullopt, app.help(), 0};
    } catch (const CLI::ParseError& error) {
        return {std::nullopt, std::string("servodesk-sim: ") + error.what() + "\n", usageError};
    }
    return {toOptions(app, raw), {}, 0};
}
} // namespace cli
