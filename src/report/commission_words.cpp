// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/commission_words.h"

#include <array>

namespace report {
namespace {
using record::CommissionTrouble;
using record::CommissionVerdict;

Text both(const char* english, const char* chinese)
{
    return {QString::fromUtf8(english), QString::fromUtf8(chinese)};
}

struct TroubleWords {
    const char* word;
    const char* english; ///< %1: the detail
    const char* chinese;
};
constexpr std::array troubleWords{
    TroubleWords{"not-writable", "what %1 is, is not known: nothing is written",
                 "%1 的参数表未知，不写入"},
    TroubleWords{"no-such-rate", "it cannot run %1 baud", "不支持波特率 %1"},
    TroubleWords{"no-such-id", "it cannot have ID %1", "不支持 ID %1"},
    TroubleWords{"no-centring", "%1 servos have no centring command", "%1 系列无校中指令"},
    TroubleWords{"other-model", "the template is of another model: %1", "模板来自其他型号：%1"},
    TroubleWords{"rows-left", "rows of the template left alone: %1", "模板中未写入的项：%1"},
    TroubleWords{"other-id", "it does not have the factory's ID, but %1", "不是出厂 ID，而是 %1"},
    TroubleWords{"no-id-left", "no ID is left for it", "ID 已用完"},
    TroubleWords{"already-done", "it is done already", "此舵机已设置完成"},
    TroubleWords{"by-hand", "set aside by hand", "手动剔除"},
    TroubleWords{"label-not-kept", "its label could not be kept in the history (%1)",
                 "标签未能写入历史记录（%1）"},
    TroubleWords{"rate-after-restart", "%1 baud acts after a restart only", "波特率 %1 重启后生效"},
    TroubleWords{"rate-differs", "its register says %1 baud", "寄存器中的波特率为 %1"},
    TroubleWords{"torque-was-on", "torque was on; it has been switched off",
                 "扭矩输出曾打开，已关闭"},
    TroubleWords{"row-mismatch", "%1 reads back differently", "%1 回读不一致"},
    TroubleWords{"row-refused", "%1 was refused", "%1 写入被拒绝"},
    TroubleWords{"row-not-sent", "%1 was not sent", "%1 未发送"},
    TroubleWords{"row-no-answer", "no answer while %1 was written", "写入 %1 时通信超时"},
    TroubleWords{"row-unknown", "what became of %1 is not known", "%1 的写入结果未知"},
    TroubleWords{"no-answer", "it did not answer", "通信超时"},
    TroubleWords{"garbled", "its answers were broken", "应答数据错误"},
    TroubleWords{"id-in-use", "the ID is in use: two servos are on the wire",
                 "ID 被占用：总线上有两个舵机"},
    TroubleWords{"several-servos", "two servos answer under this ID", "此 ID 下有两个舵机应答"},
    TroubleWords{"family-unclear", "its family is unclear: nothing is written",
                 "系列不明确，不写入"},
    TroubleWords{"unknown-model", "its firmware is not known: nothing is written",
                 "固件未知，不写入"},
    TroubleWords{"mismatch", "%1 does not hold the value of the template", "%1 与模板的数值不一致"},
    TroubleWords{"wrong-answer", "its answers did not fit the questions", "应答与请求不符"},
    TroubleWords{"line-busy", "the line never fell silent", "总线上数据不断"},
    TroubleWords{"refused", "it did not take what was written", "写入未生效"},
    TroubleWords{"lock-open", "its EPROM lock could not be proven closed", "无法确认 EPROM 已上锁"},
    TroubleWords{"identity-differs", "another servo answers now: %1", "应答的是其他舵机：%1"},
    TroubleWords{"out-of-range", "the value is out of its range: %1", "数值超出范围：%1"},
    TroubleWords{"not-supported", "not supported: %1", "不支持：%1"},
    TroubleWords{"unfinished-id", "the unfinished servo has ID %1", "未完成的舵机 ID 为 %1"},
    TroubleWords{"unfinished-ids", "the unfinished servo may have any of these IDs: %1",
                 "未完成的舵机可能使用以下任一 ID：%1"},
    TroubleWords{"unfinished-lock", "its EPROM lock was opened and has not been proven closed",
                 "其 EPROM 已解锁，无法确认已重新上锁"},
    TroubleWords{"uncertain", "what became of a write is not known", "写入结果未知"},
};

struct AlarmWords {
    const char* key;
    const char* english;
    const char* chinese;
};
constexpr std::array alarmWords{
    AlarmWords{"voltage", "voltage alarm", "过压欠压"},
    AlarmWords{"temperature", "temperature alarm", "过温"},
    AlarmWords{"overload", "overload alarm", "过载"},
    AlarmWords{"current", "overcurrent alarm", "过流"},
    AlarmWords{"sensor", "sensor alarm", "传感器故障"},
};

Text filled(const char* english, const char* chinese, const QString& detail)
{
    Text text = both(english, chinese);
    for (QString* half : {&text.en, &text.zh}) {
        if (half->contains(QLatin1String("%1")))
            *half = half->arg(detail);
    }
    return text;
}

struct VerdictWords {
    CommissionVerdict verdict;
    const char* english;
    const char* chinese;
    const char* sign;
};
constexpr std::array verdictWords{
    VerdictWords{CommissionVerdict::Good, "Good", "合格", "✔"},
    VerdictWords{CommissionVerdict::Remark, "Done, see remarks", "完成，有备注", "▲"},
    VerdictWords{CommissionVerdict::Failed, "Failed", "失败", "✖"},
    VerdictWords{CommissionVerdict::Aside, "Set aside", "未设置", "–"},
};

const VerdictWords& wordsOf(CommissionVerdict verdict)
{
    for (const VerdictWords& known : verdictWords) {
        if (known.verdict == verdict)
            return known;
    }
    return verdictWords.front();
}
} // namespace

Text commissionTroubleWords(const CommissionTrouble& trouble)
{
    if (trouble.word == QLatin1String("alarm")) {
        for (const AlarmWords& known : alarmWords) {
            if (trouble.detail == QLatin1String(known.key))
                return both(known.english, known.chinese);
        }
        return filled("alarm: %1", "报警：%1", trouble.detail);
    }
    for (const TroubleWords& known : troubleWords) {
        if (trouble.word == QLatin1String(known.word))
            return filled(known.english, known.chinese, trouble.detail);
    }
    const QString plain = trouble.detail.isEmpty()
                              ? trouble.word
                              : QStringLiteral("%1 (%2)").arg(trouble.word, trouble.detail);
    return {plain, plain};
}

Text commissionTroublesWords(const std::vector<CommissionTrouble>& troubles)
{
    QStringList english;
    QStringList chinese;
    for (const CommissionTrouble& trouble : troubles) {
        const Text words = commissionTroubleWords(trouble);
        english.append(words.en);
        chinese.append(words.zh);
    }
    return {english.join(QStringLiteral("; ")), chinese.join(QStringLiteral("；"))};
}

Text commissionVerdictWords(CommissionVerdict verdict)
{
    const VerdictWords& words = wordsOf(verdict);
    return both(words.english, words.chinese);
}

QString commissionVerdictSign(CommissionVerdict verdict)
{
    return QString::fromUtf8(wordsOf(verdict).sign);
}
} // namespace report
