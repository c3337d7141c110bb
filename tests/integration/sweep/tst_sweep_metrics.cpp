// SPDX-License-Identifier: GPL-3.0-or-later
// Every figure of a sweep test worked out again from its readings, by a reader of its own: of the
// program it knows the files, and of the figures what jobs/sweep/leg_meter.h and sweep_statistics.h
// say of them. Nothing of the program's arithmetic is called. JSON, CSV of the legs and PDF are of
// one run.
#include "support/cli_program.h"
#include "support/test_main.h"
#include "support/text.h"
#include "unit/results/sweep_example.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QProcess>
#include <QRegularExpression>
#include <QTest>

#include <cmath>
#include <map>
#include <numeric>

using support::CliProgram;
using support::ProgramResult;
using support::utf8;

namespace {
constexpr double clockMs = 0.002; ///< to which times are written
constexpr double never = 1e9;

struct Reading {
    double ms = 0;
    int leg = 0;
    double position = NAN;
    double load = NAN;
    double current = NAN;
    double voltage = NAN;
    double temperature = NAN;
    bool moving = false;
    int status = 0;
    double gap = 0; ///< ms since the one before
};
using Readings = std::vector<Reading>;

std::vector<std::map<QString, QString>> csvRows(const QString& path)
{
    QFile file(path);
    std::vector<std::map<QString, QString>> rows;
    if (!file.open(QIODevice::ReadOnly))
        return rows;
    QStringList names;
    for (const QString& line : QString::fromUtf8(file.readAll()).split(QLatin1Char('\n'))) {
        if (line.isEmpty() || line.startsWith(QLatin1Char('#')))
            continue;
        const QStringList cells = line.split(QLatin1Char(','));
        if (names.isEmpty()) {
            for (const QString& name : cells)
                names << name.section(QLatin1Char('['), 0, 0);
            continue;
        }
        auto& row = rows.emplace_back();
        for (int i = 0; i < cells.size() && i < names.size(); ++i)
            row[names.at(i)] = cells.at(i);
    }
    return rows;
}

double number(const QString& cell)
{
    return cell.isEmpty() ? NAN : cell.toDouble();
}

Readings readingsOf(const QString& path, int servo)
{
    Readings found;
    const QString own = QString::number(servo);
    double before = 0;
    for (auto& row : csvRows(path)) {
        if (row[utf8("servo")] != own || !row[utf8("marks")].isEmpty())
            continue;
        const auto cell = [&](const char* key) { return number(row[own + utf8(".") + utf8(key)]); };
        Reading one;
        one.ms = number(row[utf8("time_us")]) / 1000;
        one.leg = int(cell("leg"));
        one.position = cell("position");
        one.load = cell("load");
        one.current = cell("current");
        one.voltage = cell("voltage");
        one.temperature = cell("temperature");
        one.moving = cell("moving") == 1;
        one.status = int(cell("status"));
        one.gap = one.ms - before;
        before = one.ms;
        found.push_back(one);
    }
    return found;
}

double mean(const std::vector<double>& values)
{
    return std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
}

double largest(const std::vector<double>& values)
{
    return *std::max_element(values.begin(), values.end());
}

double smallest(const std::vector<double>& values)
{
    return *std::min_element(values.begin(), values.end());
}

/// Where the straight line between two readings is at `level`.
double crossed(const Reading& a, const Reading& b, double level)
{
    return a.ms + (b.ms - a.ms) * (level - a.position) / (b.position - a.position);
}

/// What one leg comes to, by the definitions.
class Leg {
public:
    Leg(const QJsonObject& json, const QJsonObject& axis, Readings readings, double goalMs)
        : m_readings(std::move(readings))
        , m_at(goalMs)
        , m_start(json[utf8("start")].toDouble())
        , m_target(json[utf8("target")].toDouble())
        , m_way(std::abs(m_target - m_start))
        , m_tolerance(axis[utf8("tolerance")].toDouble())
        , m_speed(axis[utf8("speed")].toDouble())
        , m_acceleration(axis[utf8("acceleration")].toDouble())
    {}

    double samples() const { return double(m_readings.size()); }

    /// First within tolerance, between two readings.
    double timeToTarget() const
    {
        Reading before;
        before.ms = m_at;
        before.position = m_start;
        for (const Reading& one : m_readings) {
            const double edge = m_target - sense() * m_tolerance;
            if (gone(one) >= sense() * (edge - m_start))
                return crossed(before, one, edge) - m_at;
            before = one;
        }
        return never;
    }

    /// The readings of the last fifth of those from `first` on.
    std::vector<double> lastFifthOf(std::size_t first) const
    {
        const double end = m_readings.back().ms;
        const double from = end - (end - m_readings[first].ms) / 5;
        std::vector<double> places;
        for (std::size_t i = first; i < m_readings.size(); ++i) {
            if (m_readings[i].ms >= from)
                places.push_back(m_readings[i].position);
        }
        return places;
    }

    /// The first reading after which it never left tolerance and noise.
    std::size_t stayedSince() const
    {
        std::size_t first = 0;
        const double arrival = m_at + timeToTarget();
        while (m_readings[first].ms < arrival)
            ++first;
        const auto tail = lastFifthOf(first);
        double noise = 0;
        for (const double place : tail)
            noise = std::max(noise, std::abs(place - mean(tail)));
        noise = std::min(noise, 2.0);
        std::size_t since = m_readings.size();
        while (since > first &&
               std::abs(m_readings[since - 1].position - m_target) <= m_tolerance + noise)
            --since;
        return since;
    }

    double reached() const { return mean(lastFifthOf(stayedSince())); }
    double steadyError() const { return reached() - m_target; }

    double settling() const
    {
        std::size_t since = stayedSince();
        if (since == 0 || m_readings[since - 1].ms < m_at + timeToTarget())
            return 0;
        while (std::abs(m_readings[since].position - m_target) > m_tolerance)
            ++since;
        const Reading& out = m_readings[since - 1];
        const double edge = m_target + std::copysign(m_tolerance, out.position - m_target);
        return crossed(out, m_readings[since], edge) - m_at - timeToTarget();
    }

    double overshootSteps() const
    {
        std::vector<double> beyond;
        const double rest = reached();
        for (const Reading& one : m_readings)
            beyond.push_back(sense() * (one.position - rest));
        const double maximum = largest(smoothed(beyond));
        const auto tail = lastFifthOf(stayedSince());
        double spread = 0;
        for (const double place : tail)
            spread = std::max(spread, std::abs(place - mean(tail)));
        const double noise = tail.size() < 10 ? 3.5 : std::max(2.0, std::min(3.5, 2 * spread));
        return maximum > noise ? maximum : 0;
    }
    double overshoot() const { return 100 * overshootSteps() / m_way; }

    double meanSpeed() const { return 0.8 * m_way / (passed(0.9) - passed(0.1)) * 1000; }

    /// The steepest stretch, by the line that fits it best less its standard error, and no steeper
    /// than its ends are with 8 steps of noise.
    double topSpeed() const
    {
        const double least = std::max(std::min(60.0, m_way / 6), m_way / 16);
        double top = 0;
        std::size_t from = 0;
        const auto longEnough = [&](std::size_t a, std::size_t b) {
            return m_readings[b].ms - m_readings[a].ms >= 40 &&
                   gone(m_readings[b]) - gone(m_readings[a]) >= least;
        };
        for (std::size_t to = 0; to < m_readings.size(); ++to) {
            while (to - from >= 3 && longEnough(from + 1, to))
                ++from;
            if (to - from >= 2 && longEnough(from, to))
                top = std::max(top, std::min(fitted(from, to), endToEnd(from, to, 8)));
        }
        return top;
    }

    /// Behind the path it was told, as that was one reading earlier.
    double followingError() const
    {
        std::vector<double> behind;
        double before = m_at;
        for (const Reading& one : m_readings) {
            const double since = one.ms - m_at - std::min(one.ms - before, 5.0);
            behind.push_back(std::min(planned(since / 1000), m_way) - gone(one));
            before = one.ms;
        }
        return std::max(0.0, largest(smoothed(behind)));
    }

    std::vector<double> of(double Reading::*member) const
    {
        std::vector<double> values;
        for (const Reading& one : m_readings)
            values.push_back(std::abs(one.*member));
        return values;
    }
    int alarms() const
    {
        int bits = 0;
        for (const Reading& one : m_readings)
            bits |= one.status;
        return bits;
    }
    /// It never said that it moves while it stood for half a second.
    bool isFlagPlausible() const
    {
        const double latest = m_at + timeToTarget() + settling() + 500;
        return std::none_of(m_readings.begin(), m_readings.end(),
                            [&](const Reading& one) { return one.moving && one.ms > latest; });
    }

private:
    double sense() const { return m_target < m_start ? -1 : 1; }
    double gone(const Reading& one) const { return sense() * (one.position - m_start); }

    double planned(double seconds) const
    {
        if (seconds <= 0)
            return 0;
        if (m_acceleration <= 0)
            return m_speed * seconds;
        const double top = std::min(m_speed, std::sqrt(m_way * m_acceleration));
        const double ramp = top / m_acceleration;
        const double whole = ramp + m_way / top;
        if (seconds < ramp)
            return m_acceleration / 2 * seconds * seconds;
        if (seconds < whole - ramp)
            return m_acceleration / 2 * ramp * ramp + top * (seconds - ramp);
        if (seconds < whole)
            return m_way - m_acceleration / 2 * (whole - seconds) * (whole - seconds);
        return m_way;
    }

    /// Means of the 10 ms before each.
    std::vector<double> smoothed(const std::vector<double>& values) const
    {
        std::vector<double> means;
        for (std::size_t to = 0; to < values.size(); ++to) {
            double sum = 0;
            int count = 0;
            for (std::size_t i = to + 1;
                 i-- > 0 && m_readings[to].ms - m_readings[i].ms <= 10.0005;) {
                sum += values[i];
                ++count;
            }
            means.push_back(sum / count);
        }
        return means;
    }

    double passed(double share) const
    {
        Reading before;
        before.ms = m_at;
        before.position = m_start;
        for (const Reading& one : m_readings) {
            if (gone(one) >= share * m_way)
                return crossed(before, one, m_start + sense() * share * m_way);
            before = one;
        }
        return never;
    }

    double endToEnd(std::size_t from, std::size_t to, double noise) const
    {
        return (gone(m_readings[to]) - gone(m_readings[from]) + noise) * 1000 /
               (m_readings[to].ms - m_readings[from].ms);
    }

    double fitted(std::size_t from, std::size_t to) const
    {
        const double n = double(to - from + 1);
        double t = 0;
        double x = 0;
        for (std::size_t i = from; i <= to; ++i) {
            t += m_readings[i].ms / 1000 / n;
            x += gone(m_readings[i]) / n;
        }
        double tt = 0;
        double tx = 0;
        double xx = 0;
        for (std::size_t i = from; i <= to; ++i) {
            const double dt = m_readings[i].ms / 1000 - t;
            const double dx = gone(m_readings[i]) - x;
            tt += dt * dt;
            tx += dt * dx;
            xx += dx * dx;
        }
        const double slope = tx / tt;
        return slope - std::sqrt(std::max(0.0, xx - slope * tx) / (n - 2) / tt);
    }

    Readings m_readings;
    double m_at;
    double m_start;
    double m_target;
    double m_way;
    double m_tolerance;
    double m_speed;
    double m_acceleration;
};

Readings ofLeg(const Readings& all, int leg)
{
    Readings found;
    for (const Reading& one : all) {
        if (one.leg == leg && !std::isnan(one.position))
            found.push_back(one);
    }
    return found;
}

/// When each leg's goal had been sent, ms on the readings' clock: "move 1 leg 3".
std::map<int, double> goalsOf(const QString& path, int servo)
{
    std::map<int, double> goals;
    const QString begins = utf8("move %1 leg ").arg(servo);
    for (auto& row : csvRows(path)) {
        const QString mark = row[utf8("marks")];
        if (mark.startsWith(begins))
            goals[mark.mid(begins.size()).toInt()] = number(row[utf8("time_us")]) / 1000;
    }
    return goals;
}

QByteArray mismatchText(const QString& what, double found, double reported)
{
    return (what + utf8(": %1 from the readings, %2 in the report").arg(found).arg(reported))
        .toUtf8();
}

#define NEAR(what, found, reported, by)                                                            \
    do {                                                                                           \
        const double one = found;                                                                  \
        const double other = reported;                                                             \
        QVERIFY2(std::abs(one - other) <= (by), mismatchText(what, one, other).constData());       \
    } while (false)

struct Summary {
    std::map<QString, std::vector<double>> values; ///< by figure, a value a leg or target
};

double sigma(const std::vector<double>& values)
{
    double sum = 0;
    for (const double value : values)
        sum += std::pow(value - mean(values), 2);
    return std::sqrt(sum / double(values.size() - 1));
}

/// The figures that are of targets, from the legs' steady errors.
void addTargets(Summary& summary, const std::vector<QJsonObject>& legs,
                const std::vector<double>& errors)
{
    std::map<double, std::map<bool, std::vector<double>>> sides;
    for (std::size_t i = 0; i < legs.size(); ++i) {
        const double target = legs[i][utf8("target")].toDouble();
        sides[target][target > legs[i][utf8("start")].toDouble()].push_back(errors[i]);
    }
    for (auto& [target, both] : sides) {
        if (!both[false].empty() && !both[true].empty())
            summary.values[utf8("hysteresis")].push_back(
                std::abs(mean(both[true]) - mean(both[false])));
        std::vector<double> sigmas;
        std::vector<double> ranges;
        for (const bool up : {false, true}) {
            if (both[up].size() < 2)
                continue;
            sigmas.push_back(sigma(both[up]));
            ranges.push_back(largest(both[up]) - smallest(both[up]));
        }
        if (sigmas.empty())
            continue;
        summary.values[utf8("repeatability_sigma")].push_back(largest(sigmas));
        summary.values[utf8("repeatability_range")].push_back(largest(ranges));
    }
}
} // namespace

class TestSweepMetrics : public QObject {
    Q_OBJECT

private:
    void checkLeg(const QJsonObject& json, const Leg& leg);
    void collect(const Leg& leg);
    void checkMetrics(const QJsonArray& metrics, int servo);
    QString readingsPath() const { return m_legsPath.chopped(4) + utf8(".readings.csv"); }
    void runSweep(const QStringList& options);
    bool hasGap() const;
    void checkServo(int servo);
    void checkLegsFile();
    void checkPdf();

    CliProgram m_cli;
    QJsonObject m_report;
    QString m_legsPath;
    Summary m_summary;
    int m_leg = 0; ///< looked at last

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(utf8(".*"))); }

    void everyMetric_data();
    void everyMetric();
};

void TestSweepMetrics::checkLeg(const QJsonObject& json, const Leg& leg)
{
    m_leg = json[utf8("leg")].toInt();
    const QString name = utf8("leg %1 ").arg(m_leg);
    const auto reported = [&](const char* key) { return json[utf8(key)].toDouble(NAN); };
    NEAR(name + utf8("samples"), leg.samples(), reported("samples"), 0);
    NEAR(name + utf8("time"), leg.timeToTarget(), reported("time_ms"), clockMs);
    NEAR(name + utf8("settling"), leg.settling(), reported("settling_ms"), 0.01);
    NEAR(name + utf8("reached"), leg.reached(), reported("reached"), 0.01);
    NEAR(name + utf8("steady error"), leg.steadyError(), reported("steady_error"), 0.01);
    NEAR(name + utf8("overshoot steps"), leg.overshootSteps(), reported("overshoot_steps"), 0.01);
    NEAR(name + utf8("overshoot"), leg.overshoot(), reported("overshoot"), 0.01);
    NEAR(name + utf8("mean speed"), leg.meanSpeed(), reported("mean_speed"), 0.1);
    NEAR(name + utf8("top speed"), leg.topSpeed(), reported("top_speed"),
         reported("top_speed") / 1000);
    NEAR(name + utf8("following"), leg.followingError(), reported("following_error"), 0.05);
    const auto current = leg.of(&Reading::current);
    NEAR(name + utf8("peak current"), largest(current), reported("current_peak"), 1e-6);
    NEAR(name + utf8("mean current"), mean(current), reported("current_mean"), 1e-6);
    const auto load = leg.of(&Reading::load);
    NEAR(name + utf8("peak load"), largest(load), reported("load_peak"), 1e-6);
    NEAR(name + utf8("mean load"), mean(load), reported("load_mean"), 1e-6);
    NEAR(name + utf8("voltage"), smallest(leg.of(&Reading::voltage)), reported("voltage_min"),
         1e-6);
    NEAR(name + utf8("temperature"), largest(leg.of(&Reading::temperature)),
         reported("temperature_max"), 1e-6);
    NEAR(name + utf8("alarms"), leg.alarms(), reported("alarms"), 0);
    QVERIFY(!json[utf8("missed")].toBool() && leg.timeToTarget() < never);
    QCOMPARE(leg.isFlagPlausible(), !json[utf8("flag_wrong")].toBool());
}

void TestSweepMetrics::collect(const Leg& leg)
{
    const auto add = [&](const char* key, double value) {
        m_summary.values[utf8(key)].push_back(value);
    };
    add("time_to_target", leg.timeToTarget());
    add("settling", leg.settling());
    add("overshoot", leg.overshoot());
    add("steady_error", leg.steadyError());
    add("following_error", leg.followingError());
    add("mean_speed", leg.meanSpeed());
    add("top_speed", leg.topSpeed());
    add("current_peak", largest(leg.of(&Reading::current)));
    add("current_mean", mean(leg.of(&Reading::current)));
    add("load_peak", largest(leg.of(&Reading::load)));
    add("load_mean", mean(leg.of(&Reading::load)));
    add("voltage_min", smallest(leg.of(&Reading::voltage)));
    add("temperature_max", largest(leg.of(&Reading::temperature)));
}

void TestSweepMetrics::checkMetrics(const QJsonArray& metrics, int servo)
{
    const QStringList means{utf8("time_to_target"), utf8("mean_speed"), utf8("top_speed")};
    const QStringList ofTargets{utf8("hysteresis"),          utf8("repeatability_sigma"),
                                utf8("repeatability_range"), utf8("following_error_relative"),
                                utf8("phase_lag"),           utf8("readings_per_period")};
    int checked = 0;
    for (const QJsonValue& metric : metrics) {
        const QString key = metric[utf8("metric")].toString();
        if (metric[utf8("servo")].toInt() != servo)
            continue;
        ++checked;
        const auto found = m_summary.values.find(key);
        const double value = metric[utf8("value")].toDouble(NAN);
        if (found == m_summary.values.end()) {
            QVERIFY2(metric[utf8("mean")].isNull(), qPrintable(key));
            if (ofTargets.contains(key)) { // no target twice, or from both sides; no sine
                QVERIFY2(metric[utf8("value")].isNull(), qPrintable(key));
                QCOMPARE(metric[utf8("count")].toInt(), 0);
                continue;
            }
            NEAR(key, 0, value, 0); // a number of what did not happen
            QVERIFY2(metric[utf8("count")].toInt() > 0, qPrintable(key));
            continue;
        }
        const std::vector<double>& values = found->second;
        const double by = std::max(0.01, std::abs(value) / 1000);
        QCOMPARE(metric[utf8("count")].toInt(), int(values.size()));
        NEAR(key + utf8(" mean"), mean(values), metric[utf8("mean")].toDouble(), by);
        NEAR(key + utf8(" min"), smallest(values), metric[utf8("min")].toDouble(), by);
        NEAR(key + utf8(" max"), largest(values), metric[utf8("max")].toDouble(), by);
        double judged = largest(values);
        if (means.contains(key))
            judged = mean(values);
        else if (key == utf8("voltage_min"))
            judged = smallest(values);
        else if (key == utf8("steady_error"))
            judged = std::max(std::abs(smallest(values)), std::abs(largest(values)));
        NEAR(key, judged, value, by);
    }
    QCOMPARE(checked, 24);
}

void TestSweepMetrics::checkServo(int servo)
{
    const auto all = readingsOf(readingsPath(), servo);
    auto goals = goalsOf(readingsPath(), servo);
    std::vector<QJsonObject> legs;
    for (const QJsonValue& leg : m_report[utf8("legs")].toArray()) {
        if (leg[utf8("servo")].toInt() == servo)
            legs.push_back(leg.toObject());
    }
    QVERIFY(legs.size() >= 4);
    QJsonObject axis;
    for (const QJsonValue& one : m_report[utf8("servos")].toArray()) {
        if (one[utf8("id")].toInt() == servo)
            axis = one[utf8("axis")].toObject();
    }
    QCOMPARE(goals.size(), legs.size());
    const double zero = goals[1] - legs[0][utf8("at_ms")].toDouble();
    m_summary = {};
    std::vector<double> errors;
    double startTemperature = NAN;
    for (const Reading& one : all) { // the last before the first leg
        if (one.leg == 1)
            break;
        if (!std::isnan(one.temperature))
            startTemperature = one.temperature;
    }
    for (const QJsonObject& json : legs) {
        const int number = json[utf8("leg")].toInt();
        NEAR(utf8("goal of leg %1").arg(number), goals[number] - zero,
             json[utf8("at_ms")].toDouble(), clockMs);
        const Leg leg(json, axis, ofLeg(all, number), goals[number]);
        checkLeg(json, leg);
        if (QTest::currentTestFailed())
            return;
        collect(leg);
        errors.push_back(leg.steadyError());
    }
    addTargets(m_summary, legs, errors);
    for (const double celsius : m_summary.values[utf8("temperature_max")])
        m_summary.values[utf8("temperature_rise")].push_back(celsius - startTemperature);
    checkMetrics(m_report[utf8("metrics")].toArray(), servo);
}

/// The table of the legs has the JSON's figures, digit by digit.
void TestSweepMetrics::checkLegsFile()
{
    auto rows = csvRows(m_legsPath);
    const QJsonArray legs = m_report[utf8("legs")].toArray();
    QCOMPARE(rows.size(), std::size_t(legs.size()));
    const std::map<QString, QString> names{{utf8("at"), utf8("at_ms")},
                                           {utf8("span"), utf8("span_ms")},
                                           {utf8("time"), utf8("time_ms")},
                                           {utf8("settling"), utf8("settling_ms")}};
    int compared = 0;
    for (auto& row : rows) {
        QJsonObject json;
        for (const QJsonValue& leg : legs) {
            if (leg[utf8("servo")].toInt() == row[utf8("servo")].toInt() &&
                leg[utf8("leg")].toInt() == row[utf8("leg")].toInt())
                json = leg.toObject();
        }
        for (auto& [column, cell] : row) {
            const auto renamed = names.find(column);
            const QJsonValue reported = json[renamed == names.end() ? column : renamed->second];
            QVERIFY2(!reported.isUndefined(), qPrintable(column));
            if (reported.isDouble()) {
                QCOMPARE(cell.toDouble(), reported.toDouble());
                ++compared;
            }
        }
    }
    QVERIFY(compared > 20 * int(rows.size()));
}

/// As another program reads it.
void TestSweepMetrics::checkPdf()
{
    const QString path = m_cli.dataFolder() + utf8("/paper.pdf");
    const ProgramResult made = m_cli.run({utf8("sweep-report"), utf8("1"), path});
    QVERIFY2(made.exit == 0, qPrintable(made.err));
    QProcess reader;
    reader.start(utf8("pdftotext"), {utf8("-layout"), path, utf8("-")});
    QVERIFY(reader.waitForFinished());
    QStringList words = QString::fromUtf8(reader.readAllStandardOutput())
                            .split(QRegularExpression(utf8("\\s+")), Qt::SkipEmptyParts);
    const QSet<QString> paper(words.begin(), words.end());
    int compared = 0;
    const auto check = [&](const QJsonValue& row, std::initializer_list<const char*> keys) {
        for (const char* key : keys) {
            const QJsonValue value = row[utf8(key)];
            if (!value.isDouble())
                continue;
            ++compared;
            const QString number = key == utf8("reached") // a mean of whole steps
                                       ? QString::number(value.toDouble(), 'f', 1)
                                       : sweep_example::written(value.toDouble());
            QVERIFY2(paper.contains(number), qPrintable(utf8(key) + QLatin1Char(' ') + number));
        }
    };
    for (const QJsonValue& metric : m_report[utf8("metrics")].toArray())
        check(metric, {"value", "mean", "min", "max"});
    for (const QJsonValue& leg : m_report[utf8("legs")].toArray())
        check(leg, {"target", "reached", "time_ms", "settling_ms", "overshoot", "steady_error",
                    "following_error", "current_peak", "load_peak"});
    QVERIFY(compared > 100);
}

void TestSweepMetrics::everyMetric_data()
{
    QTest::addColumn<QString>("servos");
    QTest::addColumn<QString>("options");
    QTest::newRow("defects, both sides")
        << utf8("sim:sts3215@1+overshoot=4+static-error=5+supply-ohms=0.4+rest-hysteresis=12")
        << utf8("1 --from 1500 --to 2500 --both-sides --dwell 400 --cycles 2 --speed 3000");
    QTest::newRow("two servos, acceleration, noise")
        << utf8("sim:sts3215@1+noise=1,sts3215@2+overshoot=8")
        << utf8("1 2 --from 1700 --to 2500 --delay 1300 --cycles 2 --speed 3000 "
                "--acceleration 100");
}

void TestSweepMetrics::runSweep(const QStringList& options)
{
    QFile::remove(m_cli.dataFolder() + utf8("/history.sqlite"));
    const ProgramResult result = m_cli.run(QStringList{utf8("sweep")} + options
                                           << utf8("--report") << m_legsPath << utf8("--json"));
    m_report = result.json();
    QVERIFY2(!m_report.isEmpty(), qPrintable(result.err));
    QCOMPARE(m_report[utf8("end")].toString(), utf8("finished"));
}

/// A busy machine may keep the program waiting while a leg goes on. What it then has too few
/// readings for it leaves out, and the definitions here have no words for that.
bool TestSweepMetrics::hasGap() const
{
    constexpr double longGapMs = 50;
    for (const QJsonValue& servo : m_report[utf8("servos")].toArray()) {
        for (const Reading& one : readingsOf(readingsPath(), servo[utf8("id")].toInt())) {
            if (one.leg > 0 && one.gap > longGapMs)
                return true;
        }
    }
    return false;
}

void TestSweepMetrics::everyMetric()
{
    QFETCH(QString, servos);
    QFETCH(QString, options);
    m_legsPath = m_cli.dataFolder() + utf8("/legs.csv");
    m_cli.setPort(servos);
    int attempts = 0;
    do {
        runSweep(options.split(QLatin1Char(' ')));
        if (QTest::currentTestFailed())
            return;
    } while (hasGap() && ++attempts < 10);
    for (const QJsonValue& servo : m_report[utf8("servos")].toArray()) {
        const int id = servo[utf8("id")].toInt();
        checkServo(id);
        if (QTest::currentTestFailed()) {
            for (const Reading& one : readingsOf(readingsPath(), id)) {
                if (one.leg == m_leg) // Qt Test shows 2000 lines
                    qInfo("leg %d, %.3f ms, at %g", one.leg, one.ms, one.position);
            }
            return;
        }
    }
    checkLegsFile();
    checkPdf();
}

SERVODESK_GUILESS_TEST(TestSweepMetrics)
#include "tst_sweep_metrics.moc"
