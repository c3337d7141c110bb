// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/sweep_text.h"

#include "report/bilingual.h"

#include <array>

namespace report {
namespace {
void fillHeading(SweepTexts& words)
{
    words.title = both("Sweep test report", "扫描测试报告");
    words.simulated = both("SIMULATED: no real servo was tested", "模拟：未测试真实舵机");
    words.bench = both("Bench", "测试台");
    words.test = both("Test", "测试内容");
    words.servos = both("Servos", "舵机");
    words.servo = both("Servo", "舵机");
    words.verdict = both("Verdict", "结论");
    words.identity = both("Identity", "标识");
    words.date = both("Date", "日期");
    words.operatorName = both("Operator", "操作员");
    words.note = both("Note", "备注");
    words.port = both("Port", "端口");
    words.length = both("Length of the run", "运行时长");
    words.sampling = both("Readings of each servo", "每个舵机的采样率");
    words.program = both("Program", "程序");
    words.end = both("End", "结束");
    words.endedBy = both("Ended by servo", "导致结束的舵机");
    words.label = both("Label", "标签");
    words.model = both("Model", "型号");
    words.firmware = both("Firmware", "固件");
    words.protocol = both("Protocol", "协议");
    words.id = both("ID", "ID");
}

void fillTest(SweepTexts& words)
{
    words.shape = both("Path", "路径");
    words.from = both("From", "起点");
    words.to = both("To", "终点");
    words.step = both("Step", "步数");
    words.period = both("Period", "周期");
    words.seed = both("Seed", "随机种子");
    words.points = both("Points", "目标点");
    words.pace = both("Pace", "节奏");
    words.pause = both("Time", "时间");
    words.cycles = both("Cycles", "循环次数");
    words.asLongAs = both("as long as the test lasts", "直到测试结束");
    words.duration = both("At most", "最长时间");
    words.speed = both("Speed", "速度");
    words.acceleration = both("Acceleration", "加速度");
    words.moveTime = both("Time of a move (ms)", "运动时间 (ms)");
    words.asTheServoHasIt = both("as the servo has it", "舵机自身设置");
    words.warmUp = both("Warm-up before, not measured", "预热（不计入测量）");
    words.afterwards = both("Afterwards", "结束后");
    words.holds = both("holds its place", "保持位置");
    words.releases = both("torque off", "扭矩关闭");
    words.stopsOn = both("Ends early on", "提前结束条件");
    words.stopOnAlarm = both("an alarm", "报警");
    words.stopOnStall = both("a stall", "堵转");
    words.stopOnFailure = both("the first failed line", "首个不合格项");
    words.onlyOnLostLink = both("a lost link only", "仅连接丢失");
    words.inSteps = both("In steps", "折算为步");
    words.tolerance = both("A target counts as reached within", "到位允差");
}

void fillFigures(SweepTexts& words)
{
    words.result = both("Result", "结果");
    words.figure = both("Figure", "指标");
    words.value = both("Value", "数值");
    words.unit = both("Unit", "单位");
    words.warnLimit = both("Warns", "警告限值");
    words.failLimit = both("Fails", "不合格限值");
    words.reason = both("Reason", "原因");
    words.within = both("within the limits", "在限值之内");
    words.over = both("above %1", "高于 %1");
    words.under = both("below %1", "低于 %1");
    words.noFeedback = both("not measured: no such feedback, or nothing to measure it by",
                            "未测量：没有此项反馈，或没有可测的内容");
    words.mean = both("Mean", "平均");
    words.lowest = both("Min", "最小");
    words.highest = both("Max", "最大");
    words.count = both("Count", "样本数");
    words.notMeasured = both("not measured", "未测量");
    words.limits = both("Limits", "限值");
    words.gradingNote = both(
        "Errors, overshoot, settling, following, phase lag, repeatability, current and load are "
        "judged by the worst leg, speeds and the time to target by their mean, and what is "
        "counted by its sum.",
        "判定依据：误差、超调、整定时间、跟随、相位滞后、重复性、电流和负载取最差的行程；"
        "速度和到位时间取平均值；计数项取总和。");
    words.hysteresisNote =
        both("Positions are those the servo reports: gear play beyond its encoder is not measured.",
             "位置均为舵机自身反馈：编码器之后的齿轮间隙未测量。");
}

void fillCharts(SweepTexts& words)
{
    words.positionChart = both("Position against goal", "位置与目标");
    words.goal = both("goal", "目标");
    words.position = both("position", "位置");
    words.timeAxis = both("Time, s", "时间，s");
    words.positionAxis = both("Position, step", "位置，步");
    words.histogram = both("Steady errors of the legs", "各程静差分布");
    words.errorAxis = both("Steady error, step", "静差，步");
    words.legsAxis = both("Legs", "程数");
    words.noSeries = both("No readings were kept for a chart.", "没有可绘图的读数。");
    words.noErrors = both("No steady error was measured.", "未测得静差。");
}

void fillLegs(SweepTexts& words)
{
    words.legs = both("Legs", "各程数据");
    words.legsShown =
        both("Of %1 legs the first 50, the last 50 and the 20 worst of the others are shown; the "
             "CSV and JSON files have all.",
             "共 %1 程，此处列出前 50 程、后 50 程及其余中最差的 20 程；CSV 和 JSON 文件含全部。");
    words.leg = both("Leg", "程");
    words.cycle = both("Cycle", "循环");
    words.at = both("At, s", "时刻，s");
    words.start = both("Start", "起始");
    words.target = both("Target", "目标");
    words.reached = both("Reached", "到达");
    words.timeToTarget = both("Time, ms", "到位，ms");
    words.settling = both("Settling, ms", "整定，ms");
    words.overshoot = both("Overshoot, %", "超调，%");
    words.steadyError = both("Error, step", "静差，步");
    words.meanSpeed = both("Mean speed, step/s", "平均速度，步/s");
    words.following = both("Following, step", "跟随误差，步");
    words.current = both("Peak current, mA", "峰值电流，mA");
    words.load = both("Peak load, %", "峰值负载，%");
    words.voltage = both("Min voltage, V", "最低电压，V");
    words.temperature = both("Temp., °C", "温度，°C");
    words.lost = both("Lost", "丢失");
    words.remarks = both("Remarks", "备注");
    words.missed = both("missed", "未到位");
    words.flagWrong = both("moving flag wrong", "运动标志错误");
    words.peak = both("Peak", "峰值");
}

void fillBus(SweepTexts& words)
{
    words.bus = both("Bus", "总线");
    words.asked = both("Readings and writes", "读写次数");
    words.timeouts = both("No answer", "通信超时");
    words.badChecksums = both("Wrong checksum", "校验错误");
    words.foreign = both("Foreign frames", "外来帧");
    words.late = both("Late answers", "迟到应答");
    words.gaps = both("Gaps", "中断");
    words.gapAt = both("At, s", "时刻，s");
    words.gapSpan = both("For, s", "持续，s");
    words.noGaps = both("The link was there all the time.", "连接始终正常。");
    words.parameters = both("Parameters at the start", "开始时的参数");
    words.address = both("Address", "地址");
    words.name = both("Register", "寄存器");
    words.raw = both("Raw", "原始值");
    words.area = both("Area", "区域");
    words.readAt = both("Read", "读取时间");
    words.none = both("none", "无");
}

struct Entry {
    const char* key;
    const char* english;
    const char* chinese;
};

constexpr std::array metricEntries{
    Entry{"time_to_target", "Time to target", "到位时间"},
    Entry{"settling", "Settling time", "整定时间"},
    Entry{"overshoot", "Overshoot", "超调"},
    Entry{"steady_error", "Steady error", "静差"},
    Entry{"hysteresis", "Hysteresis, both sides", "回程差（双向）"},
    Entry{"repeatability_sigma", "Repeatability σ", "重复性 σ"},
    Entry{"repeatability_range", "Repeatability range", "重复性极差"},
    Entry{"following_error", "Following error", "跟随误差"},
    Entry{"following_error_relative", "Relative following error", "相对跟随误差"},
    Entry{"phase_lag", "Phase lag", "相位滞后"},
    Entry{"readings_per_period", "Readings per period", "每周期采样数"},
    Entry{"mean_speed", "Mean speed", "平均速度"},
    Entry{"top_speed", "Top speed", "最高速度"},
    Entry{"current_peak", "Peak current", "峰值电流"},
    Entry{"current_mean", "Mean current", "平均电流"},
    Entry{"load_peak", "Peak load", "峰值负载"},
    Entry{"load_mean", "Mean load", "平均负载"},
    Entry{"voltage_min", "Lowest voltage", "最低电压"},
    Entry{"temperature_rise", "Temperature rise", "温升"},
    Entry{"temperature_max", "Highest temperature", "最高温度"},
    Entry{"moving_flag_errors", "Moving flag wrong", "运动标志错误"},
    Entry{"missed_targets", "Missed targets", "未到位次数"},
    Entry{"communication_errors", "Communication errors", "通信错误"},
    Entry{"alarms", "Alarms", "报警"},
};

constexpr std::array unitEntries{
    Entry{"step", "step", "步"},
    Entry{"step/s", "step/s", "步/s"},
    Entry{"legs", "legs", "程"},
};

/// By the bit of the status byte, which is the same in all maps that have one.
constexpr std::array alarmEntries{
    Entry{"voltage", "voltage", "过压欠压"},
    Entry{"sensor", "encoder", "传感器"},
    Entry{"temperature", "temperature", "过温"},
    Entry{"current", "overcurrent", "过流"},
    Entry{"angle", "angle", "角度"},
    Entry{"overload", "overload", "过载"},
};

template <std::size_t Count>
Text wordsOf(const std::array<Entry, Count>& entries, const QString& key)
{
    for (const Entry& entry : entries) {
        if (key == QLatin1String(entry.key))
            return both(entry.english, entry.chinese);
    }
    return {key, key};
}
} // namespace

const SweepTexts& sweepTexts()
{
    static const SweepTexts words = [] {
        SweepTexts all;
        fillHeading(all);
        fillTest(all);
        fillFigures(all);
        fillCharts(all);
        fillLegs(all);
        fillBus(all);
        return all;
    }();
    return words;
}

Text gradeLabel(record::Grade grade)
{
    switch (grade) {
    case record::Grade::Pass:
        return both("Passed", "合格");
    case record::Grade::Warn:
        return both("Passed with a warning", "合格，有警告");
    case record::Grade::Fail:
        return both("Failed", "不合格");
    case record::Grade::NotMeasured:
        break;
    }
    return both("No verdict", "无结论");
}

Text lineGradeLabel(record::Grade grade)
{
    switch (grade) {
    case record::Grade::Pass:
        return both("OK", "正常");
    case record::Grade::Warn:
        return both("Warning", "警告");
    case record::Grade::Fail:
        return both("Out of limits", "超限");
    case record::Grade::NotMeasured:
        break;
    }
    return sweepTexts().notMeasured;
}

QString gradeSign(record::Grade grade)
{
    switch (grade) {
    case record::Grade::Pass:
        return QStringLiteral("✔");
    case record::Grade::Warn:
        return QStringLiteral("⚠");
    case record::Grade::Fail:
        return QStringLiteral("✘");
    case record::Grade::NotMeasured:
        break;
    }
    return QStringLiteral("–");
}

QString gradeColor(record::Grade grade)
{
    switch (grade) {
    case record::Grade::Pass:
        return QStringLiteral("#1a7f37");
    case record::Grade::Warn:
        return QStringLiteral("#8a5a00");
    case record::Grade::Fail:
        return QStringLiteral("#b3261e");
    case record::Grade::NotMeasured:
        break;
    }
    return QStringLiteral("#57606a");
}

Text noVerdictReasonText(record::NoVerdictReason reason)
{
    switch (reason) {
    case record::NoVerdictReason::None:
        return {};
    case record::NoVerdictReason::Ended:
        return both("No verdict: the run ended before there was one.",
                    "无结论：运行在得出结论之前已结束。");
    case record::NoVerdictReason::TooShort:
        return both("No verdict: too short to judge. Run at least one whole cycle.",
                    "无结论：测试太短，无法判定。请至少运行一个完整循环。");
    case record::NoVerdictReason::TooFewReadings:
        return both("No verdict: fewer than 20 readings per period. Use a longer period, fewer "
                    "servos or a higher baud rate.",
                    "无结论：每周期采样数少于 20。请加长周期、减少舵机或提高波特率。");
    case record::NoVerdictReason::TooFast:
        return both("No verdict: the sine is faster than the servo is set to turn. Use a longer "
                    "period, a smaller range or a higher speed.",
                    "无结论：正弦快于舵机设定的速度。请加长周期、缩小范围或提高速度。");
    case record::NoVerdictReason::NoLimit:
        return both("No verdict: the limits do not say how well goals must be followed. Add limits "
                    "for the relative following error and the phase lag.",
                    "无结论：限值中没有跟随要求。请添加相对跟随误差和相位滞后的限值。");
    case record::NoVerdictReason::ShortMoves:
        return both("No verdict: the moves are too short for the tolerance, so a servo that stands "
                    "still would pass, too. Move at least three times the tolerance.",
                    "无结论：相对于到位允差，行程太短，静止不动的舵机也会合格。行程至少应为允差的"
                    "三倍。");
    case record::NoVerdictReason::SlowLink:
        return both(
            "No verdict: the servo lags too far behind, but the delay of the link may be the "
            "cause. Read at least 40 times per period: use a longer period, fewer servos or "
            "a faster adapter.",
            "无结论：滞后超出限值，但可能是通信延迟所致。每周期至少需采样 40 次：请加长周期、"
            "减少舵机或换用更快的适配器。");
    case record::NoVerdictReason::NotMeasured:
        break;
    }
    return both("No verdict: what this test is judged by was not measured in most moves. Allow "
                "more time for each move, or read faster: fewer servos, a quicker adapter.",
                "无结论：大多数行程未测得判定本测试所需的指标。请延长每次运动的时间，或加快读取："
                "减少舵机，更换更快的适配器。");
}

Text endText(record::SweepEnd end)
{
    switch (end) {
    case record::SweepEnd::Finished:
        return both("Finished as planned.", "按计划完成。");
    case record::SweepEnd::Stopped:
        return both("Stopped by the user before the end.", "被用户提前停止。");
    case record::SweepEnd::Emergency:
        return both("Ended by the emergency stop: torque off on the whole bus.",
                    "急停结束：总线上所有舵机扭矩关闭。");
    case record::SweepEnd::Alarm:
        return both("Ended early: a servo raised an alarm.", "提前结束：舵机报警。");
    case record::SweepEnd::Stall:
        return both("Ended early: a servo stood still away from its target.",
                    "提前结束：舵机停在目标之外（堵转）。");
    case record::SweepEnd::Failure:
        return both("Ended early: a limit was failed, and the test was to stop there.",
                    "提前结束：出现不合格项，按设置停止。");
    case record::SweepEnd::Refused:
        return both(
            "Ended early: a servo no longer took its goal; its limits or mode have changed.",
            "提前结束：舵机不再接受目标；其限位或模式已改变。");
    case record::SweepEnd::TorqueLost:
        return both("Ended early: a servo had no torque any more: it has restarted, or another "
                    "program switched it off. It was not switched on again.",
                    "提前结束：舵机已无扭矩输出（已重启，或被其他程序关闭），未再次使能。");
    case record::SweepEnd::ServoReplaced:
        return both("Ended early: another servo answers under this ID than the one being tested.",
                    "提前结束：应答此 ID 的已不是被测舵机，而是另一个舵机。");
    case record::SweepEnd::LinkLost:
        break;
    }
    return both("Ended early: the link was lost and did not come back.",
                "提前结束：连接丢失且未恢复。");
}

Text shapeText(record::SweepShape shape)
{
    switch (shape) {
    case record::SweepShape::Sweep:
        return both("there and back", "往返扫描");
    case record::SweepShape::Stairs:
        return both("stairs up and down", "步进往返");
    case record::SweepShape::BothSides:
        return both("the middle from both sides", "双向接近中点");
    case record::SweepShape::Random:
        return both("random targets", "随机目标");
    case record::SweepShape::Sine:
        return both("sine", "正弦");
    case record::SweepShape::Points:
        break;
    }
    return both("list of points", "目标点列表");
}

Text paceText(record::SweepPace pace)
{
    return pace == record::SweepPace::Delay
               ? both("delay from one goal to the next, arrived or not",
                      "延时（从一个目标到下一个）")
               : both("dwell after arrival", "到位后停留");
}

Text metricLabel(const QString& key)
{
    return wordsOf(metricEntries, key);
}

Text unitText(const QString& unit)
{
    return wordsOf(unitEntries, unit);
}

Text alarmBitsText(std::uint8_t alarms)
{
    Text words;
    for (std::size_t bit = 0; bit < 8; ++bit) {
        if (!(alarms & (1U << bit)))
            continue;
        const QString number = QString::number(bit);
        const Text one =
            bit < alarmEntries.size()
                ? both(alarmEntries[bit].english, alarmEntries[bit].chinese)
                : Text{QStringLiteral("bit ") + number, QStringLiteral("位 ") + number};
        words.en += (words.en.isEmpty() ? QString() : QStringLiteral(", ")) + one.en;
        words.zh += (words.zh.isEmpty() ? QString() : QStringLiteral("、")) + one.zh;
    }
    return words;
}
} // namespace report
